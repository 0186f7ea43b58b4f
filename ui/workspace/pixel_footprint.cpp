#include "workspace/pixel_footprint.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "filtering/filter_block.h"
#include "rendering/lighting.h"
#include "rendering/point_texels.h"
#include "rendering/supersample.h"

namespace reliefui {

namespace {

using relief::FootprintKind;
using relief::FootprintTexel;
using relief::LevelAxis;

// Limit for individual texels: a footprint at the horizon contains millions if
// the filter always uses level 0.
constexpr std::int64_t kMostListed = 200000;
// In texels of the level; larger circles are not drawn.
constexpr double kLargestCircle = 1e6;

bool finite(const relief::Jacobian& j) {
    const double most = std::max({std::abs(j.ux), std::abs(j.vx), std::abs(j.uy), std::abs(j.vy)});
    return most < kLargestCircle;  // also false for NaN
}

LevelAxis axisOf(int size, int level, const relief::FrameRequest& request) {
    return LevelAxis::of(size, level, request.field.address());
}

relief::SampledTexture textureOf(const relief::FrameRequest& request, const relief::ColorImage& picture) {
    return {picture.width(), picture.height(), request.field.address()};
}

// Adds the texels of a point sample, for filters that do not log their texels.
// weight: of the whole sample.
void addPoint(PixelFootprint& out, const relief::FrameRequest& request, const relief::ColorImage& picture,
              const relief::Jacobian& j, glm::dvec2 place, const relief::Color& weight = relief::Color(1)) {
    relief::addPointTexels(out.log.texels, request, textureOf(request, picture), out.filter.name, out.level(), j, place,
                           weight);
}

// Moves each sample to the centre of its texel, in the periodic copy that was
// sampled, and merges samples of the same texel into one with the sum of their
// weights, separately for visible and hidden ones. The result is ordered by
// rows.
void joinTexels(PixelFootprint& out, const relief::FrameRequest& request, const relief::ColorImage& picture) {
    std::vector<FootprintTexel>& texels = out.log.texels;
    const auto snapped = [](const LevelAxis& axis, int i, double x) {
        if (axis.address == relief::Address::Repeat || (x >= 0 && x <= axis.extent))
            return relief::unwrappedCentre(axis, i, x);
        // With other address modes the outermost texel continues beyond the border.
        return axis.centre(i) + std::round(x - axis.centre(i));
    };
    for (FootprintTexel& texel : texels) {
        const int l = texel.level;
        const int down = l - out.level();
        texel.u = std::ldexp(snapped(axisOf(picture.width(), l, request), texel.i, std::ldexp(texel.u, -down)), down);
        texel.v = std::ldexp(snapped(axisOf(picture.height(), l, request), texel.j, std::ldexp(texel.v, -down)), down);
    }
    const auto name = [](const FootprintTexel& t) { return std::tuple(t.level, t.v, t.u, t.hidden); };
    std::stable_sort(texels.begin(), texels.end(),
                     [&](const FootprintTexel& a, const FootprintTexel& b) { return name(a) < name(b); });
    std::vector<FootprintTexel> joined;
    for (const FootprintTexel& texel : texels) {
        if (joined.empty() || name(joined.back()) != name(texel)) {
            joined.push_back(texel);
        } else {
            joined.back().weight += texel.weight;
            joined.back().tested = joined.back().tested || texel.tested;
        }
    }
    texels = std::move(joined);
}

void addNeighbours(PixelFootprint& out, const relief::Frame& frame, const relief::FrameRequest& request,
                   const relief::VisiblePolygons& visible, int x, int y, glm::dvec2 perField, relief::Work& work) {
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const bool inside = x + dx >= 0 && y + dy >= 0 && x + dx < frame.width && y + dy < frame.height;
            if ((dx == 0 && dy == 0) || !inside) continue;
            const auto query = relief::filterQuery(frame, request, visible, x + dx, y + dy);
            if (!query) continue;
            PixelCircle circle;
            circle.jacobian = scaled(query->jacobian, perField);
            circle.centre = query->place * perField;
            circle.sharesSide = dx == 0 || dy == 0;
            if (frame.filter && frame.filter->description().ellipse && out.listed) {
                relief::FootprintLog log;
                relief::FootprintCounts counts;
                frame.filter->color(*query, counts, work, &log);
                if (log.footprint.kind == FootprintKind::Ellipse) {
                    const double size = std::ldexp(1.0, log.footprint.level);
                    circle.jacobian = scaled(log.footprint.widened, {size, size});
                    circle.radius = log.footprint.radius;
                }
            }
            if (finite(circle.jacobian)) out.neighbours.push_back(circle);
        }
    }
}

void sumWeights(PixelFootprint& out) {
    double hidden = 0;
    const FootprintTexel* before = nullptr;
    for (const FootprintTexel& texel : out.log.texels) {
        // The hidden part of a texel follows its visible part.
        const auto place = [](const FootprintTexel& t) { return std::tuple(t.level, t.v, t.u); };
        if (before == nullptr || place(*before) != place(texel)) ++out.texelCount;
        before = &texel;
        const double weight = PixelFootprint::weightOf(texel);
        (texel.hidden ? hidden : out.greatest) = std::max(texel.hidden ? hidden : out.greatest, weight);
        if (!texel.hidden) out.weightSum += weight;
    }
    if (!(out.greatest > 0)) out.greatest = hidden;
}

}  // namespace

