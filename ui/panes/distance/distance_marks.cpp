#include <algorithm>
#include <cmath>
#include <numbers>

#include "panes/distance/distance_drawing.h"
#include "panes/ray_geometry.h"

namespace reliefui {

namespace {

using relief::Decision;

// Only this many steps around the chosen one are drawn; more could not be distinguished.
constexpr std::size_t kMostBodies = 200;
constexpr std::size_t kMostMarks = 400;
constexpr int kAround = 120;  // points of a polyline for a circle
constexpr double kNumberSize = 0.8;

class Marks {
  public:
    Marks(const DistanceSource& source, const DistanceFrame& frame, int step)
        : source_(source), frame_(frame), chosen_(static_cast<std::size_t>(std::max(step, 0))) {
        drawing_.bounds = frame.whole;
        if (known()) chosen_ = std::min(chosen_, source.steps->size() - 1);
    }

    Drawing take() {
        if (known()) bodies();
        ray();
        if (known()) marks();
        hit();
        return std::move(drawing_);
    }

  private:
    bool known() const { return source_.steps != nullptr && !source_.steps->empty(); }
    const relief::Step& step(std::size_t k) const { return (*source_.steps)[k]; }
    Emphasis emphasis(std::size_t k) const { return k > chosen_ ? Emphasis::Faint : Emphasis::Normal; }
    Point onPlot(double lambda) const { return frame_.at(placeOnRay(source_, lambda)); }

    void line(const std::vector<Point>& points, const ItemId& id, Role role, Emphasis strength) {
        addLine(drawing_, points, frame_.plot, id, role, strength);
    }

    // --- spheres and cones, intersected with the slice

    void bodies() {
        const std::size_t first = chosen_ > kMostBodies ? chosen_ - kMostBodies : 0;
        const std::size_t last = std::min(source_.steps->size(), chosen_ + kMostBodies);
        for (std::size_t k = first; k < last; ++k) {
            if (k != chosen_) body(k, Emphasis::Faint);
        }
        body(chosen_, Emphasis::Strong);
    }

    void body(std::size_t k, Emphasis strength) {
        const StepBody body = stepBody(step(k));
        if (!body) return;
        role_ = bodyRole(step(k), source_.ray, source_.exact);
        const Place3 center = placeOnRay(source_, body.lambda);
        if (body.kind == StepBody::Kind::Sphere) {
            sphere(k, center, body.radius, strength);
        } else {
            cone(k, center, body, strength);
        }
    }

    void sphere(std::size_t k, const Place3& center, double radius, Emphasis strength) {
        const double off = offPlane(frame_.axis, frame_.plane, center);
        if (!(std::abs(off) < radius)) return;
        const double cut = std::sqrt(radius * radius - off * off) * frame_.scale;
        const Point at = frame_.at(center);
        addEllipse(drawing_, at, cut, cut, frame_.plot, stepId(k), role_, strength);
        number(k, {at.x, at.y - cut}, strength);
    }

    void cone(std::size_t k, const Place3& over, const StepBody& body, Emphasis strength) {
        const Place3 apex{over[0], over[1], body.apex * frame_.slab};
        frame_.axis == SliceAxis::Z ? coneFromAbove(k, apex, body, strength) : coneUpright(k, apex, body, strength);
    }

    // Outline of the cone at the slice's height; for a map of slopes, at the ray's height.
    void coneFromAbove(std::size_t k, const Place3& apex, const StepBody& body, Emphasis strength) {
        const double height = frame_.slopes ? 1 - body.lambda : frame_.plane / frame_.slab;
        const double rise = height - body.apex;
        if (!(rise > 0)) return;
        const double farthest = std::hypot(frame_.window.width(), frame_.window.height());
        const double radius = body.slope > 0 ? std::min(rise / body.slope, 2 * farthest) : 2 * farthest;
        std::vector<Point> edge;
        if (!body.whole()) edge.push_back(frame_.at(apex));
        for (int n = 0; n <= kAround; ++n) {
            const double angle = body.from + (body.to - body.from) * n / kAround;
            const double x = std::cos(angle), y = std::sin(angle), far = radius / body.away(x, y);
            edge.push_back(frame_.at(Place3{apex[0] + far * x, apex[1] + far * y, apex[2]}));
        }
        if (!body.whole()) edge.push_back(frame_.at(apex));
        line(edge, stepId(k), role_, strength);
        number(k, frame_.at(apex), strength);
    }

    // Vertical section of a cone: a branch of a hyperbola, or straight sides for a square cone; two lines if the slice
    // passes through the apex.
    void coneUpright(std::size_t k, const Place3& apex, const StepBody& body, Emphasis strength) {
        const double off = frame_.plane - apex[frame_.axis == SliceAxis::X ? 0 : 1];
        const double center = toSlice(frame_.axis, frame_.slab, apex).x;
        const bool alongX = frame_.axis == SliceAxis::Y;
        std::vector<std::vector<Point>> runs(1);
        const int samples = 2 * kAround;
        for (int n = 0; n <= samples; ++n) {
            // Samples are denser near the apex, where the curve bends, and include the apex.
            const double f = 2.0 * n / samples - 1;
            const double u = f * std::abs(f) * (frame_.window.width() + std::abs(center - frame_.window.center().x));
            const Point towards = alongX ? Point{u, off} : Point{off, u};
            const double away = body.away(u, off);
            if (away > 0 && !body.holds(towards.x, towards.y)) {
                if (!runs.back().empty()) runs.emplace_back();
                continue;
            }
            const double height = body.apex + body.slope * away;
            runs.back().push_back(frame_.at(Point{center + u, frame_.slab * (1 - height)}));
        }
        for (const std::vector<Point>& run : runs) {
            if (run.size() < 2) continue;
            if (strength == Emphasis::Strong) addFill(drawing_, run, frame_.plot.y0, frame_.plot, role_);
            line(run, stepId(k), role_, strength);
        }
        number(k, frame_.at(apex), strength);
    }

