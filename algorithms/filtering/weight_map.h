// Precomputed weights over the pixel: a table over r^2 for round pixels, a two-dimensional map for any.
//
// Source: [TEX] (maps of weights for the Gaussian pixel). The papers' pixel is a bell of base diameter 1 and volume 1,
// which corresponds to radius 1/2 here.
//
// The map has n x n cells over [-R, R]^2 pixels. Cell (i, j) holds the weight at its centre, zero beyond R for round
// pixels; lookup is by nearest cell. A texel's place in it, J^-1 (U, V), is linear in U and V, so it advances by
// constant steps along a texel row. Error bound for weights of at most 1: half a cell's diagonal times the steepest
// slope; mapError returns it for the Gaussian.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "filtering/elliptical_options.h"
#include "relief/image.h"

namespace relief {

// Weight as a function of r^2 in [0, R^2], by nearest entry.
class RadialTable {
  public:
    RadialTable() = default;
    RadialTable(const EllipticalSettings& settings);
    // r2 = r^2 / R^2 in [0, 1].
    float operator()(float r2) const { return weights_[static_cast<std::size_t>(r2 * scale_)]; }

  private:
    std::vector<float> weights_;
    float scale_ = 0;
};

// R, G, B weights over the pixel.
class WeightMap {
  public:
    WeightMap() = default;
    WeightMap(const EllipticalSettings& settings);
    int size() const { return weights_.width(); }
    const Image<glm::vec3>& weights() const { return weights_; }
    // (dx, dy): pixels from the centre, any value; 0 outside the map.
    glm::vec3 at(float dx, float dy) const {
        const float x = (dx + reach_) * scale_;
        const float y = (dy + reach_) * scale_;
        const auto n = static_cast<float>(weights_.width());
        if (!(x >= 0 && x < n && y >= 0 && y < n)) return glm::vec3(0);
        return weights_(static_cast<int>(x), static_cast<int>(y));
    }

  private:
    Image<glm::vec3> weights_;
    float reach_ = 1;
    float scale_ = 1;
};

// The weight of a round pixel at r pixels from its centre; 1 at the centre.
double radialWeight(const EllipticalSettings& settings, double r);
// Upper bound on the difference between a weight of the map and the formula, for these settings (Gaussian weights).
double mapError(const EllipticalSettings& settings);

}  // namespace relief
