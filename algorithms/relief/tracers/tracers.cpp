#include "relief/tracers.h"

#include <algorithm>
#include <atomic>
#include <cassert>

#include "base/for_each_type.h"
#include "images/tiled_heights.h"
#include "relief/block_work.h"
#include "relief/methods/lane_fallback.h"
#include "relief/tracers/form_note.h"
#include "relief/tracers/map_choice.h"
#include "relief/tracers/segment_blocks.h"
#include "relief/tracers/tile_methods.h"
#include "relief/tracers/tracer_types.h"

namespace relief {

namespace {

// Methods that can trace within segments.
template <class T>
concept SegmentTracer = requires(const T& tracer, NullSink& sink) {
    tracer.traceSegment(ViewRay{}, Segment{}, sink);
};
template <class T>
concept PyramidTracer = requires(const T& tracer) {
    tracer.pyramidWalk();
};

template <class T>
concept SimdTracer = requires(const T& tracer, const RayBlock& rays, HitBlock& hits) {
    tracer.traceSimd(rays, std::size_t{}, std::size_t{}, hits);
};

template <class T>
concept SimdSegmentTracer = requires(const T& tracer, const RayBlock& rays, HitBlock& hits) {
    tracer.traceSegmentsSimd(rays, std::vector<Segment>{}, hits);
};

// The form that runs with these options if the caller leaves the choice to the method.
template <class T>
Form formWith(const typename T::Options& options) {
    if constexpr (!SimdTracer<T>) return Form::Scalar;
    if constexpr (requires { T::simdWith(options); }) return T::simdWith(options) ? Form::Simd : Form::Scalar;
    return SimdTracer<T> ? Form::Simd : Form::Scalar;
}

template <class T>
class TracerOf final : public SegmentBlockTracer {
  public:
    TracerOf(T tracer, Form form) : tracer_(std::move(tracer)), form_(form) {
        // The SIMD version's map may be missing: for a map from a file, or a picture too large for it.
        if constexpr (requires { tracer_.hasSimdMap(); }) {
            if (!tracer_.hasSimdMap()) form_ = Form::Scalar;
        }
    }

    Form form() const override { return form_; }

    const MethodDescription& description() const override { return descriptionOf<T>(); }
    const HeightField& field() const override { return tracer_.field(); }
    std::size_t bytes() const override { return tracer_.bytes(); }
    const DisplacementMesh* mesh() const override {
        if constexpr (requires { tracer_.mesh(); }) return tracer_.mesh();
        return nullptr;
    }
    double stepBound(const ViewRay& ray) const override { return tracer_.stepBound(ray); }
    Guarantee guarantee() const override {
        if constexpr (requires { tracer_.guarantee(); }) return tracer_.guarantee();
        return description().guarantee;
    }
    std::shared_ptr<const MaxPyramidMap> pyramid() const override {
        if constexpr (PyramidTracer<T>) return tracer_.pyramidWalk().map();
        return nullptr;
    }
    int baseLevel() const override {
        if constexpr (PyramidTracer<T>) return tracer_.pyramidWalk().baseLevel();
        return 0;
    }

    Hit traceSegment(const ViewRay& ray, Segment segment, NullSink& sink) const override {
        return within(ray, segment, sink);
    }
    Hit traceSegment(const ViewRay& ray, Segment segment, CountSink& sink) const override {
        return within(ray, segment, sink);
    }
    Hit traceSegment(const ViewRay& ray, Segment segment, LogSink& sink) const override {
        return within(ray, segment, sink);
    }
    void traceSegments(const RayBlock& rays, const std::vector<Segment>& segments, HitBlock& hits) const override {
        hits.resize(rays.size());
        std::vector<std::size_t> left;
        if constexpr (SimdSegmentTracer<T>) {
            left = tracer_.traceSegmentsSimd(rays, segments, hits);
        } else {
            left = allRays(0, rays.size());
        }
        NullSink sink;
        for (const std::size_t i : left) hits.set(i, within(rays[i], segments[i], sink));
    }
    double segmentRecords() const override {
        if constexpr (SegmentTracer<T>) return tracer_.segmentRecords();
        return 0;
    }

