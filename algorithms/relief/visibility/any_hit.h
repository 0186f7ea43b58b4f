// The common interface of all any-hit queries: does the surface block these segments? Used for shadows and for tracing
// footprints back to the viewer.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "relief/map_cache.h"
#include "relief/tracer.h"
#include "relief/visibility/any_ray.h"

namespace relief {

// A query prepared for one height field. Immutable; may be shared by threads.
class AnyHitQuery {
  public:
    virtual ~AnyHitQuery() = default;
    AnyHitQuery() = default;
    AnyHitQuery(const AnyHitQuery&) = delete;
    AnyHitQuery& operator=(const AnyHitQuery&) = delete;

    virtual const MethodDescription& description() const = 0;
    virtual const HeightField& field() const = 0;
    // Upper bound of the number of decision records for this segment.
    virtual double stepBound(const AnyRay& ray) const = 0;

    // Sets results to one entry per segment, in their order. The answers do not depend on the sink nor on the number of
    // threads. The version with NullSink is the fastest and may use SIMD. Throws Cancelled.
    virtual void query(const AnyRayBlock& rays, VisibilityBlock& results, NullSink& sink, Work& work) const = 0;
    virtual void query(const AnyRayBlock& rays, VisibilityBlock& results, BlockCounts& sink, Work& work) const = 0;
    virtual void query(const AnyRayBlock& rays, VisibilityBlock& results, StepLog& sink, Work& work) const = 0;
};

// The descriptions of all queries. Queries whose map is valid only for view rays do not compile.
const std::vector<MethodDescription>& anyHitList();

// The fastest query for many segments: packed cones with SIMD, or the max pyramid for maps above kMaxPackedTexels
// texels, since packed cones take 16 bytes per texel, and for maps that are read by tiles.
inline constexpr std::size_t kMaxPackedTexels = std::size_t{1} << 22;
MethodChoice visibilityChoice(const HeightField& field);

// Builds the maps that the query needs, or takes them from the cache. Throws InputError for unknown names and options,
// and for methods whose maps are valid only for view rays.
std::unique_ptr<AnyHitQuery> makeAnyHit(const MethodChoice& choice, const HeightField& field, MapCache& cache,
                                        Work& work);

}  // namespace relief
