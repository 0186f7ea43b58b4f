// Tracers that trace blocks of segments, for `hybrid`.
#pragma once

#include <memory>
#include <vector>

#include "relief/map_cache.h"
#include "relief/tracer.h"

namespace relief {

class SegmentBlockTracer : public Tracer {
  public:
    // Sets the hits of the rays within their segments, one per ray: the results of traceSegment().
    virtual void traceSegments(const RayBlock& rays, const std::vector<Segment>& segments, HitBlock& hits) const = 0;
};

// makeTracer() with Form::Scalar.
std::unique_ptr<SegmentBlockTracer> makeSegmentTracer(const MethodChoice& choice, const HeightField& field,
                                                      MapCache& cache, Work& work);
// Returns true if traceSegments() of the method is in SIMD.
bool segmentsInSimd(const MethodChoice& choice);

}  // namespace relief
