// The hits of any exact method, traced by the SIMD walk through packed cones. A frame uses it when no step log is
// needed. All exact methods return the same bits, so the picture does not depend on the method that is chosen.
#pragma once

#include <memory>

#include "relief/methods/cone_rays.h"
#include "relief/tracer.h"

namespace relief {

class PackedConeHits {
  public:
    static constexpr const char* kMethod = "cone";  // whose walk it is
    // Number of texels above which the memory of four entries per texel does not pay.
    static constexpr std::size_t kMostTexels = std::size_t{1} << 22;
    // Number of rays per texel after which building the cones has paid: about 0.1 us per texel for building, about 0.03
    // us saved per ray.
    static constexpr std::size_t kRaysPerTexel = 3;

    PackedConeHits(const HeightField& field, std::shared_ptr<const PackedCones> cones);

    // As Tracer::trace() of `method`, which must be exact and of the same field. Rays flatter than the domain of
    // exactness are traced by `method` itself.
    void trace(const RayBlock& rays, HitBlock& hits, const Tracer& method, Work& work) const;

    const PackedCones& cones() const { return *cones_; }

  private:
    HeightField field_;
    std::shared_ptr<const PackedCones> cones_;
    FloatScene scene_;
};

}  // namespace relief
