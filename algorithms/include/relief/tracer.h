// A method prepared for one height field, with a batch interface; a single ray is traced as a block of one ray.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "relief/describe.h"
#include "relief/ray.h"
#include "relief/step_log.h"
#include "relief/work.h"

namespace relief {

// The step logs of a block: ray r has the steps [begin[r], begin[r + 1]).
struct StepLog {
    std::vector<Step> steps;
    std::vector<std::size_t> begin{0};
    std::vector<std::uint32_t> reads;

    std::size_t rays() const { return begin.size() - 1; }
};

// Counts of a whole block. The counts of each ray are in HitBlock::steps and HitBlock::reads.
struct BlockCounts {
    std::uint64_t steps = 0;
    std::uint64_t reads = 0;
    std::uint64_t startHighest = 0;  // rays that started at the highest height, so that no tracing was needed
};

class DisplacementMesh;
struct MaxPyramidMap;

// A method prepared for one height field. Immutable; may be used by several threads at once.
class Tracer {
  public:
    virtual ~Tracer() = default;
    Tracer() = default;
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    virtual const MethodDescription& description() const = 0;
    // The height field that the tracer was made for.
    virtual const HeightField& field() const = 0;
    // Returns the guarantee with the options in use; the method's description states the best one.
    virtual Guarantee guarantee() const { return description().guarantee; }
    // Returns the bytes of the maps in use, without the heights.
    virtual std::size_t bytes() const = 0;
    // Returns the implementation that trace() with a NullSink runs. Steps are always counted and logged by the
    // reference implementation.
    virtual Form form() const { return Form::Scalar; }
    // Returns the mesh that frames rasterise instead of tracing rays; null if rays are traced.
    virtual const DisplacementMesh* mesh() const { return nullptr; }
    // Returns an upper bound on the number of decision records of this ray.
    virtual double stepBound(const ViewRay& ray) const = 0;

    // Returns the pyramid that the tracer traverses above its base level; null if it traverses none.
    virtual std::shared_ptr<const MaxPyramidMap> pyramid() const { return nullptr; }
    virtual int baseLevel() const { return 0; }

    // Finds the first hit within an interval of the ray; Miss if there is none. Only for tracers in innerTracerNames().
    // Each segment adds at most segmentRecords() decision records to its share of the whole ray's.
    virtual Hit traceSegment(const ViewRay& ray, Segment segment, NullSink& sink) const = 0;
    virtual Hit traceSegment(const ViewRay& ray, Segment segment, CountSink& sink) const = 0;
    virtual Hit traceSegment(const ViewRay& ray, Segment segment, LogSink& sink) const = 0;
    virtual double segmentRecords() const = 0;

    // Traces the block; hits is resized to its size. All three overloads give identical bits in outcome, lambda, s and
    // t, for any number of threads. NullSink: nothing is counted. BlockCounts: sets steps and reads of hits, and adds
    // them to the totals in sink. StepLog: sets steps and reads of hits, and appends the records of all rays to sink.
    // Large blocks are divided among the work's threads, except for logs. Throws Cancelled.
    virtual void trace(const RayBlock& rays, HitBlock& hits, NullSink& sink, Work& work) const = 0;
    virtual void trace(const RayBlock& rays, HitBlock& hits, BlockCounts& sink, Work& work) const = 0;
    virtual void trace(const RayBlock& rays, HitBlock& hits, StepLog& sink, Work& work) const = 0;
};

}  // namespace relief
