// A method made ready for one height field, and its batch interface. The single ray is the one-lane instance of it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "relief/describe.h"
#include "relief/ray.h"
#include "relief/step_log.h"
#include "relief/work.h"

namespace relief {

// The logs of a block: ray r has the steps [begin[r], begin[r + 1]).
struct StepLog {
    std::vector<Step> steps;
    std::vector<std::size_t> begin{0};
    std::vector<std::uint32_t> reads;

    std::size_t rays() const { return begin.size() - 1; }
};

// Counts of a whole block, and of each ray in HitBlock::steps and ::reads.
struct BlockCounts {
    std::uint64_t steps = 0;
    std::uint64_t reads = 0;
    std::uint64_t startHighest = 0;  // rays whose start was the highest point: no tracing was needed
};

class DisplacementMesh;
struct MaxPyramidMap;

// A method made ready for one height field: immutable, shared by threads.
class Tracer {
  public:
    virtual ~Tracer() = default;
    Tracer() = default;
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    virtual const MethodDescription& description() const = 0;
    virtual const HeightField& field() const = 0;
    // What it promises with these options: a method's description says what it promises at best.
    virtual Guarantee guarantee() const { return description().guarantee; }
    // Memory of the maps it uses, beside the heights.
    virtual std::size_t bytes() const = 0;
    // What trace() into a NullSink runs. Steps are counted and logged by the reference in any case.
    virtual Form form() const { return Form::Scalar; }
    // What a frame rasterises instead of tracing; null: it traces.
    virtual const DisplacementMesh* mesh() const { return nullptr; }
    // Decision records that this ray takes at most.
    virtual double stepBound(const ViewRay& ray) const = 0;

    // The pyramid that it walks, over its base level; null if it walks none.
    virtual std::shared_ptr<const MaxPyramidMap> pyramid() const { return nullptr; }
    virtual int baseLevel() const { return 0; }

    // Whether the first hit lies within a stretch of the ray; Miss: nothing there. Only for innerTracerNames(). With
    // records, for each segment at most segmentRecords() more than the share of the whole ray.
    virtual Hit traceSegment(const ViewRay& ray, Segment segment, NullSink& sink) const = 0;
    virtual Hit traceSegment(const ViewRay& ray, Segment segment, CountSink& sink) const = 0;
    virtual Hit traceSegment(const ViewRay& ray, Segment segment, LogSink& sink) const = 0;
    virtual double segmentRecords() const = 0;

    // Traces the block; hits is resized. All three give identical bits in outcome, lambda, s, t, whatever the sink and
    // the number of threads. Big blocks run in parallel on the work's threads; throws Cancelled.
    virtual void trace(const RayBlock& rays, HitBlock& hits, NullSink& sink, Work& work) const = 0;
    virtual void trace(const RayBlock& rays, HitBlock& hits, BlockCounts& sink, Work& work) const = 0;
    virtual void trace(const RayBlock& rays, HitBlock& hits, StepLog& sink, Work& work) const = 0;
};

}  // namespace relief
