#include "panes/charts/charts_data.h"

#include <algorithm>

#include "relief/tracers/tile_methods.h"

namespace reliefui {

namespace {

// Enough rays for a median whose error is below the spread, few enough to measure a method in about a second.
constexpr std::size_t kRays = 8192;
constexpr int kRounds = 7;

// The part of the scenario on which the rays depend.
relief::Scenario raysOf(const relief::Scenario& scenario) {
    const relief::Scenario standard;
    relief::Scenario part = relief::withNotesOf(scenario, standard);
    part.pixel.reset();
    part.other = {};
    part.comparison = {};
    part.method = standard.method;
    part.filter = standard.filter;
    part.light = standard.light;
    part.shadows = standard.shadows;
    part.sky = standard.sky;
    part.pictures.color.clear();
    part.pictures.normal.clear();
    return part;
}

bool isTracer(const relief::MethodChoice& method) {
    return relief::findTracer(method.name).kind == relief::MethodKind::Tracer;
}

}  // namespace

bool MeasuredView::of(const Snapshot& snapshot) const {
    return rays > 0 && heights == snapshot.request->field.identity() && scenario == raysOf(snapshot.scenario);
}

bool MeasuredView::has(const relief::MethodChoice& method) const {
    const std::string name = relief::shortMethodName(method);
    return std::any_of(table.points.begin(), table.points.end(),
                       [&](const relief::ParetoPoint& point) { return point.name == name; });
}

std::vector<relief::MethodChoice> methodsToMeasure(const Snapshot& snapshot, bool withMaps) {
    const relief::HeightField& field = snapshot.request->field;
    std::vector<relief::MethodChoice> methods;
    const auto add = [&](const relief::MethodChoice& method) {
        const std::string name = relief::shortMethodName(method);
        const bool there = std::any_of(methods.begin(), methods.end(), [&](const relief::MethodChoice& other) {
            return relief::shortMethodName(other) == name;
        });
        if (there || (field.tiles() != nullptr && !relief::tracesTiles(method))) return;
        if (relief::supports(method, field.surface(), field.address())) methods.push_back(method);
    };
    for (const relief::MeasuredMethod& method : relief::defaultMethods()) {
        if (withMaps || !method.buildsMaps) add(method.choice);
    }
    // The method as resolved for this view: base=auto has become a level.
    if (isTracer(snapshot.request->method)) add(snapshot.request->method);
    return methods;
}

MeasuredView measureView(const Snapshot& snapshot, bool withMaps, relief::Work& work) {
    MeasuredView measured;
    const relief::HeightField& field = snapshot.request->field;
    const relief::RayBlock rays = relief::sampledRays(*snapshot.frame, kRays);
    measured.table = relief::paretoTable(
        relief::benchRaysOfView(field, rays, methodsToMeasure(snapshot, withMaps), kRounds, *snapshot.maps, work));
    measured.rays = rays.size();
    measured.rounds = kRounds;
    measured.withMaps = withMaps;
    measured.scenario = raysOf(snapshot.scenario);
    measured.heights = field.identity();
    return measured;
}

std::shared_ptr<const relief::FrameHistograms> histogramsOf(const Snapshot& snapshot, relief::Work& work) {
    return std::make_shared<const relief::FrameHistograms>(
        relief::frameHistograms(*snapshot.frame, *snapshot.request, *snapshot.tracer, *snapshot.maps, work));
}

std::shared_ptr<const ParetoSource> paretoSource(const Snapshot& snapshot, const MeasuredView& measured,
                                                 relief::ErrorMeasure measure) {
    if (measured.table.points.empty()) return nullptr;
    auto source = std::make_shared<ParetoSource>();
    source->table = measured.table;
    source->measure = measure;
    source->title =
        relief::Message(relief::MessageId::DrawChartView, {{"rays", measured.rays}, {"rounds", measured.rounds}});
    source->current = relief::shortMethodName(snapshot.request->method);
    source->old = !measured.of(snapshot);
    if (source->old) source->title = relief::Message(relief::MessageId::DrawChartOld);
    return source;
}

bool sameMeasurement(const Snapshot& a, const Snapshot& b) {
    return a.request->field.identity() == b.request->field.identity() && a.scenario.method == b.scenario.method &&
           raysOf(a.scenario) == raysOf(b.scenario);
}

std::int64_t chosenSteps(const Snapshot& snapshot) {
    return snapshot.scenario.pixel && snapshot.trace.onRelief ? static_cast<std::int64_t>(snapshot.trace.steps.size())
                                                              : 0;
}

}  // namespace reliefui
