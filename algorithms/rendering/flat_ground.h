// Rays that need no search, because the heights within their reach are all equal, or differ by less than matters.
//
// Reach: rays meet no height above the map's highest, so they are followed from there to its lowest; the heights under
// that stretch bound it anew, twice. Frame and units: ray.h.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "filtering/height_bounds.h"
#include "relief/methods/exact.h"
#include "relief/ray.h"

namespace relief {

// Lowest and highest heights over blocks of texels, at most kGroundBlocks along a side: a few megabytes for any map.
inline constexpr int kGroundBlocks = 1024;
std::shared_ptr<const HeightBoundsMap> groundBounds(const HeightField& field, Work& work);

enum class Ground : std::uint8_t { Search, Flat, LittleParallax };

class FlatGround {
  public:
    // flat: whether equal heights are looked for; they give the bits of an exact tracer. bound: texels, 0: none.
    FlatGround(HeightField field, std::shared_ptr<const HeightBoundsMap> bounds, bool flat, double bound);

    // No block of the map is even enough for any ray.
    bool never() const { return never_; }
    // The lowest and highest heights that these rays (indices into the block) can meet before or where they hit;
    // nothing where a ray may leave the picture under border, or is too flat.
    std::optional<HeightBounds> reach(const RayBlock& rays, std::span<const std::size_t> which) const;
    // What these rays need, of the heights that they reach.
    Ground ground(const RayBlock& rays, std::span<const std::size_t> which, const HeightBounds& reached) const;
    // The hit of a ray over ground of this height (Flat: equal bits to tracers that are exact), or half way between.
    Hit flatHit(const ViewRay& ray, double height) const;
    static Hit middleHit(const ViewRay& ray, const HeightBounds& reached) {
        return Hit::at(ray, 1 - 0.5 * (reached.low + reached.high));
    }

  private:
    HeightField field_;
    std::shared_ptr<const HeightBoundsMap> bounds_;
    ExactTracer leaf_;
    bool flat_;
    double bound_;
    HeightBounds all_;
    bool never_;
};

// By how many texels, at most, the height half way is wrong: as errors of hits are measured.
inline double parallaxError(double run, const HeightBounds& reached) {
    return 0.5 * (reached.high - reached.low) * std::max(1.0, run);
}

}  // namespace relief
