// Geometry of pyramids in space: the texels of each level are slabs of their own size, 2^level texels per side, and all
// levels stand above the same ground, at such distances that the ray, drawn over each level at its height, passes below
// the next one. If the ray walked through the levels, only the slabs it examined and their siblings under the same
// parent are present; otherwise all of them. Frame: X = s, Y = -t (so that the picture is not mirrored), Z up, in
// texels of the picture; several pyramids stand side by side.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "panes/pyramid/pyramid_parts.h"
#include "panes/turntable.h"

namespace reliefui {

struct Slab {
    std::size_t part = 0;  // index of the pyramid
    int level = 0;
    Box ground;  // visible part of the texel (s, t)
    double foot = 0;
    double top = 0;  // in Z
    float value = 0;
};

// A texel that steps concern.
struct SlabMark {
    Box ground;
    double top = 0;
    std::size_t step = 0;  // the last one up to the chosen step; if there is none, the first one after it
    bool later = false;
    bool chosen = false;
};

// A piece of the ray over one level, or a vertical one between two levels.
struct SlabStretch {
    Turntable::Place from;
    Turntable::Place to;
    Role role = Role::Ray;
    bool later = false;
};

class SlabTower {
  public:
    SlabTower() = default;
    // Keeps a reference to the parts.
    explicit SlabTower(const PyramidParts& parts);

    // From the ground upwards; empty if there is no pyramid.
    const std::vector<Slab>& slabs() const { return slabs_; }
    // The highest level drawn. Levels above it, whose texels are about as wide as the visible part, are drawn as one
    // empty frame at level top() + 1.
    int top() const { return top_; }
    int levels() const { return levels_; }
    // The level whose slabs are drawn at a level's place: itself, or a coarser one if it would have too many.
    int drawnAs(std::size_t part, int level) const;
    double apart() const { return apart_; }    // distance between the bottoms of two levels, in texels
    double factor() const { return factor_; }  // scale of the heights, at most 1
    // Horizontal viewing direction (unit length) that shows the slabs best: the ray runs from left to right and
    // slightly away from the viewer.
    Point viewDirection() const { return viewDirection_; }
    double foot(int level) const { return std::min(level, top_ + 1) * apart_; }
    double heightOver(int level, double height) const { return foot(level) + (height - low_) * thick_ * factor_; }
    Turntable::Place at(std::size_t part, Point texel, double z) const {
        return {texel.x + offsets_[part].x, offsets_[part].y - texel.y, z};
    }
    const Box& domain(std::size_t part) const { return blocksOf(part).front().domain; }

    // Marks and path up to, and faintly after, the step `chosen`.
    std::vector<SlabMark> marks(std::size_t part, std::size_t chosen) const;
    std::vector<SlabStretch> rayPath(std::size_t part, std::size_t chosen) const;
    // The ray's hit, above level 0.
    std::optional<Turntable::Place> end(std::size_t part) const;

    // The first slab that a line from one place to another intersects, and the point on its ground; null: none.
    struct Intersection {
        const Slab* slab = nullptr;
        Point texel;
    };
    Intersection intersect(const Turntable::Place& from, const Turntable::Place& to) const;

  private:
    const PyramidPart& part(std::size_t n) const { return parts_->parts[n]; }
    const std::vector<LevelBlock>& blocksOf(std::size_t n) const { return part(n).picture.blocks; }
    // Boxes of the step's texel, wrapped into the visible domain.
    std::vector<Box> boxesOf(std::size_t n, const relief::Step& step) const;
    void addSlabs(std::size_t n, int level, const std::vector<Box>& open, bool all);
    void chooseScale(bool few);

    const PyramidParts* parts_ = nullptr;
    std::vector<Slab> slabs_;
    std::vector<Point> offsets_;
    int levels_ = 0;
    int top_ = 0;
    double thick_ = 1;  // thickness of the relief in texels
    double low_ = 0;    // height at the slabs' bottoms
    Point viewDirection_{-0.3, 0.95};
    double apart_ = 1;
    double factor_ = 1;
};

}  // namespace reliefui
