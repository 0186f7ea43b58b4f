#include "workspace/layers.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/parallel.h"
#include "painting/style.h"
#include "rendering/display.h"

namespace reliefui {

namespace {

constexpr std::uint32_t kNothing = 0xff2b3038;  // where a layer has no value
constexpr std::size_t kMapSize = 256;

std::uint32_t packed(int r, int g, int b) {
    const auto byte = [](int v) { return static_cast<std::uint32_t>(std::clamp(v, 0, 255)); };
    return 0xff000000U | byte(r) << 16U | byte(g) << 8U | byte(b);
}

std::array<std::uint32_t, kMapSize> countColors() {
    std::array<std::uint32_t, kMapSize> colors{};
    const Style style;
    for (std::size_t i = 0; i < kMapSize; ++i) {
        const Rgba c = style.mapped(ColorMap::Count, static_cast<double>(i) / (kMapSize - 1));
        colors[i] = packed(c.r, c.g, c.b);
    }
    return colors;
}

template <class Color>
void eachPixel(QImage& image, const Color& color) {
    // Asked for once: writing through scanLine() from several threads would detach in each of them.
    auto* const first = reinterpret_cast<std::uint32_t*>(image.bits());
    const int width = image.width();
    relief::parallelFor(image.height(), [&](int y) {
        for (int x = 0; x < width; ++x) first[std::size_t(y) * std::size_t(width) + std::size_t(x)] = color(x, y);
    });
}

// value(x, y): NaN where there is none.
template <class Value>
void mapValues(LayerPicture& out, const Value& value) {
    static const std::array<std::uint32_t, kMapSize> colors = countColors();
    const double scale = out.high > out.low ? (kMapSize - 1) / (out.high - out.low) : 0;
    eachPixel(out.image, [&](int x, int y) {
        const double v = value(x, y);
        if (std::isnan(v)) return kNothing;
        return colors[static_cast<std::size_t>(std::clamp((v - out.low) * scale + 0.5, 0.0, kMapSize - 1.0))];
    });
}

void paintColor(LayerPicture& out, const relief::Frame& frame) {
    const auto pixels = frame.light->color.pixels();
    relief::toSrgb32(pixels, {reinterpret_cast<std::uint32_t*>(out.image.bits()), pixels.size()});
}

void paintSteps(LayerPicture& out, const relief::Frame& frame) {
    const auto& steps = frame.hits->hits.steps;
    out.high = steps.empty() ? 0 : *std::max_element(steps.begin(), steps.end());
    mapValues(out, [&](int x, int y) {
        const std::size_t i = frame.index(x, y);
        return frame.rays->polygon[i] == relief::kNoPolygon ? std::nan("") : static_cast<double>(steps[i]);
    });
}

void paintDepth(LayerPicture& out, const relief::Frame& frame) {
    std::vector<float> depths(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height));
    relief::parallelFor(frame.height, [&](int y) {
        for (int x = 0; x < frame.width; ++x) depths[frame.index(x, y)] = static_cast<float>(frame.depth(x, y));
    });
    bool any = false;
    for (const float d : depths) {
        if (std::isnan(d)) continue;
        out.low = any ? std::min<double>(out.low, d) : d;
        out.high = any ? std::max<double>(out.high, d) : d;
        any = true;
    }
    mapValues(out, [&](int x, int y) { return static_cast<double>(depths[frame.index(x, y)]); });
}

void paintNormals(LayerPicture& out, const relief::Frame& frame, const relief::FrameRequest& request) {
    eachPixel(out.image, [&](int x, int y) {
        const glm::vec3 n = frame.normal(x, y, request);
        if (n == glm::vec3(0)) return kNothing;
        const auto code = [](float v) { return static_cast<int>(std::lround(127.5F + 127.5F * v)); };
        return packed(code(n.x), code(n.y), code(n.z));
    });
}

void paintOutcomes(LayerPicture& out, const relief::Frame& frame, int hatch) {
    const auto& outcomes = frame.hits->hits.outcome;
    for (const relief::Outcome outcome : outcomes) ++out.outcomes[static_cast<std::size_t>(outcome)];
    eachPixel(out.image, [&](int x, int y) {
        const relief::Outcome outcome = outcomes[frame.index(x, y)];
        if (outcomeHatched(outcome, x, y, hatch)) return 0xffd8d8d8U;
        return kOutcomeColors[static_cast<std::size_t>(outcome)];
    });
}

void paintTexturePlaces(LayerPicture& out, const relief::Frame& frame, const relief::FrameRequest& request) {
    const relief::HitBlock& hits = frame.hits->hits;
    eachPixel(out.image, [&](int x, int y) {
        const std::size_t i = frame.index(x, y);
        if (hits.outcome[i] != relief::Outcome::Hit) return kNothing;
        const double u = hits.s[i] / request.field.width();
        const double v = hits.t[i] / request.field.height();
        const auto code = [](double w) { return static_cast<int>(255 * (w - std::floor(w))); };
        return packed(code(u), code(v), 64);
    });
}

void paintError(LayerPicture& out, const relief::Frame& frame, const relief::FrameRequest& request,
                relief::MapCache& maps, relief::Work& work, int hatch) {
    static const std::array<std::uint32_t, kMapSize> colors = countColors();
    auto error = std::make_shared<relief::ErrorLayer>(relief::errorAgainstExact(frame, request, maps, work));
    out.low = kLeastError;
    out.high = std::max(error->largest, 10 * kLeastError);
    eachPixel(out.image, [&](int x, int y) {
        const std::size_t i = frame.index(x, y);
        switch (error->kinds[i]) {
            case relief::ErrorKind::None:
                return kNothing;
            case relief::ErrorKind::Right:
                return kNoError;
            case relief::ErrorKind::Wrong:
                return wrongOutcomeMarked(x, y, hatch) ? 0xff000000U : kWrongOutcome;
            case relief::ErrorKind::Past:
                if (overshootHatched(x, y, hatch)) return kOvershoot;
                break;
            case relief::ErrorKind::Short:
                break;
        }
        const double share = kErrorFloor + (1 - kErrorFloor) * errorShare(out, static_cast<double>(error->texels[i]));
        return colors[static_cast<std::size_t>(share * (kMapSize - 1) + 0.5)];
    });
    out.error = std::move(error);
}

// Of a plane of the core's, in the order of the frame's pixels.
float planeValue(const relief::NamedPlane& plane, int x, int y) {
    return plane.plane(x, y);
}

void paintAnisotropy(LayerPicture& out, const relief::Frame& frame, const relief::FrameRequest& request,
                     relief::MapCache& maps, relief::Work& work) {
    static const std::array<std::uint32_t, kMapSize> colors = countColors();
    auto planes = std::make_shared<const std::vector<relief::NamedPlane>>(
        relief::layerPlanes(frame, request, {"footprint"}, maps, work));
    out.low = 1;
    out.high = 2;
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            const double ratio = anisotropy(*planes, x, y);
            if (std::isfinite(ratio)) out.high = std::max(out.high, std::min(ratio, kLargestAnisotropy));
        }
    }
    eachPixel(out.image, [&](int x, int y) {
        const double ratio = anisotropy(*planes, x, y);
        if (std::isnan(ratio)) return kNothing;
        return colors[static_cast<std::size_t>(errorShare(out, ratio) * (kMapSize - 1) + 0.5)];
    });
    out.planes = std::move(planes);
}