    void trace(const RayBlock& rays, HitBlock& hits, NullSink&, Work& work) const override {
        hits.resize(rays.size());
        overBlock(rays.size(), work, [&](std::size_t first, std::size_t last) {
            if constexpr (SimdTracer<T>) {
                if (form_ == Form::Simd) return tracer_.traceSimd(rays, first, last, hits);
            }
            NullSink sink;
            for (std::size_t i = first; i < last; ++i) hits.set(i, tracer_.trace(rays[i], sink));
        });
        requireHeights(field());
    }

    void trace(const RayBlock& rays, HitBlock& hits, BlockCounts& counts, Work& work) const override {
        hits.resize(rays.size());
        countBlock(rays.size(), hits, counts, work,
                   [&](std::size_t i, CountSink& sink) { hits.set(i, tracer_.trace(rays[i], sink)); });
        requireHeights(field());
    }

    void trace(const RayBlock& rays, HitBlock& hits, StepLog& log, Work& work) const override {
        hits.resize(rays.size());
        logBlock(rays.size(), hits, log, work,
                 [&](std::size_t i, LogSink& sink) { hits.set(i, tracer_.trace(rays[i], sink)); });
        requireHeights(field());
    }

  private:
    template <class Sink>
    Hit within(const ViewRay& ray, Segment segment, Sink& sink) const {
        if constexpr (SegmentTracer<T>) return tracer_.traceSegment(ray, segment, sink);
        assert(false && "this method does not work inside segments");
        return Hit::none(Outcome::Limit);
    }

