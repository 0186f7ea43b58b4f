// Pyramids in space, as numbers: the texels of each level are slabs of their own size on the ground, 2^level texels a
// side, and all levels stand over the same ground, so far apart that the ray, drawn over each level at its height,
// passes none of the level above. Where the ray walked through the levels, only the slabs that it looked at and their
// neighbours under the same parent are there; else all of them. Frame: X = s, Y = -t (so that the picture is not
// mirrored), Z up, all in texels of the picture; pyramids stand side by side.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "panes/pyramid/pyramid_parts.h"
#include "panes/turntable.h"

namespace reliefui {

struct Slab {
    std::size_t part = 0;  // of the pyramids
    int level = 0;
    Box ground;  // texels (s, t), as far as it is shown
    double foot = 0;
    double top = 0;  // Z
    float value = 0;
};

// A texel that steps are about.
struct SlabMark {
    Box ground;
    double top = 0;
    std::size_t step = 0;  // the last one up to the chosen one; if there is none, the first one after it
    bool later = false;
    bool chosen = false;
};

// A stretch of the ray over one level, or, between two levels, straight up or down.
struct SlabStretch {
    Turntable::Place from;
    Turntable::Place to;
    Role role = Role::Ray;
    bool later = false;
};

class SlabTower {
  public:
    SlabTower() = default;
    // Refers to the parts.
    explicit SlabTower(const PyramidParts& parts);

    // From the ground up; empty: there is no pyramid.
    const std::vector<Slab>& slabs() const { return slabs_; }
    // The highest level that is drawn. Those above it, whose texels are about as wide as all that is shown, are one
    // empty frame over it, at level top() + 1.
    int top() const { return top_; }
    int levels() const { return levels_; }
    // Of which level the slabs on a level's place are: its own, or a coarser one where its own are too many.
    int drawnAs(std::size_t part, int level) const;
    double apart() const { return apart_; }    // from the foot of a level to that of the next, texels
    double factor() const { return factor_; }  // by which heights are multiplied, 1 or less
    // The horizontal direction, of length 1, in which the slabs are seen best: the ray runs from left to right, a
    // little away from the eye.
    Point seenAlong() const { return seenAlong_; }
    double foot(int level) const { return std::min(level, top_ + 1) * apart_; }
    double heightOver(int level, double height) const { return foot(level) + (height - low_) * thick_ * factor_; }
    Turntable::Place at(std::size_t part, Point texel, double z) const {
        return {texel.x + offsets_[part].x, offsets_[part].y - texel.y, z};
    }
    const Box& domain(std::size_t part) const { return blocksOf(part).front().domain; }

    // As of these steps.
    std::vector<SlabMark> marks(std::size_t part, std::size_t chosen) const;
    std::vector<SlabStretch> way(std::size_t part, std::size_t chosen) const;
    // Where the ray hits, over level 0.
    std::optional<Turntable::Place> end(std::size_t part) const;

    // The first slab that the line from one place to another meets, and the point of its ground; null: none.
    struct Meeting {
        const Slab* slab = nullptr;
        Point texel;
    };
    Meeting meeting(const Turntable::Place& from, const Turntable::Place& to) const;

  private:
    const PyramidPart& part(std::size_t n) const { return parts_->parts[n]; }
    const std::vector<LevelBlock>& blocksOf(std::size_t n) const { return part(n).picture.blocks; }
    // As steps are drawn: wrapped into what is shown.
    std::vector<Box> boxesOf(std::size_t n, const relief::Step& step) const;
    void addSlabs(std::size_t n, int level, const std::vector<Box>& open, bool all);
    void chooseScale(bool few);

    const PyramidParts* parts_ = nullptr;
    std::vector<Slab> slabs_;
    std::vector<Point> offsets_;
    int levels_ = 0;
    int top_ = 0;
    double thick_ = 1;  // of the relief, texels
    double low_ = 0;    // the height at the feet
    Point seenAlong_{-0.3, 0.95};
    double apart_ = 1;
    double factor_ = 1;
};

}  // namespace reliefui
