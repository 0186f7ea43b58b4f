#include <algorithm>
#include <cmath>
#include <numbers>

#include "panes/profile/profile_drawing.h"
#include "panes/ray_geometry.h"

namespace reliefui {

namespace {

// Steps beyond these around the chosen one are not drawn: nobody could tell them apart.
constexpr std::size_t kMost = 200;
constexpr int kAround = 120;  // points of a circle

ItemId stepId(std::size_t k) {
    return {ItemKind::Step, 0, static_cast<std::int64_t>(k), 0};
}

class Bodies {
  public:
    Bodies(Drawing& drawing, const ProfileSource& source, const ProfileFrame& frame)
        : drawing_(drawing), source_(source), frame_(frame) {}

    void add(std::size_t k, bool chosen) {
        const StepBody body = stepBody((*source_.steps)[k]);
        if (!body || body.lambda > frame_.lambdaEnd) return;
        role_ = bodyRole((*source_.steps)[k], source_.ray, source_.exact);
        body.kind == StepBody::Kind::Sphere ? sphere(k, body, chosen) : cone(k, body, chosen);
    }

  private:
    // A circle in the plane of the ray; an ellipse where the axes have different scales.
    void sphere(std::size_t k, const StepBody& body, bool chosen) {
        const Point at = frame_.onRay(body.lambda);
        const double rx = body.radius * frame_.plot.width() / (frame_.lambdaEnd * frame_.run);
        const double ry =
            body.radius * frame_.plot.height() / ((frame_.high - frame_.low) * source_.field->slabTexels());
        std::vector<Point> circle;
        std::vector<Point> upper;
        std::vector<Point> lower;
        for (int n = 0; n <= kAround; ++n) {
            const double angle = std::numbers::pi + 2 * std::numbers::pi * n / kAround;
            circle.push_back({at.x + rx * std::cos(angle), at.y + ry * std::sin(angle)});
            if (2 * n > kAround) continue;
            upper.push_back(circle.back());
            lower.push_back({circle.back().x, 2 * at.y - circle.back().y});
        }
        if (chosen) {
            fill(upper, at.y);
            fill(lower, at.y);
        }
        line(circle, k, chosen);
    }

    // Two sides of a triangle; what lies behind is in another sector where there are several.
    void cone(std::size_t k, const StepBody& body, bool chosen) {
        const double longest = frame_.lambdaEnd;
        const double away = body.away(source_.ray.a, source_.ray.b);  // a unit of lambda
        const auto side = [&](double run) {
            return frame_.at(body.lambda + run, body.apex + body.slope * std::abs(run) * away);
        };
        std::vector<Point> edge;
        if (body.whole()) edge.push_back(side(-longest));
        edge.push_back(frame_.at(body.lambda, body.apex));
        edge.push_back(side(longest));
        std::vector<Point> shape;
        // Close enough for the fill to end at the plot's upper side.
        constexpr int kParts = 60;
        for (std::size_t n = 1; n < edge.size(); ++n) {
            for (int p = 0; p <= kParts; ++p) {
                const double f = static_cast<double>(p) / kParts;
                shape.push_back(
                    {edge[n - 1].x + f * (edge[n].x - edge[n - 1].x), edge[n - 1].y + f * (edge[n].y - edge[n - 1].y)});
            }
        }
        if (chosen) fill(shape, frame_.plot.y0);
        line(edge, k, chosen);
    }

    void line(const std::vector<Point>& points, std::size_t k, bool chosen) {
        for (std::vector<Point>& run : clippedTo(points, frame_.plot)) {
            drawing_.add(stepId(k), role_, Polyline{std::move(run), false},
                         chosen ? Emphasis::Strong : Emphasis::Faint);
        }
    }

    // What lies between the line (x ascending) and the horizontal at y, in the plot.
    void fill(const std::vector<Point>& points, double y) {
        const Box& plot = frame_.plot;
        Area area;
        area.base = std::clamp(y, plot.y0, plot.y1);
        for (const Point& p : points) {
            if (p.x >= plot.x0 && p.x <= plot.x1) area.line.push_back({p.x, std::clamp(p.y, plot.y0, plot.y1)});
        }
        drawing_.add({}, role_, std::move(area), Emphasis::Faint);
    }

    Drawing& drawing_;
    const ProfileSource& source_;
    const ProfileFrame& frame_;
    Role role_ = Role::Empty;  // of the body that is being drawn
};

}  // namespace

void addBodies(Drawing& drawing, const ProfileSource& source, const ProfileFrame& frame, std::size_t chosen) {
    // Over the descent, a sphere has no width.
    if (frame.vertical || source.field->slabTexels() <= 0) return;
    Bodies bodies(drawing, source, frame);
    const std::size_t first = chosen > kMost ? chosen - kMost : 0;
    const std::size_t last = std::min(source.steps->size(), chosen + kMost);
    for (std::size_t k = first; k < last; ++k) {
        if (k != chosen) bodies.add(k, false);
    }
    bodies.add(chosen, true);
}

}  // namespace reliefui
