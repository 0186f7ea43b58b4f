// A tracer that is wrong on purpose: it alters the results of another one.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "measuring/bench/measured_method.h"

namespace relief::test {

// Which overload of trace() was called: alterations may depend on the sink.
enum class Overload : std::uint8_t { Plain, Counting, Logging };

class AlteredTracer final : public Tracer {
  public:
    using Alter = std::function<void(const ViewRay&, Hit&, std::uint32_t& steps, Overload)>;

    AlteredTracer(std::unique_ptr<Tracer> inner, Alter alter, Guarantee guarantee)
        : inner_(std::move(inner)), alter_(std::move(alter)), guarantee_(guarantee) {}

    const MethodDescription& description() const override { return inner_->description(); }
    const HeightField& field() const override { return inner_->field(); }
    Guarantee guarantee() const override { return guarantee_; }
    std::size_t bytes() const override { return inner_->bytes(); }
    double stepBound(const ViewRay& ray) const override { return inner_->stepBound(ray); }

    Hit traceSegment(const ViewRay& ray, Segment segment, NullSink& sink) const override {
        return inner_->traceSegment(ray, segment, sink);
    }
    Hit traceSegment(const ViewRay& ray, Segment segment, CountSink& sink) const override {
        return inner_->traceSegment(ray, segment, sink);
    }
    Hit traceSegment(const ViewRay& ray, Segment segment, LogSink& sink) const override {
        return inner_->traceSegment(ray, segment, sink);
    }
    double segmentRecords() const override { return inner_->segmentRecords(); }

    void trace(const RayBlock& rays, HitBlock& hits, NullSink& sink, Work& work) const override {
        inner_->trace(rays, hits, sink, work);
        alter(rays, hits, Overload::Plain);
    }
    void trace(const RayBlock& rays, HitBlock& hits, BlockCounts& sink, Work& work) const override {
        inner_->trace(rays, hits, sink, work);
        alter(rays, hits, Overload::Counting);
    }
    void trace(const RayBlock& rays, HitBlock& hits, StepLog& sink, Work& work) const override {
        inner_->trace(rays, hits, sink, work);
        alter(rays, hits, Overload::Logging);
    }

  private:
    void alter(const RayBlock& rays, HitBlock& hits, Overload overload) const {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            Hit hit = hits[i];
            alter_(rays[i], hit, hits.steps[i], overload);
            hits.set(i, hit);
        }
    }

    std::unique_ptr<Tracer> inner_;
    Alter alter_;
    Guarantee guarantee_;
};

// A method that behaves as if it were listed under the name of `choice`.
inline MeasuredMethod altered(const MethodChoice& choice, AlteredTracer::Alter alter,
                              Guarantee guarantee = Guarantee::Exact) {
    MeasuredMethod method = measuredMethod(choice);
    method.make = [choice, alter = std::move(alter), guarantee](const HeightField& field, MapCache& cache,
                                                                Work& work) -> std::unique_ptr<Tracer> {
        return std::make_unique<AlteredTracer>(makeTracer(choice, field, cache, work), alter, guarantee);
    };
    return method;
}

}  // namespace relief::test