bool FilteredPicture::tooLarge(const relief::FrameRequest& request) {
    constexpr std::size_t kMostGrey = std::size_t{1} << 24;
    return !request.color && (request.field.tiles() != nullptr || request.field.texels() > kMostGrey);
}

void FilteredPicture::use(const relief::FrameRequest& request) {
    const std::shared_ptr<const relief::FloatImage> grey = request.color ? nullptr : request.field.sharedHeights();
    if (request.color ? picture_ == request.color : picture_ && greyOf_ == grey) return;
    greyOf_ = grey;
    levels_.reset();
    if (request.color) {
        picture_ = request.color;
        return;
    }
    const relief::FloatImage& heights = *grey;
    auto picture = std::make_shared<relief::ColorImage>(heights.width(), heights.height());
    std::transform(heights.pixels().begin(), heights.pixels().end(), picture->pixels().begin(),
                   [](float h) { return relief::heightGrey(h); });
    picture_ = std::move(picture);
}

std::shared_ptr<const relief::ColorImage> FilteredPicture::level(int l, relief::Work& work) {
    if (l == 0) return picture_;
    if (!levels_) levels_ = std::make_shared<const relief::ColorLevels>(picture_, work);
    return {levels_, &levels_->level(std::min(l, levels_->top()))};
}

std::shared_ptr<const PixelFootprint> pixelFootprint(const relief::Frame& frame, const relief::FrameRequest& request,
                                                     const relief::Tracer& tracer, int x, int y, double scale,
                                                     FilteredPicture& picture, relief::Work& work) {
    const relief::VisiblePolygons visible = frame.visible(request);
    if (FilteredPicture::tooLarge(request)) return nullptr;
    auto query = relief::filterQuery(frame, request, visible, x, y);
    if (!query) return nullptr;
    picture.use(request);
    const relief::ColorImage& colors = *picture.picture();
    const glm::dvec2 perField{static_cast<double>(colors.width()) / request.field.width(),
                              static_cast<double>(colors.height()) / request.field.height()};
    auto out = std::make_shared<PixelFootprint>();
    out->behind = relief::pixelCoefficients(query->view->texelFromScreen, x + 0.5, y + 0.5);
    query->jacobian = scaled(query->jacobian, {scale, scale});
    const relief::Jacobian j = scaled(query->jacobian, perField);
    const glm::dvec2 place = query->place * perField;

    out->filter = request.filter;
    out->weighing = relief::ellipticalSettings(request.filter);
    out->log.footprint.kind = FootprintKind::Bilinear;
    out->log.footprint.centre = place;
    if (frame.filter) {
        frame.filter->color(*query, out->counts, work);
        out->listed = out->counts.texels <= kMostListed;
        relief::FootprintCounts same;
        if (out->listed) frame.filter->color(*query, same, work, &out->log);
    }
    const relief::LevelFootprint& f = out->log.footprint;
    const double shrink = std::ldexp(1.0, -f.level);
    const relief::Jacobian& own = f.kind == FootprintKind::Ellipse ? f.seen : j;
    out->seen = scaled(own, {shrink, shrink});
    out->bounded = finite(out->seen);
    out->colors = picture.level(f.level, work);
    out->across = axisOf(colors.width(), f.level, request);
    out->down = axisOf(colors.height(), f.level, request);
    out->perHeight = perField * shrink;
    const relief::SemiAxes<double> axes = relief::ellipseOf(own).semiAxes();
    out->log.footprint.major = axes.major;
    out->log.footprint.minor = axes.minor;
    const bool unlogged = out->log.texels.empty() && !out->log.allHidden;
    if (f.kind == FootprintKind::Top && unlogged) {
        out->log.footprint.centre = {out->across.extent / 2, out->down.extent / 2};
        out->log.texels.push_back({0, 0, f.level, f.centre.x, f.centre.y, relief::Color(1)});
    } else if (f.kind == FootprintKind::Top) {
        // The filter logs around a placeholder centre, because this footprint has
        // none; moved to the hit.
        const glm::dvec2 shift = place * shrink - f.centre;
        for (FootprintTexel& texel : out->log.texels) texel.u += shift.x, texel.v += shift.y;
        out->log.footprint.centre = place * shrink;
    } else if (request.filter.name == relief::kSupersample) {
        for (const relief::PixelSample& sample : relief::pixelSamples(request, tracer, x, y, work)) {
            const glm::dvec2 at = sample.place * perField;
            addPoint(*out, request, colors, j, at, sample.share);
            out->rays.push_back({at, PixelFootprint::meanOf(sample.share)});
        }
    } else if (f.kind == FootprintKind::Bilinear && unlogged && out->listed) {
        addPoint(*out, request, colors, j, f.level == 0 ? f.centre : place);
    }
    if (f.kind == FootprintKind::Top) out->bounded = false;
    if (out->log.allHidden) {
        // Everything is hidden: the filter samples the colour at the hit instead.
        relief::addBilinearTexels(out->log.texels, textureOf(request, colors), f.centre * std::ldexp(1.0, f.level), 0,
                                  f.level, relief::Color(1));
    }
    joinTexels(*out, request, colors);
    sumWeights(*out);
    if (scale == 1) addNeighbours(*out, frame, request, visible, x, y, perField, work);
    return out;
}

}  // namespace reliefui