    void number(std::size_t k, Point at, Emphasis strength) {
        if (!frame_.plot.contains(at)) return;
        drawing_.add({}, role_,
                     Label{.at = at,
                           .text = plainText(std::to_string(k + 1)),
                           .anchor = Anchor::Center,
                           .size = kNumberSize,
                           .plate = true,
                           .yields = strength != Emphasis::Strong},
                     strength);
    }

    // --- the ray, projected along the slice's axis

    void ray() {
        const double end = rayEndOf(source_);
        constexpr ItemId kRay{ItemKind::Ray, 0, 0, 0};
        line({onPlot(0), onPlot(end)}, kRay, Role::Ray, Emphasis::Normal);
        if (!known()) return;
        const relief::Step& s = step(chosen_);
        const double from = std::clamp(s.lambdaIn, 0.0, end);
        const double to = std::clamp(std::max(s.lambdaOut, s.lambdaAfter), from, std::max(end, from));
        if (to > from) line({onPlot(from), onPlot(to)}, kRay, Role::Ray, Emphasis::Strong);
        crossing(end);
    }

    // Marks the point where the ray intersects the slice.
    void crossing(double end) {
        const double from = offPlane(frame_.axis, frame_.plane, placeOnRay(source_, 0));
        const double to = offPlane(frame_.axis, frame_.plane, placeOnRay(source_, end));
        if (from * to > 0 || from == to) return;
        const Point at = onPlot(end * from / (from - to));
        // Omitted near the chosen step, which has a mark of its own.
        constexpr double kNear = 6;
        const Point chosen = frame_.at(stepPlace(source_, static_cast<int>(chosen_)));
        if (std::hypot(chosen.x - at.x, chosen.y - at.y) < kNear) return;
        if (frame_.plot.contains(at)) drawing_.add({}, Role::Ray, Marker{at, Shape::SquareHollow, 10});
    }

    void marks() {
        const std::size_t first = chosen_ > kMostMarks ? chosen_ - kMostMarks : 0;
        const std::size_t last = std::min(source_.steps->size(), chosen_ + kMostMarks);
        for (std::size_t k = first; k < last; ++k) {
            if (k != chosen_) mark(k);
        }
        mark(chosen_);
    }

    void mark(std::size_t k) {
        const relief::Step& s = step(k);
        if (s.decision == Decision::Hit && source_.hit.outcome == relief::Outcome::Hit && k != chosen_) return;
        const Point at = frame_.at(stepPlace(source_, static_cast<int>(k)));
        if (!frame_.plot.contains(at)) return;
        drawing_.add(stepId(k), roleOf(s.decision), Marker{at, shapeOf(s.decision), k == chosen_ ? 8.0 : 6.0},
                     emphasis(k));
        if (k != chosen_) return;
        drawing_.add(stepId(k), Role::Highlight, Rectangle{{at.x, at.y, at.x, at.y}, false, 0, 13});
        const StepBody body = stepBody(s);
        if (body) return;
        drawing_.add({}, roleOf(s.decision),
                     Label{.at = at,
                           .text = plainText(std::to_string(k + 1)),
                           .size = kNumberSize,
                           .offset = {9, 0},
                           .plate = true},
                     Emphasis::Strong);
    }

    void hit() {
        if (source_.hit.outcome != relief::Outcome::Hit) return;
        const Point at = onPlot(source_.hit.lambda);
        if (frame_.plot.contains(at)) drawing_.add({ItemKind::Hit, 0, 0, 0}, Role::Hit, Ring{at, 5});
    }

    const DistanceSource& source_;
    const DistanceFrame& frame_;
    std::size_t chosen_;
    Role role_ = Role::Empty;  // of the sphere or cone being drawn
    Drawing drawing_;
};

}  // namespace

Drawing distanceMarks(const DistanceSource& source, const DistanceFrame& frame, int step) {
    Drawing marks;
    if (source.hasRay) marks = Marks(source, frame, step).take();
    if (source.point == nullptr) return marks;
    marks.bounds = frame.whole;
    addPointMarks(marks, *source.point, pointPlane(*source.point, *source.field, frame));
    return marks;
}

PointPlane pointPlane(const PointQuery& query, const relief::HeightField& field, const DistanceFrame& frame) {
    PointPlane view;
    view.plot = frame.plot;
    view.at = [&](const Place3& place) { return frame.at(place); };
    view.center = {query.point.s, query.point.t, query.point.z * frame.slab};
    if (field.address() == relief::Address::Repeat) {
        const Place3 middle = fromSlice(frame.axis, frame.slab, frame.plane, frame.window.center());
        const Point uv = toSlice(frame.axis, frame.slab, view.center);
        const bool seen = frame.window.contains(uv);
        const auto normal = static_cast<std::size_t>(frame.axis);
        const std::array<double, 2> periods{static_cast<double>(field.width()), static_cast<double>(field.height())};
        for (std::size_t axis = 0; axis < periods.size(); ++axis) {
            if (axis == normal || !seen)
                view.center[axis] = nearestCopy(view.center[axis], middle[axis], periods[axis]);
        }
    }
    view.spheres = !frame.slopes;
    view.off = offPlane(frame.axis, frame.plane, view.center);
    view.scaleX = view.scaleY = frame.scale;
    view.slab = frame.slab;
    return view;
}

}  // namespace reliefui
