#include "filtering/elliptical.h"

#include <algorithm>
#include <cassert>

namespace relief {

namespace {

// Bounds on the number of samples along each side of a pixel of kind Shape; between them, two samples per texel.
constexpr int kFewestPlaces = 12;
constexpr int kMostPlaces = 96;

int placesAlong(double texels) {
    return static_cast<int>(std::clamp(std::ceil(2 * texels), double{kFewestPlaces}, double{kMostPlaces}));
}

}  // namespace

EllipticalKernel::EllipticalKernel(std::shared_ptr<const ColorLevels> levels, Address address,
                                   const EllipticalSettings& settings)
    : levels_(std::move(levels)), address_(address), settings_(settings) {
    if (settings.source == WeightSource::Table) table_ = RadialTable(settings);
    if (settings.source == WeightSource::Map) map_ = WeightMap(settings);
}

Color EllipticalKernel::special(const LevelFootprint& f, const Jacobian& j, glm::dvec2 centre,
                                FootprintCounts& counts) const {
    switch (f.kind) {
        case FootprintKind::Top:
            ++counts.texels;
            return levels_->level(levels_->top())(0, 0);
        case FootprintKind::Shape:
            return shape(f, j, centre, counts);
        default:
            break;
    }
    ++counts.bilinear;
    counts.texels += 4;
    return levels_->bilinear(0, centre, address_);
}

Color EllipticalKernel::shape(const LevelFootprint& f, const Jacobian& j, glm::dvec2 centre,
                              FootprintCounts& counts) const {
    const double reach = settings_.model() == PixelModel::Crt ? settings_.radius : 0.5;
    // The pixel's own Jacobian or, if that is infinite, the clamped one.
    const bool finite = f.major == f.major && f.major <= 4.0 * std::max(levels_->width(), levels_->height());
    const Jacobian& seen = finite ? j : f.widened;
    const int across = placesAlong(2 * reach * std::hypot(seen.ux, seen.vx));
    const int down = placesAlong(2 * reach * std::hypot(seen.uy, seen.vy));
    glm::dvec3 sum(0);
    glm::dvec3 total(0);
    for (int y = 0; y < down; ++y) {
        const double dy = ((y + 0.5) / down * 2 - 1) * reach;
        for (int x = 0; x < across; ++x) {
            const double dx = ((x + 0.5) / across * 2 - 1) * reach;
            glm::dvec3 weight;
            for (int c = 0; c < 3; ++c) {
                weight[c] = pixelFactorAcross(settings_.model(), c, dx) * pixelFactorDown(settings_.model(), c, dy);
            }
            const glm::dvec2 place = centre + glm::dvec2(seen.ux * dx + seen.uy * dy, seen.vx * dx + seen.vy * dy);
            sum += weight * glm::dvec3(levels_->bilinear(0, place, address_));
            total += weight;
        }
    }
    counts.texels += std::int64_t{4} * across * down;
    return Color(sum / total);
}

Color EllipticalKernel::filter(const Jacobian& j, glm::dvec2 centre, FootprintCounts& counts, FootprintLog* log) const {
    if (!lanes_) return filterScalar(j, centre, counts, log);
    FilterBlock block;
    block.push({centre, j, {}, 0});
    Color color(0);
    std::uint8_t fallback = 0;
    lanes_->filter(block, {1, 1}, {&color, 1}, {&fallback, 1}, counts, log);
    if (fallback != 0) return filterScalar(j, centre, counts, log);
    if (log != nullptr) {
        log->footprint = footprint(j, centre);
        log->color = color;
    }
    return color;
}

void EllipticalKernel::filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors,
                              FootprintCounts& counts) const {
    assert(colors.size() <= block.size());
    std::vector<std::uint8_t> fallback(colors.size(), 1);
    if (lanes_) lanes_->filter(block, scale, colors, fallback, counts);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (fallback[i] == 0) continue;
        const FilterQuery query = block[i];
        colors[i] = filterScalar(scaled(query.jacobian, scale), query.place * scale, counts);
    }
}

Color EllipticalKernel::filterScalar(const Jacobian& j, glm::dvec2 centre, FootprintCounts& counts,
                                     FootprintLog* log) const {
    const LevelFootprint f = footprint(j, centre);
    Color color(0);
    if (log != nullptr) log->footprint = f;
    if (f.kind != FootprintKind::Ellipse) {
        color = special(f, j, centre, counts);
        if (log != nullptr) log->color = color;
        return color;
    }
    const ColorImage& image = levels_->level(f.level);
    const LevelAxis columns = across(f.level);
    const LevelAxis rows = down(f.level);
    const double toUnit = 1 / (f.ellipse.f * f.radius * f.radius);
    std::int64_t texels = 0;
    color = weighted(f, [&](const auto& weight) {
        glm::dvec3 sum(0);
        glm::dvec3 total(0);
        overEllipse(f, columns, rows, [&](int x, int y, double u, double v, float share) {
            const auto r2 = static_cast<float>(std::clamp(f.ellipse.form(u, v) * toUnit, 0.0, 1.0));
            const auto w = weight(u, v, r2) * share;
            sum += glm::dvec3(w * image(x, y));
            total += glm::dvec3(w);
            ++texels;
            if (log != nullptr) log->texels.push_back({x, y, f.level, u + f.centre.x, v + f.centre.y, Color(w)});
        });
        for (int c = 0; c < 3; ++c) {
            // The total is zero if the only table or map entry that is used is its last one, which may be 0.
            if (!(total[c] > 0)) {
                sum[c] = levels_->bilinear(f.level, {std::ldexp(f.centre.x, f.level), std::ldexp(f.centre.y, f.level)},
                                           address_)[c];
                total[c] = 1;
            }
        }
        return Color(sum / total);
    });
    ++counts.footprints;
    counts.texels += texels;
    if (log != nullptr) log->color = color;
    return color;
}

}  // namespace relief
