// All any-hit queries behind one face: is anything in the way of these segments? For shadows and back-tracing.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "relief/map_cache.h"
#include "relief/tracer.h"
#include "relief/visibility/any_ray.h"

namespace relief {

// A query made ready for one height field: immutable, shared by threads.
class AnyHitQuery {
  public:
    virtual ~AnyHitQuery() = default;
    AnyHitQuery() = default;
    AnyHitQuery(const AnyHitQuery&) = delete;
    AnyHitQuery& operator=(const AnyHitQuery&) = delete;

    virtual const MethodDescription& description() const = 0;
    virtual const HeightField& field() const = 0;
    // Decision records that this segment takes at most.
    virtual double stepBound(const AnyRay& ray) const = 0;

    // sights is resized; the same answers whatever the sink and the number of threads. Throws Cancelled.
    virtual void query(const AnyRayBlock& rays, VisibilityBlock& results, NullSink& sink, Work& work) const = 0;
    virtual void query(const AnyRayBlock& rays, VisibilityBlock& results, BlockCounts& sink, Work& work) const = 0;
    virtual void query(const AnyRayBlock& rays, VisibilityBlock& results, StepLog& sink, Work& work) const = 0;
};

// Every query there is. Only maps that are valid for any ray can serve one; others do not compile.
const std::vector<MethodDescription>& anyHitList();

// The fastest for many segments: in lanes by packed cones, or the max pyramid where those would be large (16 bytes a
// texel, above kMaxPackedTexels texels).
inline constexpr std::size_t kMaxPackedTexels = std::size_t{1} << 22;
MethodChoice visibilityChoice(const HeightField& field);

// Builds the maps it needs (from the cache if they are there). Throws InputError for unknown names, options, and
// methods whose maps hold for view rays only.
std::unique_ptr<AnyHitQuery> makeAnyHit(const MethodChoice& choice, const HeightField& field, MapCache& cache,
                                        Work& work);

}  // namespace relief
