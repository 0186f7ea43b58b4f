#include "panes/point_finder.h"

#include "relief/tracers/map_choice.h"

namespace reliefui {

double servedFlattest(const relief::MethodChoice& method) {
    const auto used = relief::usedMap(method);
    if (!used) return relief::DistanceParameters().flattest;
    const auto given = used->options.find("flattest");
    return given == used->options.end() ? relief::DistanceParameters().flattest
                                        : relief::parseNumber(given->second, "flattest");
}

std::shared_ptr<const PointQuery> pointOf(const Snapshot& snapshot, const std::optional<QueryPoint>& point,
                                          relief::Work& work) {
    if (!point || !snapshot.request || !snapshot.maps) return nullptr;
    return pointQuery(snapshot.request->field, *point, servedFlattest(snapshot.scenario.method), *snapshot.maps, work);
}

PointFinder::PointFinder(const QObject* receiver, std::function<void()> found)
    : found_(std::move(found)), job_(receiver, {[](const QString&) {}, [](const QString&, double) {}}) {}

void PointFinder::ask(const std::shared_ptr<const Snapshot>& snapshot, const std::optional<QueryPoint>& point) {
    if (!point || !snapshot || !snapshot->request || !snapshot->maps) return drop();
    const relief::HeightField& field = snapshot->request->field;
    const Question now{*point,          field.identity(),    field.surface(),
                       field.address(), field.reliefDepth(), servedFlattest(snapshot->scenario.method)};
    if (pending_ == now) return;
    drop();
    // Not during a drag, in which the relief would soon be outdated.
    if (snapshot->coarse) return;
    pending_ = now;
    auto query = std::make_shared<std::shared_ptr<const PointQuery>>();
    const auto work = [snapshot, point, query](relief::Work& w) { *query = pointOf(*snapshot, point, w); };
    const auto done = [this, query] {
        known_ = *query;
        found_();
    };
    job_.start({work, done});
}

void PointFinder::drop() {
    if (pending_) job_.drop();
    pending_.reset();
    known_.reset();
}

}  // namespace reliefui
