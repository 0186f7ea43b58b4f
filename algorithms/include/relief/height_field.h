// A height map with its interpretation: interpolation between texels, addressing outside the picture, and thickness of
// the slab.
#pragma once

#include <cassert>
#include <memory>
#include <utility>

#include "relief/addressing.h"
#include "relief/image.h"

namespace relief {

// The interpolated surface. Bilinear: continuous, interpolates between texel centres. Columns: each texel is a box with
// vertical walls (as drawn in the papers).
enum class Surface : std::uint8_t { Bilinear, Columns };

// An immutable value whose copies share the heights. Heights are in [0, 1]; the map is at least 1 x 1.
class HeightField {
  public:
    // heights: not null and not empty. reliefDepth: thickness of the slab in texture widths.
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
    // Returns the thickness of the slab in units of the texture's width; slabTexels() returns it in texels.
    double reliefDepth() const { return reliefDepth_; }
    double slabTexels() const { return reliefDepth_ * width(); }

    // Returns the height of texel (i, j), any integers, with the field's addressing.
    float texel(std::int64_t i, std::int64_t j) const {
        return (*heights_)(addressIndex(i, width(), address_), addressIndex(j, height(), address_));
    }
    // Returns the height of the surface at (s, t), texels. Under border addressing, points outside the picture have the
    // heights of its edge.
    double at(double s, double t) const;
    // Returns the slope (dh/ds, dh/dt) of the surface at (s, t), heights per texel: for bilinear, that of the patch
    // that contains the point; for columns, central differences of the neighbouring texels, so that their flat tops are
    // not shaded as flat.
    std::pair<double, double> slope(double s, double t) const;

  private:
    std::shared_ptr<const FloatImage> heights_;
    Surface surface_;
    Address address_;
    double reliefDepth_;
};

}  // namespace relief
