// A height map with its interpretation: interpolation between texels, addressing outside the picture, and thickness of
// the slab.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "relief/addressing.h"
#include "relief/image.h"

namespace relief {

// The interpolated surface. Bilinear: continuous, interpolates between texel centres. Columns: each texel is a box with
// vertical walls (as drawn in the papers).
enum class Surface : std::uint8_t { Bilinear, Columns };

class TiledHeights;

// An immutable value whose copies share the heights. Heights are in [0, 1]; the map is at least 1 x 1. It is either an
// image in memory or, for maps larger than memory, a file that is read tile by tile.
class HeightField {
  public:
    // heights: not null and not empty. reliefDepth: thickness of the slab in texture widths.
    HeightField(std::shared_ptr<const FloatImage> heights, Surface surface = Surface::Bilinear,
                Address address = Address::Repeat, double reliefDepth = 0.1)
        : heights_(std::move(heights)), surface_(surface), address_(address), reliefDepth_(reliefDepth) {
        assert(heights_ && !heights_->empty());
        width_ = heights_->width(), height_ = heights_->height();
    }
    // tiles: not null.
    HeightField(std::shared_ptr<const TiledHeights> tiles, Surface surface = Surface::Bilinear,
                Address address = Address::Repeat, double reliefDepth = 0.1);

    // The image in memory. A field that is read by tiles throws InputError, which says that all heights are needed.
    const FloatImage& heights() const { return *sharedHeights(); }
    const std::shared_ptr<const FloatImage>& sharedHeights() const {
        if (!heights_) [[unlikely]]
            refuseTiles();
        return heights_;
    }
    // The file that is read by tiles; null for an image in memory.
    const TiledHeights* tiles() const { return tiles_.get(); }
    const std::shared_ptr<const TiledHeights>& sharedTiles() const { return tiles_; }
    // The object with the heights, whichever it is: for keys and comparisons.
    std::shared_ptr<const void> identity() const {
        return heights_ ? std::shared_ptr<const void>(heights_) : std::shared_ptr<const void>(tiles_);
    }
    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t texels() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }
    Surface surface() const { return surface_; }
    Address address() const { return address_; }
    // Returns the thickness of the slab in units of the texture's width; slabTexels() returns it in texels.
    double reliefDepth() const { return reliefDepth_; }
    double slabTexels() const { return reliefDepth_ * width(); }

    // Returns the height of texel (i, j), any integers, with the field's addressing.
    float texel(std::int64_t i, std::int64_t j) const {
        const int x = addressIndex(i, width_, address_), y = addressIndex(j, height_, address_);
        return heights_ ? (*heights_)(x, y) : tileTexel(x, y);
    }
    // Returns the height of the surface at (s, t), texels. Under border addressing, points outside the picture have the
    // heights of its edge.
    double at(double s, double t) const;
    // Returns the slope (dh/ds, dh/dt) of the surface at (s, t), heights per texel: for bilinear, that of the patch
    // that contains the point; for columns, central differences of the neighbouring texels, so that their flat tops are
    // not shaded as flat.
    std::pair<double, double> slope(double s, double t) const;

  private:
    [[noreturn]] void refuseTiles() const;
    float tileTexel(int x, int y) const;

    std::shared_ptr<const FloatImage> heights_;
    std::shared_ptr<const TiledHeights> tiles_;
    int width_ = 0;
    int height_ = 0;
    Surface surface_;
    Address address_;
    double reliefDepth_;
};

}  // namespace relief
