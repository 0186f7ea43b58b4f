// The mean pyramid of a colour picture, in linear light, weighted by area at odd sizes, and bilinear and trilinear
// sampling of it.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "filtering/level_axis.h"
#include "relief/image.h"
#include "relief/work.h"

namespace relief {

// Level 0 is the picture itself (shared, not copied); each further level halves the size, rounded up, down to 1 x 1. A
// texel of level l covers the 2^l x 2^l texels of level 0 below it, clipped at the last row and column. Immutable after
// construction, so it may be shared by threads.
class ColorLevels {
  public:
    // Builds the levels in parallel over rows; the bits are the same for any number of threads. picture: not null, not
    // empty. Throws Cancelled.
    ColorLevels(std::shared_ptr<const ColorImage> picture, Work& work);

    int count() const { return static_cast<int>(above_.size()) + 1; }
    int top() const { return count() - 1; }
    int width() const { return picture_->width(); }
    int height() const { return picture_->height(); }
    const std::shared_ptr<const ColorImage>& picture() const { return picture_; }
    const ColorImage& level(int l) const { return l == 0 ? *picture_ : above_[static_cast<std::size_t>(l) - 1]; }
    LevelAxis across(int l, Address address) const { return LevelAxis::of(width(), l, address); }
    LevelAxis down(int l, Address address) const { return LevelAxis::of(height(), l, address); }

    // Samples one level bilinearly, between the true centres of its texels. place: (s, t) in texels of level 0,
    // unwrapped.
    Color bilinear(int l, glm::dvec2 place, Address address) const;
    // Interpolates between two levels. level: any real number; values outside [0, top()] are clamped.
    Color trilinear(double level, glm::dvec2 place, Address address) const;

  private:
    std::shared_ptr<const ColorImage> picture_;
    std::vector<ColorImage> above_;
};

}  // namespace relief
