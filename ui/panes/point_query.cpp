#include "panes/point_query.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "panes/ray_geometry.h"
#include "scenario/step_sentence.h"

namespace reliefui {

namespace {

using relief::Message;
using relief::MessageId;

constexpr int kDecimals = 3;
constexpr double kNearPlane =
    0.5;  // texels: a point at most this far from the plane is drawn, even if its spheres are smaller
constexpr LevelTint kEuclidean{0, 4};
constexpr LevelTint kRefined{1, 4};

// Label of the ray that decides the refined distance, as in figures 5 to 8 of the paper: V1, or V2 if the blocked ray
// is V1.
const char* decidingName(bool hidden) {
    return hidden ? "V2" : "V1";
}

// Returns true if the plane intersects the point's spheres, or passes very close to the point.
bool touches(const PointPlane& view, const relief::PointDistances& found) {
    const double radius = std::max(found.euclidean, found.reached ? found.refined : 0);
    return !view.spheres || std::abs(view.off) <= std::max(radius, kNearPlane);
}

// Returns true if the nearest surface point is not visible from above through C, and so does not count.
bool hides(const PointQuery& query) {
    constexpr double kSame = 1e-3;  // relative tolerance: directions 0.02 rad apart lengthen the distance by up to 1e-4
    const relief::PointDistances& found = query.distances;
    return found.blocked > 0 && found.refined > found.euclidean * (1 + kSame);
}

class PointMarks {
  public:
    PointMarks(Drawing& drawing, const PointQuery& query, const PointPlane& view)
        : drawing_(drawing), query_(query), view_(view) {}

    void add() {
        const relief::PointDistances& found = query_.distances;
        if (!touches(view_, found)) return;
        if (hides(query_)) hidden();
        if (found.rays > 0) euclidean();
        if (found.reached) refined();
        const std::optional<Point> at = pointMarkAt(view_, query_);
        if (!at) return;
        drawing_.add({}, Role::Highlight, Ring{*at, 4});
        drawing_.add(
            {}, Role::Highlight,
            Label{.at = *at, .text = plainText("C"), .anchor = Anchor::BottomLeft, .offset = {5, -5}, .plate = true},
            Emphasis::Strong);
    }

  private:
    // Converts a place relative to the point's first copy to the copy that is drawn; z is a height.
    Place3 placed(double s, double t, double z) const {
        return {view_.center[0] + s - query_.within.s, view_.center[1] + t - query_.within.t, z * view_.slab};
    }

    void euclidean() {
        const relief::PointDistances& found = query_.distances;
        sphere(found.euclidean, Role::Series, kEuclidean);
        const Point from = view_.at(view_.center);
        const Point to = view_.at(placed(found.s, found.t, found.z));
        line({from, to}, Role::Series, kEuclidean, true);
        number(from, to, found.euclidean, Role::Series, kEuclidean);
    }

    // Position on a ray through C.
    Point onRay(const relief::ViewRay& ray, double lambda) const {
        const double along = lambda - (1 - query_.within.z);
        return view_.at(placed(query_.within.s + along * ray.a, query_.within.t + along * ray.b, 1 - lambda));
    }

    // The blocked ray from its entry into the slab to C, crossed out if it hits the surface before C.
    void hidden() {
        const relief::PointDistances& found = query_.distances;
        const Point hit = onRay(found.blockedRay, found.blockedHit.lambda);
        const Point from = onRay(found.blockedRay, 0);
        line({from, view_.at(view_.center)}, Role::Hidden, {}, true);
        name("V1", from, hit, Role::Hidden, {});
        if (view_.plot.grown(1).contains(hit)) put(Role::Hidden, Marker{hit, Shape::Cross, 9}, {});
    }

    // The ray from its entry into the slab, through C, to its hit.
    void refined() {
        const relief::PointDistances& found = query_.distances;
        sphere(found.refined, Role::SeriesDashed, kRefined);
        const Point hit = onRay(found.ray, found.hit.lambda);
        const Point from = onRay(found.ray, 0);
        line({from, hit}, Role::SeriesDashed, kRefined, true);
        name(decidingName(hides(query_)), from, hit, Role::SeriesDashed, kRefined);
        number(view_.at(view_.center), hit, found.refined, Role::SeriesDashed, kRefined);
    }

    void sphere(double radius, Role role, const LevelTint& tint) {
        if (!view_.spheres || !(radius > std::abs(view_.off))) return;
        const double cut = std::sqrt(radius * radius - view_.off * view_.off);
        const Point at = view_.at(view_.center);
        line(ellipseLine(at, {cut * view_.scaleX, 0}, {0, cut * view_.scaleY}), role, tint, false);
    }