void paintHidden(LayerPicture& out, const relief::Frame& frame, const relief::FrameRequest& request,
                 relief::MapCache& maps, relief::Work& work) {
    out.applies = frame.filter && frame.filter->description().visible;
    if (!out.applies) {
        out.image.fill(kNothing);
        return;
    }
    auto planes = std::make_shared<const std::vector<relief::NamedPlane>>(
        relief::layerPlanes(frame, request, {"hidden"}, maps, work));
    const relief::NamedPlane& shares = planes->front();
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            out.high = std::max(out.high, static_cast<double>(planeValue(shares, x, y)));  // NaN is never larger
        }
    }
    mapValues(out, [&](int x, int y) { return static_cast<double>(planeValue(shares, x, y)); });
    out.planes = std::move(planes);
}

}  // namespace

double anisotropy(const std::vector<relief::NamedPlane>& planes, int x, int y) {
    const auto major = static_cast<double>(planeValue(planes[0], x, y));
    const auto minor = static_cast<double>(planeValue(planes[1], x, y));
    return minor > 0 ? major / minor : (std::isnan(major) ? major : std::numeric_limits<double>::infinity());
}

double errorShare(const LayerPicture& layer, double texels) {
    const double range = std::log(layer.high / layer.low);
    return range > 0 && texels > layer.low ? std::clamp(std::log(texels / layer.low) / range, 0.0, 1.0) : 0;
}

bool overshootHatched(int x, int y, int hatch) {
    // As wide a part of the picture at any size.
    return (x + y) % hatch < hatch / kHatch;
}

bool wrongOutcomeMarked(int x, int y, int hatch) {
    const int thick = hatch / kHatch;
    return (x + y) % hatch < thick || (((x - y) % hatch) + hatch) % hatch < thick;
}

bool outcomeHatched(relief::Outcome outcome, int x, int y, int hatch) {
    if (outcome == relief::Outcome::Miss) return overshootHatched(x, y, hatch);
    if (outcome == relief::Outcome::Limit) return wrongOutcomeMarked(x, y, hatch);
    return false;
}

LayerPicture makeLayer(Layer layer, const relief::Frame& frame, const relief::FrameRequest& request,
                       relief::MapCache& maps, relief::Work& work, double enlarged) {
    const int hatch = kHatch * std::max(1, static_cast<int>(std::lround(enlarged)));
    LayerPicture out;
    out.layer = layer;
    out.image = QImage(frame.width, frame.height, QImage::Format_RGB32);
    switch (layer) {
        case Layer::Color:
            paintColor(out, frame);
            break;
        case Layer::Steps:
            paintSteps(out, frame);
            break;
        case Layer::Error:
            paintError(out, frame, request, maps, work, hatch);
            break;
        case Layer::TexturePlace:
            paintTexturePlaces(out, frame, request);
            break;
        case Layer::Anisotropy:
            paintAnisotropy(out, frame, request, maps, work);
            break;
        case Layer::Hidden:
            paintHidden(out, frame, request, maps, work);
            break;
        case Layer::Outcome:
            paintOutcomes(out, frame, hatch);
            break;
        case Layer::Depth:
            paintDepth(out, frame);
            break;
        case Layer::Normals:
            paintNormals(out, frame, request);
            break;
    }
    return out;
}

}  // namespace reliefui
