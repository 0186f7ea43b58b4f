// The hits of any exact method by packed cones in lanes: what a frame traces with when nobody asks for steps. All exact
// methods give the same bits, so whichever was chosen, the picture is its own.
#pragma once

#include <memory>

#include "relief/methods/cone_rays.h"
#include "relief/tracer.h"

namespace relief {

class PackedConeHits {
  public:
    static constexpr const char* kMethod = "cone";  // whose walk it is
    // Above this many texels four words a texel are not worth their memory.
    static constexpr std::size_t kMostTexels = std::size_t{1} << 22;
    // Rays after which the cones have paid for being built, a texel: some 0.1 us a texel against some 0.03 us a ray.
    static constexpr std::size_t kRaysPerTexel = 3;

    PackedConeHits(const HeightField& field, std::shared_ptr<const PackedCones> cones);

    // As Tracer::trace() of `method`, which is exact and of the same field; it traces rays that are flatter than
    // the domain of exactness.
    void trace(const RayBlock& rays, HitBlock& hits, const Tracer& method, Work& work) const;

    const PackedCones& cones() const { return *cones_; }

  private:
    HeightField field_;
    std::shared_ptr<const PackedCones> cones_;
    FloatScene scene_;
};

}  // namespace relief
