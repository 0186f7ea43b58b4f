// Anisotropic filtering: the weighted mean of all texels in the ellipse of the pixel. [TEX]; Heckbert 1989.
//
//     colour = sum w(i, j) share(j) share(i) texel(i, j) / sum w(i, j) share(j) share(i)
//
// over the texels (i, j) of the chosen level whose centres lie in the ellipse of radius R pixels. For each texel row
// the ends of the span are solved from the quadratic form, so only texels inside are visited.
#pragma once

#include <cmath>

#include "filtering/elliptical_lanes.h"
#include "filtering/footprint_log.h"
#include "filtering/level_footprint.h"
#include "filtering/weight_map.h"

namespace relief {

// The weight functions. U, V: offset from the centre in texels of the level; r2 = r^2 / R^2 in [0, 1].
struct UniformWeight {
    float operator()(double, double, float) const { return 1; }
};
struct GaussianWeight {
    float exponent;  // -R^2 / (2 sigma^2)
    float operator()(double, double, float r2) const { return std::exp(exponent * r2); }
};
struct TableWeight {
    const RadialTable& table;
    float operator()(double, double, float r2) const { return table(r2); }
};
// Ignores the projection of the pixel.
struct TexelDistanceWeight {
    float operator()(double u, double v, float) const { return static_cast<float>(1 / (1 + std::hypot(u, v))); }
};
struct MapWeight {
    const WeightMap& map;
    PixelFromTexel toPixel;
    glm::vec3 operator()(double u, double v, float) const {
        return map.at(static_cast<float>(toPixel.dx(u, v)), static_cast<float>(toPixel.dy(u, v)));
    }
};
// The weights of a round pixel are equal in all channels, so one channel of the map is enough.
struct RoundMapWeight {
    const WeightMap& map;
    PixelFromTexel toPixel;
    float operator()(double u, double v, float) const {
        return map.at(static_cast<float>(toPixel.dx(u, v)), static_cast<float>(toPixel.dy(u, v))).x;
    }
};

// Calls visit(i, j, u, v, share) for every texel of the level whose centre lies in the ellipse, row by row. u, v:
// offset of the texel's centre from the footprint's; share: the fraction of a whole texel that it covers.
template <class Visit>
void overEllipse(const LevelFootprint& f, const LevelAxis& across, const LevelAxis& down, const Visit& visit) {
    const double height = f.ellipse.halfExtents(f.radius).v;
    down.over(f.centre.y - height, f.centre.y + height, [&](int j, double y, float rowShare) {
        const double v = y - f.centre.y;
        const Span<double> span = f.ellipse.rowSpan(v, f.radius);
        if (span.empty()) return;
        across.over(f.centre.x + span.begin, f.centre.x + span.end,
                    [&](int i, double x, float share) { visit(i, j, x - f.centre.x, v, share * rowShare); });
    });
}

// Calls body with the weight function that the settings select.
template <class Body>
auto withWeights(const EllipticalSettings& settings, const RadialTable& table, const WeightMap& map,
                 const LevelFootprint& f, const Body& body) {
    if (settings.weights == WeightKind::TexelDistance) return body(TexelDistanceWeight{});
    if (settings.shaped()) return body(MapWeight{map, pixelFromTexel(f.widened)});
    switch (settings.source) {
        case WeightSource::Table:
            return body(TableWeight{table});
        case WeightSource::Map:
            return body(RoundMapWeight{map, pixelFromTexel(f.widened)});
        case WeightSource::Direct:
            break;
    }
    if (settings.weights == WeightKind::Uniform) return body(UniformWeight{});
    const double ratio = settings.radius / settings.sigma;
    return body(GaussianWeight{static_cast<float>(-0.5 * ratio * ratio)});
}

// The picture, the settings and what is precomputed from them. Const functions may be called from several threads.
class EllipticalKernel {
  public:
    EllipticalKernel(std::shared_ptr<const ColorLevels> levels, Address address, const EllipticalSettings& settings);

    const ColorLevels& levels() const { return *levels_; }
    Address address() const { return address_; }
    const EllipticalSettings& settings() const { return settings_; }
    // Filters by SIMD from now on, blocks and single pixels, wherever the SIMD version supports them.
    void setLanes(std::shared_ptr<const EllipticalLanes> lanes) { lanes_ = std::move(lanes); }
    const std::shared_ptr<const ColorLevels>& sharedLevels() const { return levels_; }
    // Null if only the reference is used.
    std::shared_ptr<const LaneLevels> laneLevels() const { return lanes_ ? lanes_->levels() : nullptr; }
    LevelAxis across(int l) const { return levels_->across(l, address_); }
    LevelAxis down(int l) const { return levels_->down(l, address_); }

    LevelFootprint footprint(const Jacobian& j, glm::dvec2 centre) const {
        return levelFootprint(j, centre, settings_, *levels_, address_);
    }
    // Filters one pixel. centre: texels of level 0. log: may be null.
    Color filter(const Jacobian& j, glm::dvec2 centre, FootprintCounts& counts, FootprintLog* log = nullptr) const;
    // Filters the first colors.size() pixels of the block, with the same bits as one by one. scale: texels of level 0
    // per texel of the block's places.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts) const;
    // The reference: one pixel in double, with any footprint and weights. SIMD version: elliptical_lanes.h.
    Color filterScalar(const Jacobian& j, glm::dvec2 centre, FootprintCounts& counts,
                       FootprintLog* log = nullptr) const;
    // Colour of a footprint whose kind is not Ellipse: Bilinear, Shape or Top.
    Color special(const LevelFootprint& f, const Jacobian& j, glm::dvec2 centre, FootprintCounts& counts) const;

    template <class Body>
    auto weighted(const LevelFootprint& f, const Body& body) const {
        return withWeights(settings_, table_, map_, f, body);
    }

  private:
    Color shape(const LevelFootprint& f, const Jacobian& j, glm::dvec2 centre, FootprintCounts& counts) const;

    std::shared_ptr<const ColorLevels> levels_;
    Address address_;
    EllipticalSettings settings_;
    RadialTable table_;
    WeightMap map_;
    std::shared_ptr<const EllipticalLanes> lanes_;
};

}  // namespace relief
