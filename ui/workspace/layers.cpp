#include "workspace/layers.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/parallel.h"
#include "painting/style.h"
#include "rendering/display.h"

namespace reliefui {

namespace {

constexpr std::uint32_t kNothing = 0xff2b3038;  // colour of pixels without a value
constexpr std::size_t kMapSize = 1024;

std::uint32_t packed(int r, int g, int b) {
    const auto byte = [](int v) { return static_cast<std::uint32_t>(std::clamp(v, 0, 255)); };
    return 0xff000000U | byte(r) << 16U | byte(g) << 8U | byte(b);
}

template <class Color>
void eachPixel(QImage& image, const Color& color) {
    // bits() is called once, because scanLine() would detach the image in each of several threads.
    auto* const first = reinterpret_cast<std::uint32_t*>(image.bits());
    const int width = image.width();
    relief::parallelFor(image.height(), [&](int y) {
        for (int x = 0; x < width; ++x) first[std::size_t(y) * std::size_t(width) + std::size_t(x)] = color(x, y);
    });
}

// value(x, y) returns NaN if the pixel has no value. counts(x, y): whether the value is part of the spread.
template <class Value, class Counts>
void takeValues(LayerPicture& out, const Value& value, const Counts& counts) {
    relief::FloatImage values(out.image.width(), out.image.height());
    relief::parallelFor(values.height(), [&](int y) {
        for (int x = 0; x < values.width(); ++x) values(x, y) = static_cast<float>(value(x, y));
    });
    ValueSpread spread;
    for (int y = 0; y < values.height(); ++y) {
        for (int x = 0; x < values.width(); ++x) {
            if (counts(x, y)) spread.add(values(x, y));
        }
    }
    spread.finish();
    out.values = std::make_shared<const relief::FloatImage>(std::move(values));
    out.spread = std::make_shared<const ValueSpread>(std::move(spread));
}

template <class Value>
void takeValues(LayerPicture& out, const Value& value) {
    takeValues(out, value, [](int, int) { return true; });
}

void paintColor(LayerPicture& out, const relief::Frame& frame) {
    const auto pixels = frame.light->color.pixels();
    relief::toSrgb32(pixels, {reinterpret_cast<std::uint32_t*>(out.image.bits()), pixels.size()});
}

void takeSteps(LayerPicture& out, const relief::Frame& frame) {
    const auto& steps = frame.hits->hits.steps;
    takeValues(out, [&](int x, int y) {
        const std::size_t i = frame.index(x, y);
        return frame.rays->polygon[i] == relief::kNoPolygon ? std::nan("") : static_cast<double>(steps[i]);
    });
    out.ends = {0, out.spread->largest()};
}

void takeDepth(LayerPicture& out, const relief::Frame& frame) {
    takeValues(out, [&](int x, int y) { return static_cast<double>(frame.depth(x, y)); });
    out.ends = {out.spread->least(), out.spread->largest()};
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

void takeError(LayerPicture& out, const relief::Frame& frame, const relief::FrameRequest& request,
               relief::MapCache& maps, relief::Work& work) {
    auto error = std::make_shared<relief::ErrorLayer>(relief::errorAgainstExact(frame, request, maps, work));
    const auto off = [&](relief::ErrorKind kind) {
        return kind == relief::ErrorKind::Short || kind == relief::ErrorKind::Past;
    };
    takeValues(
        out,
        [&](int x, int y) {
            const std::size_t i = frame.index(x, y);
            const relief::ErrorKind kind = error->kinds[i];
            const auto texels = static_cast<double>(error->texels[i]);
            if (off(kind)) return kind == relief::ErrorKind::Past ? texels : -texels;
            return kind == relief::ErrorKind::Right ? 0 : std::nan("");
        },
        [&](int x, int y) { return off(error->kinds[frame.index(x, y)]); });
    out.ends = {0, std::max(out.spread->largestMagnitude(), 10 * kLeastError), true, kLeastError};
    out.error = std::move(error);
}

// Colour of an error pixel without a numeric error; std::nullopt if it has one.
std::optional<std::uint32_t> markOfError(const LayerPicture& layer, int x, int y) {
    if (!layer.error) return std::nullopt;
    switch (layer.error->kinds[std::size_t(y) * std::size_t(layer.values->width()) + std::size_t(x)]) {
        case relief::ErrorKind::None:
            return kNothing;
        case relief::ErrorKind::Right:
            return kNoError;
        case relief::ErrorKind::Wrong:
            return wrongOutcomeMarked(x, y, layer.hatch) ? 0xff000000U : kWrongOutcome;
        case relief::ErrorKind::Past:
        case relief::ErrorKind::Short:
            break;
    }
    return std::nullopt;
}

// Value of one of the core's planes, whose order is that of the frame's pixels.
float planeValue(const relief::NamedPlane& plane, int x, int y) {
    return plane.plane(x, y);
}

void takeAnisotropy(LayerPicture& out, const relief::Frame& frame, const relief::FrameRequest& request,
                    relief::MapCache& maps, relief::Work& work) {
    auto planes = std::make_shared<const std::vector<relief::NamedPlane>>(
        relief::layerPlanes(frame, request, {"footprint"}, maps, work));
    takeValues(out, [&](int x, int y) {
        const double ratio = anisotropy(*planes, x, y);  // infinite if the minor axis is 0
        return std::isnan(ratio) ? ratio : std::min(ratio, kLargestAnisotropy);
    });
    out.ends = {1, std::clamp(out.spread->largest(), 2.0, kLargestAnisotropy)};
    out.planes = std::move(planes);
}

void takeHidden(LayerPicture& out, const relief::Frame& frame, const relief::FrameRequest& request,
                relief::MapCache& maps, relief::Work& work) {
    constexpr double kPercent = 100;
    out.applies = frame.filter && frame.filter->description().visible;
    if (!out.applies) {
        out.image.fill(kNothing);
        return;
    }
    auto planes = std::make_shared<const std::vector<relief::NamedPlane>>(
        relief::layerPlanes(frame, request, {"hidden"}, maps, work));
    const relief::NamedPlane& shares = planes->front();
    takeValues(out, [&](int x, int y) { return kPercent * static_cast<double>(planeValue(shares, x, y)); });
    out.ends = {0, out.spread->largest()};
    out.planes = std::move(planes);
}

}  // namespace

double anisotropy(const std::vector<relief::NamedPlane>& planes, int x, int y) {
    const auto major = static_cast<double>(planeValue(planes[0], x, y));
    const auto minor = static_cast<double>(planeValue(planes[1], x, y));
    return minor > 0 ? major / minor : (std::isnan(major) ? major : std::numeric_limits<double>::infinity());
}

bool wrongOutcomeMarked(int x, int y, int hatch) {
    const int thick = hatch / kHatch;
    return (x + y) % hatch < thick || (((x - y) % hatch) + hatch) % hatch < thick;
}

bool outcomeHatched(relief::Outcome outcome, int x, int y, int hatch) {
    if (outcome == relief::Outcome::Miss) return (x + y) % hatch < hatch / kHatch;
    if (outcome == relief::Outcome::Limit) return wrongOutcomeMarked(x, y, hatch);
    return false;
}

LayerPicture makeLayer(Layer layer, const relief::Frame& frame, const relief::FrameRequest& request,
                       relief::MapCache& maps, relief::Work& work, double enlarged) {
    LayerPicture out;
    out.hatch = kHatch * std::max(1, static_cast<int>(std::lround(enlarged)));
    out.layer = layer;
    out.image = QImage(frame.width, frame.height, QImage::Format_RGB32);
    switch (layer) {
        case Layer::Color:
            paintColor(out, frame);
            break;
        case Layer::Steps:
            takeSteps(out, frame);
            break;
        case Layer::Error:
            takeError(out, frame, request, maps, work);
            break;
        case Layer::TexturePlace:
            paintTexturePlaces(out, frame, request);
            break;
        case Layer::Anisotropy:
            takeAnisotropy(out, frame, request, maps, work);
            break;
        case Layer::Hidden:
            takeHidden(out, frame, request, maps, work);
            break;
        case Layer::Outcome:
            paintOutcomes(out, frame, out.hatch);
            break;
        case Layer::Depth:
            takeDepth(out, frame);
            break;
        case Layer::Normals:
            paintNormals(out, frame, request);
            break;
    }
    if (const auto of = rangeOf(layer)) colorLayer(out, standardRange(*of));
    return out;
}

std::optional<RangeOf> rangeOf(Layer layer) {
    switch (layer) {
        case Layer::Steps:
            return RangeOf::Steps;
        case Layer::Error:
            return RangeOf::Error;
        case Layer::Depth:
            return RangeOf::Depth;
        case Layer::Anisotropy:
            return RangeOf::Anisotropy;
        case Layer::Hidden:
            return RangeOf::Hidden;
        default:
            return std::nullopt;
    }
}

ColorMap colorMapOf(Layer layer) {
    return layer == Layer::Error ? ColorMap::Signed : ColorMap::Count;
}

void colorLayer(LayerPicture& layer, const ColorRange& range) {
    layer.range = range;
    if (!layer.values) return;
    layer.scale = colorScale(range, *layer.spread, layer.ends);
    const auto code = [](Rgba c) { return packed(c.r, c.g, c.b); };
    const ColorMap map = colorMapOf(layer.layer);
    std::array<std::uint32_t, kMapSize> colors{};
    const Style style;  // the theme does not matter: these maps are the same in both
    for (std::size_t i = 0; i < kMapSize; ++i) {
        colors[i] = code(style.mapped(map, static_cast<double>(i) / (kMapSize - 1)));
    }
    const std::uint32_t under = code(Style::under(map));
    layer.image = QImage(layer.values->width(), layer.values->height(), QImage::Format_RGB32);
    eachPixel(layer.image, [&](int x, int y) {
        if (const auto mark = markOfError(layer, x, y)) return *mark;
        const auto value = static_cast<double>((*layer.values)(x, y));
        if (std::isnan(value)) return kNothing;
        if (layer.scale.under(value)) return under;
        const double place = std::clamp(layer.scale.place(value), 0.0, 1.0);
        return colors[static_cast<std::size_t>(place * (kMapSize - 1) + 0.5)];
    });
}

}  // namespace reliefui