    void line(const std::vector<Point>& points, Role role, const LevelTint& tint, bool arrow) {
        for (std::vector<Point>& run : clippedTo(points, view_.plot)) {
            const bool whole = run.back() == points.back();
            put(role, Polyline{std::move(run), arrow && whole}, tint);
        }
    }

    // Labels a line next to its first visible point.
    void name(const char* text, Point from, Point to, Role role, const LevelTint& tint) {
        const auto runs = clippedTo({from, to}, view_.plot);
        if (runs.empty()) return;
        const Point at = runs.front().front();
        const bool atRim = at.x > view_.plot.x1 - 1;  // then left of it, where it is not cut off
        put(role,
            Label{.at = at,
                  .text = plainText(text),
                  .anchor = atRim ? Anchor::Right : Anchor::TopLeft,
                  .size = 0.9,
                  .offset = atRim ? Point{-4, 10} : Point{4, 3},
                  .plate = true},
            tint);
    }

    // Adds a number in the middle of the visible part of a line.
    void number(Point from, Point to, double value, Role role, const LevelTint& tint) {
        const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
        if (!view_.plot.contains(middle)) return;
        put(role,
            Label{.at = middle,
                  .text = plainText(relief::fixedText(value, kDecimals)),
                  .anchor = Anchor::Center,
                  .size = 0.8,
                  .plate = true},
            tint);
    }

    void put(Role role, Primitive primitive, const LevelTint& tint) {
        drawing_.add({}, role, std::move(primitive), Emphasis::Strong, tint);
    }

    Drawing& drawing_;
    const PointQuery& query_;
    const PointPlane& view_;
};

bool repeats(const relief::HeightField& field) {
    return field.address() == relief::Address::Repeat;
}

double wrappedInto(double place, double period) {
    const double within = place - std::floor(place / period) * period;
    return within < period ? within : 0;
}

}  // namespace

double nearestCopy(double place, double near, double period) {
    return place + std::round((near - place) / period) * period;
}

bool overPicture(const relief::HeightField& field, const QueryPoint& point) {
    if (repeats(field)) return true;
    return point.s >= 0 && point.s <= field.width() && point.t >= 0 && point.t <= field.height();
}

std::shared_ptr<const PointQuery> pointQuery(const relief::HeightField& field, const QueryPoint& point, double flattest,
                                             relief::MapCache& cache, relief::Work& work) {
    if (!overPicture(field, point)) return nullptr;
    auto query = std::make_shared<PointQuery>();
    query->point = query->within = point;
    if (repeats(field)) {
        query->within.s = wrappedInto(point.s, field.width());
        query->within.t = wrappedInto(point.t, field.height());
    }
    const QueryPoint& at = query->within;
    query->distances = relief::distancesAt(field, at.s, at.t, at.z, flattest, cache, work);
    return query;
}

void addPointMarks(Drawing& drawing, const PointQuery& query, const PointPlane& plane) {
    PointMarks(drawing, query, plane).add();
}

std::optional<Point> pointMarkAt(const PointPlane& view, const PointQuery& query) {
    const Point at = view.at(view.center);
    return touches(view, query.distances) && view.plot.contains(at) ? std::optional(at) : std::nullopt;
}

void addPointLegend(LegendRows& rows, const PointQuery& query) {
    const auto fixed = [](double value) { return relief::fixedText(value, kDecimals); };
    const relief::PointDistances& found = query.distances;
    if (found.rays == 0) return rows.words(Message(MessageId::DrawPointInside));
    rows.line(Role::Series, Message(MessageId::DrawPointEuclidean, {{"texels", fixed(found.euclidean)}}), kEuclidean);
    if (hides(query)) rows.line(Role::Hidden, Message(MessageId::DrawPointHidden));
    if (!found.reached) return rows.words(Message(MessageId::DrawPointNoRay));
    const relief::ViewRay& ray = found.ray;
    constexpr int kDigits = 4;
    const auto brief = [](double value) { return relief::numberText(value, kDigits); };
    const char* const name = decidingName(hides(query));
    rows.line(Role::SeriesDashed,
              Message(MessageId::DrawPointRefined, {{"texels", fixed(found.refined)},
                                                    {"name", name},
                                                    {"s", brief(ray.s0)},
                                                    {"t", brief(ray.t0)},
                                                    {"a", brief(ray.a)},
                                                    {"b", brief(ray.b)}}),
              kRefined);
}

}  // namespace reliefui
