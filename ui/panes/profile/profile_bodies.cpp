#include <algorithm>
#include <cmath>

#include "panes/profile/profile_drawing.h"
#include "panes/ray_geometry.h"

namespace reliefui {

namespace {

// Only this many steps around the chosen one are drawn; more could not be distinguished.
constexpr std::size_t kMost = 200;

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
    // Section of a sphere with the plane of the ray: a circle, or an ellipse if the axes have different scales.
    void sphere(std::size_t k, const StepBody& body, bool chosen) {
        const Point at = frame_.onRay(body.lambda);
        const double rx = body.radius * frame_.plot.width() / (frame_.lambdaEnd * frame_.run);
        const double ry =
            body.radius * frame_.plot.height() / ((frame_.high - frame_.low) * source_.field->slabTexels());
        addEllipse(drawing_, at, rx, ry, frame_.plot, stepId(k), role_, chosen ? Emphasis::Strong : Emphasis::Faint);
    }

    // Section of a cone: two sides of a triangle. With several sectors only the forward side, because the other belongs
    // to another sector.
    void cone(std::size_t k, const StepBody& body, bool chosen) {
        const double longest = frame_.lambdaEnd;
        const double away = body.away(source_.ray.a, source_.ray.b);  // per unit of lambda
        const auto side = [&](double run) {
            return frame_.at(body.lambda + run, body.apex + body.slope * std::abs(run) * away);
        };
        std::vector<Point> edge;
        if (body.whole()) edge.push_back(side(-longest));
        edge.push_back(frame_.at(body.lambda, body.apex));
        edge.push_back(side(longest));
        std::vector<Point> shape;
        // Short enough that the fill ends accurately at the plot's upper side.
        constexpr int kParts = 60;
        for (std::size_t n = 1; n < edge.size(); ++n) {
            for (int p = 0; p <= kParts; ++p) {
                const double f = static_cast<double>(p) / kParts;
                shape.push_back(
                    {edge[n - 1].x + f * (edge[n].x - edge[n - 1].x), edge[n - 1].y + f * (edge[n].y - edge[n - 1].y)});
            }
        }
        if (chosen) addFill(drawing_, shape, frame_.plot.y0, frame_.plot, role_);
        addLine(drawing_, edge, frame_.plot, stepId(k), role_, chosen ? Emphasis::Strong : Emphasis::Faint);
    }

    Drawing& drawing_;
    const ProfileSource& source_;
    const ProfileFrame& frame_;
    Role role_ = Role::Empty;  // of the sphere or cone being drawn
};

}  // namespace

void addBodies(Drawing& drawing, const ProfileSource& source, const ProfileFrame& frame, std::size_t chosen) {
    // If the x axis is the descent, a sphere has no width to draw.
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