    T tracer_;
    Form form_;
};

}  // namespace

std::vector<std::string> innerTracerNames() {
    std::vector<std::string> names;
    forEachType<TracerTypes>([&]<class T>() {
        if constexpr (SegmentTracer<T>) names.push_back(T::describe().name);
    });
    return names;
}

const std::vector<MethodDescription>& tracerList() {
    static const std::vector<MethodDescription> list = [] {
        std::vector<MethodDescription> all;
        forEachType<TracerTypes>([&]<class T>() { all.push_back(descriptionOf<T>()); });
        return all;
    }();
    return list;
}

const MethodDescription& findTracer(const std::string& name, const std::string& subject) {
    for (const MethodDescription& method : tracerList()) {
        if (method.name == name) return method;
    }
    throw InputError(subject, unknownName({"what", MessageId::WordTracer}, name, namesOf(tracerList())));
}

std::vector<ChoiceOption> choiceOptions(const MethodChoice& choice) {
    const MethodDescription& method = findTracer(choice.name);
    std::vector<ChoiceOption> all;
    for (const OptionDescription& option : method.options) {
        all.push_back({option, method.defaults.at(option.name)});
        if (option.kind != OptionKind::Method) continue;
        const auto given = choice.options.find(option.name);
        const std::string name = given == choice.options.end() ? method.defaults.at(option.name) : given->second;
        const std::vector<std::string> names = option.choices;
        if (std::find(names.begin(), names.end(), name) == names.end()) continue;
        for (ChoiceOption inner : choiceOptions({name, {}})) {
            inner.description.name = std::string(kInnerPrefix) + inner.description.name;
            all.push_back(std::move(inner));
        }
    }
    return all;
}

bool supports(const MethodChoice& choice, Surface surface, Address address) {
    const MethodDescription& method = findTracer(choice.name);
    const auto has = [](const auto& all, auto value) { return std::find(all.begin(), all.end(), value) != all.end(); };
    if (!has(method.surfaces, surface) || !has(method.addresses, address)) return false;
    // With another map the method serves the addressing modes of the tracer that the map is made for.
    const auto map = choice.options.find(std::string(kMapOption));
    if (map != choice.options.end() && has(method.otherMaps, map->second)) {
        for (const MethodDescription& other : tracerList()) {
            if (has(other.maps, map->second) && !has(other.addresses, address)) return false;
        }
    }
    for (const OptionDescription& option : method.options) {
        if (option.kind != OptionKind::Method) continue;
        const auto given = choice.options.find(option.name);
        const std::string inner = given == choice.options.end() ? method.defaults.at(option.name) : given->second;
        MethodChoice nested{inner, {}};
        for (const auto& [name, value] : choice.options) {
            if (name.starts_with(kInnerPrefix)) nested.options[name.substr(kInnerPrefix.size())] = value;
        }
        if (has(option.choices, inner) && !supports(nested, surface, address)) return false;
    }
    return true;
}

void checkMethod(const MethodChoice& choice, const std::string& subject) {
    findTracer(choice.name, subject);  // throws
    const std::vector<ChoiceOption> options = choiceOptions(choice);
    for (const auto& [name, text] : choice.options) {
        std::string known;
        const OptionDescription* found = nullptr;
        for (const ChoiceOption& option : options) {
            known += (known.empty() ? "" : ", ") + option.description.name;
            if (option.description.name == name) found = &option.description;
        }
        if (found == nullptr) {
            throw InputError(subject, unknownName({"what", Message(MessageId::WordOptionOf, {{"method", choice.name}})},
                                                  name, known));
        }
        checkOption(*found, text, subject);
    }
    forEachType<TracerTypes>([&]<class T>() {
        using Options = typename T::Options;
        if constexpr (requires(const Options& all) { all.check(subject); }) {
            if (descriptionOf<T>().name != choice.name) return;
            parseOptions<Options>(choice.name, choice.options, subject).check(subject);
        }
    });
    if (const auto inner = innerMethod(choice)) checkMethod(*inner, subject);
}

bool segmentsInSimd(const MethodChoice& choice) {
    bool simd = false;
    forEachType<TracerTypes>([&]<class T>() {
        if (descriptionOf<T>().name != choice.name) return;
        simd = SimdSegmentTracer<T>;
        if constexpr (requires { &T::segmentsInSimd; }) {
            simd = T::segmentsInSimd(parseOptions<typename T::Options>(choice.name, choice.options));
        }
    });
    return simd;
}

Form methodForm(const MethodChoice& choice) {
    checkMethod(choice, {});
    Form form = Form::Scalar;
    forEachType<TracerTypes>([&]<class T>() {
        if (descriptionOf<T>().name != choice.name) return;
        form = formWith<T>(parseOptions<typename T::Options>(choice.name, choice.options));
    });
    return form;
}

std::string formNote(const std::string& name) {
    findTracer(name);  // throws
    std::string note;
    forEachType<TracerTypes>([&]<class T>() {
        if constexpr (requires { T::formNote(); }) {
            if (descriptionOf<T>().name == name) note = T::formNote();
        }
    });
    return note;
}

void requireHeights(const HeightField& field) {
    if (field.tiles() != nullptr) field.tiles()->requireWhole();
}

bool tracesTiles(const MethodChoice& choice) {
    const auto base = choice.options.find(std::string(kBaseOption));
    return findTracer(choice.name).tiled && (base == choice.options.end() || base->second == "0");
}

void requireTiles(const MethodChoice& choice, const TiledHeights& tiles) {
    if (tracesTiles(choice)) return;
    std::vector<std::string> names;
    for (const MethodDescription& one : tracerList()) {
        if (one.tiled) names.push_back(one.name);
    }
    const std::string subject =
        findTracer(choice.name).tiled ? choice.name + " " + std::string(kBaseOption) : choice.name;
    throw InputError(tiles.path(), Message(MessageId::TiledMethod, {{"method", subject}, {"known", commaList(names)}}));
}

namespace {

std::unique_ptr<SegmentBlockTracer> madeTracer(const MethodChoice& choice, const HeightField& field, MapCache& cache,
                                               Work& work, Form form) {
    checkMethod(choice, {});
    if (field.tiles() != nullptr) requireTiles(choice, *field.tiles());
    std::unique_ptr<SegmentBlockTracer> made;
    forEachType<TracerTypes>([&]<class T>() {
        if (made || descriptionOf<T>().name != choice.name) return;
        const auto options = parseOptions<typename T::Options>(choice.name, choice.options);
        const Form chosen = form == Form::Simd ? formWith<T>(options) : Form::Scalar;
        if constexpr (requires { T::make(field, options, cache, work, chosen); }) {
            made = std::make_unique<TracerOf<T>>(T::make(field, options, cache, work, chosen), chosen);
        } else {
            made = std::make_unique<TracerOf<T>>(T::make(field, options, cache, work), chosen);
        }
    });
    return made;
}

}  // namespace

std::unique_ptr<Tracer> makeTracer(const MethodChoice& choice, const HeightField& field, MapCache& cache, Work& work,
                                   Form form) {
    return madeTracer(choice, field, cache, work, form);
}

std::unique_ptr<SegmentBlockTracer> makeSegmentTracer(const MethodChoice& choice, const HeightField& field,
                                                      MapCache& cache, Work& work) {
    return madeTracer(choice, field, cache, work, Form::Scalar);
}

}  // namespace relief
