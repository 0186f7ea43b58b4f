#include "relief/tracers.h"

#include <atomic>
#include <tuple>

#include "relief/block_work.h"
#include "relief/exact.h"
#include "relief/layers.h"
#include "relief/max_pyramid.h"
#include "relief/max_pyramid_paper.h"
#include "relief/offset.h"
#include "relief/offset_limited.h"

namespace relief {

namespace {

// The explicit list: one line a method.
using TracerTypes = std::tuple<  //
    ExactTracer,                 //
    MaxPyramidTracer,            //
    MaxPyramidPaperTracer,       //
    OffsetTracer,                //
    OffsetLimitedTracer,         //
    LayersTracer,                //
    LayersSecantTracer,          //
    LayersBisectionTracer>;

template <class T>
class TracerOf final : public Tracer {
  public:
    explicit TracerOf(T tracer) : tracer_(std::move(tracer)) {}

    const MethodDescription& description() const override { return descriptionOf<T>(); }
    const HeightField& field() const override { return tracer_.field(); }
    std::size_t bytes() const override { return tracer_.bytes(); }
    double stepBound(const ViewRay& ray) const override { return tracer_.stepBound(ray); }

    void trace(const RayBlock& rays, HitBlock& hits, NullSink&, Work& work) const override {
        hits.resize(rays.size());
        overBlock(rays.size(), work, [&](std::size_t first, std::size_t last) {
            NullSink sink;
            for (std::size_t i = first; i < last; ++i) hits.set(i, tracer_.trace(rays[i], sink));
        });
    }

    void trace(const RayBlock& rays, HitBlock& hits, BlockCounts& counts, Work& work) const override {
        hits.resize(rays.size());
        std::atomic<std::uint64_t> highest{0};
        overBlock(rays.size(), work, [&](std::size_t first, std::size_t last) {
            std::uint64_t here = 0;
            for (std::size_t i = first; i < last; ++i) {
                CountSink sink;
                hits.set(i, tracer_.trace(rays[i], sink));
                hits.steps[i] = sink.steps;
                hits.reads[i] = sink.reads;
                here += sink.highest ? 1 : 0;
            }
            highest += here;
        });
        counts.startHighest += highest;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            counts.steps += hits.steps[i];
            counts.reads += hits.reads[i];
        }
    }

    void trace(const RayBlock& rays, HitBlock& hits, StepLog& log, Work& work) const override {
        hits.resize(rays.size());
        LogSink sink;
        sink.steps = std::move(log.steps);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (i % kRayGrain == 0) work.throwIfStopped();
            sink.reads = 0;
            const std::size_t before = sink.steps.size();
            hits.set(i, tracer_.trace(rays[i], sink));
            hits.steps[i] = static_cast<std::uint32_t>(sink.steps.size() - before);
            hits.reads[i] = sink.reads;
            log.begin.push_back(sink.steps.size());
            log.reads.push_back(sink.reads);
        }
        log.steps = std::move(sink.steps);
    }

  private:
    T tracer_;
};

// Calls visit<T>() for each type of the list.
template <class Visit>
void forEachTracer(const Visit& visit) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (visit.template operator()<std::tuple_element_t<I, TracerTypes>>(), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<TracerTypes>>());
}

}  // namespace

const std::vector<MethodDescription>& tracerList() {
    static const std::vector<MethodDescription> list = [] {
        std::vector<MethodDescription> all;
        forEachTracer([&]<class T>() { all.push_back(descriptionOf<T>()); });
        return all;
    }();
    return list;
}

const MethodDescription& findTracer(const std::string& name) {
    std::string known;
    for (const MethodDescription& method : tracerList()) {
        if (method.name == name) return method;
        known += (known.empty() ? "" : ", ") + method.name;
    }
    throw InputError("--tracer",
                     Message(MessageId::UnknownName, {{"what", "tracer"}, {"name", name}, {"known", known}}));
}

std::unique_ptr<Tracer> makeTracer(const MethodChoice& choice, const HeightField& field, MapCache& cache, Work& work) {
    findTracer(choice.name);
    std::unique_ptr<Tracer> made;
    forEachTracer([&]<class T>() {
        if (made || descriptionOf<T>().name != choice.name) return;
        const auto options = parseOptions<typename T::Options>(choice.name, choice.options);
        made = std::make_unique<TracerOf<T>>(T::make(field, options, cache, work));
    });
    return made;
}

}  // namespace relief
