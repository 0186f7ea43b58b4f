// Finds rays that need no search because all heights within their reach are equal, or differ by less than a given
// bound.
//
// Reach: rays meet no height above the map's highest, so a ray is followed from that height down to the lowest; the
// heights under this stretch give tighter bounds, and the step is repeated once. Frame and units: ray.h.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "filtering/height_bounds.h"
#include "relief/methods/exact.h"
#include "relief/ray.h"

namespace relief {

// Lowest and highest heights over blocks of texels, at most kGroundBlocks along a side, which takes a few megabytes for
// any map.
inline constexpr int kGroundBlocks = 1024;
std::shared_ptr<const HeightBoundsMap> groundBounds(const HeightField& field, Work& work);

enum class Ground : std::uint8_t { Search, Flat, LittleParallax };

class FlatGround {
  public:
    // flat: whether rays over equal heights are detected; their hits have the bits of an exact tracer. bound: largest
    // hit error, in texels, allowed to avoid a search; 0: no error allowed.
    FlatGround(HeightField field, std::shared_ptr<const HeightBoundsMap> bounds, bool flat, double bound);

    // Returns true if no block of the map is uniform enough for any ray.
    bool never() const { return never_; }
    // Returns the lowest and highest heights that these rays (indices into the block) can meet before or at their hits;
    // std::nullopt if a ray may leave the picture under border addressing, or is too grazing for exact arithmetic.
    std::optional<HeightBounds> reach(const RayBlock& rays, std::span<const std::size_t> which) const;
    // Returns which treatment these rays need, given the heights that they can reach.
    Ground ground(const RayBlock& rays, std::span<const std::size_t> which, const HeightBounds& reached) const;
    // flatHit: the hit of a ray over ground of uniform height, with the bits of an exact tracer. middleHit: the hit
    // with the mean of the lowest and highest reachable height.
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

// Returns the largest error of middleHit(), in texels, as hit errors are measured (error_layer.h). run: length of (a,
// b), texels.
inline double parallaxError(double run, const HeightBounds& reached) {
    return 0.5 * (reached.high - reached.low) * std::max(1.0, run);
}

}  // namespace relief
