// A height map with a meaning: how it is read between texels, what lies outside, how thick the slab is.
#pragma once

#include <cassert>
#include <memory>
#include <utility>

#include "relief/addressing.h"
#include "relief/image.h"

namespace relief {

// Bilinear: C0, over texel centres. Columns: each texel a box with vertical walls (what the papers draw).
enum class Surface : std::uint8_t { Bilinear, Columns };

// An immutable value: copies share the heights. Heights in [0, 1]; at least 1 x 1.
class HeightField {
  public:
    HeightField(std::shared_ptr<const FloatImage> heights, Surface surface = Surface::Bilinear,
                Address address = Address::Repeat, double reliefDepth = 0.1)
        : heights_(std::move(heights)), surface_(surface), address_(address), reliefDepth_(reliefDepth) {
        assert(heights_ && !heights_->empty());
    }

    const FloatImage& heights() const { return *heights_; }
    const std::shared_ptr<const FloatImage>& sharedHeights() const { return heights_; }
    int width() const { return heights_->width(); }
    int height() const { return heights_->height(); }
    Surface surface() const { return surface_; }
    Address address() const { return address_; }
    // Thickness of the slab in units of the texture's width; `slabTexels` in texels.
    double reliefDepth() const { return reliefDepth_; }
    double slabTexels() const { return reliefDepth_ * width(); }

    // Height of texel (i, j), any integers, addressed.
    float texel(std::int64_t i, std::int64_t j) const {
        return (*heights_)(addressIndex(i, width(), address_), addressIndex(j, height(), address_));
    }
    // Height of the surface at (s, t), texels; under border, outside values are those of the rim.
    double at(double s, double t) const;
    // Slope (dh/ds, dh/dt) of the surface at (s, t), per texel: of the patch that holds the point (bilinear), or by
    // central differences of the texels beside (columns, whose tops are flat but should not be lit flat).
    std::pair<double, double> slope(double s, double t) const;

  private:
    std::shared_ptr<const FloatImage> heights_;
    Surface surface_;
    Address address_;
    double reliefDepth_;
};

}  // namespace relief
