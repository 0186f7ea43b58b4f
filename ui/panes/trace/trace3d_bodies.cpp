#include "panes/trace/trace3d_bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include "panes/trace/tubes.h"

namespace reliefui {

namespace {

constexpr std::size_t kMostOutlines = 40;
constexpr int kAround = 72;  // points of a circle
constexpr double kOpacity = 0.3;
constexpr double kFaint = 0.45;

class Bodies {
  public:
    Bodies(const TraceScene& scene, const Snapshot& snapshot, const Style& style, double radius)
        : scene_(scene),
          slab_(std::max(snapshot.request->field.slabTexels(), 1e-9)),
          ray_(snapshot.trace.ray),
          run_(std::hypot(ray_.a, ray_.b)),
          direction_(run_ > 0 ? Point{ray_.a / run_, ray_.b / run_} : Point{1, 0}),
          style_(style),
          tube_(radius) {}

    // Sets the colour of the following bodies to that of this step.
    void take(const Snapshot& snapshot, const relief::Step& step) {
        color_ = style_.color(bodyRole(step, snapshot.trace.ray, snapshot.trace.exact));
    }

    vtkSmartPointer<vtkActor> filled(const StepBody& body) const {
        auto actor = actorOf(body.kind == StepBody::Kind::Sphere ? ball(body) : cone(body));
        paintIn(actor, color_);
        shadeWeakly(actor);
        actor->GetProperty()->SetOpacity(kOpacity);
        return actor;
    }

    // Sphere: a horizontal circle and one in the plane of the ray. Cone: its rim and two sides.
    void outline(Tubes& tubes, const StepBody& body, double width) const {
        if (body.kind == StepBody::Kind::Sphere) {
            ring(
                tubes, [&](double angle) { return onSphere(body, std::cos(angle), std::sin(angle), 0); }, width);
            ring(
                tubes,
                [&](double angle) {
                    const double c = std::cos(angle);
                    return onSphere(body, c * direction_.x, c * direction_.y, std::sin(angle));
                },
                width);
            return;
        }
        const double reach = reachOf(body);
        Place before = onCone(body, reach, body.from);
        for (int n = 1; n <= kAround; ++n) {
            const Place next = onCone(body, reach, body.from + (body.to - body.from) * n / kAround);
            tubes.add(before, next, width * tube_, color_);
            before = next;
        }
        const double ahead = std::atan2(direction_.y, direction_.x);
        const double first = body.whole() ? ahead : body.from;
        const double second = body.whole() ? ahead + std::numbers::pi : body.to;
        for (const double angle : {first, second}) {
            tubes.add(onCone(body, 0, angle), onCone(body, reach, angle), width * tube_, color_);
        }
    }

  private:
    double stretch() const { return scene_.scale / slab_; }

    Place onSphere(const StepBody& body, double x, double y, double z) const {
        const Place at = scene_.onRay(body.lambda);
        return {at[0] + body.radius * x, at[1] - body.radius * y, at[2] + body.radius * z * stretch()};
    }
    template <class At>
    void ring(Tubes& tubes, const At& at, double width) const {
        Place before = at(0);
        for (int n = 1; n <= kAround; ++n) {
            const Place next = at(2 * std::numbers::pi * n / kAround);
            tubes.add(before, next, width * tube_, color_);
            before = next;
        }
    }

    // Radius up to which the cone is drawn: where it reaches the top of the slab, or somewhat farther than the ray
    // travels in it.
    double reachOf(const StepBody& body) const {
        constexpr double kFarther = 1.4;
        constexpr double kLeast = 1.5;  // in texels
        const double away = body.away(ray_.a, ray_.b);
        const double way = (1 - body.lambda - body.apex) / (1 + body.slope * away) * away;
        const double far = std::max(kFarther * way, kLeast);
        return body.slope > 0 ? std::min(far, (1 - body.apex) / body.slope) : far;
    }
    Place onCone(const StepBody& body, double reach, double azimuth) const {
        const Place over = scene_.onRay(body.lambda);
        const double x = std::cos(azimuth), y = std::sin(azimuth), far = reach / body.away(x, y);
        return {over[0] + far * x, over[1] - far * y, (body.apex + body.slope * reach) * scene_.scale};
    }

    vtkSmartPointer<vtkPolyData> ball(const StepBody& body) const {
        auto source = vtkSmartPointer<vtkSphereSource>::New();
        source->SetRadius(body.radius);
        source->SetThetaResolution(kAround);
        source->SetPhiResolution(kAround / 2);
        source->Update();
        vtkSmartPointer<vtkPolyData> data = source->GetOutput();
        const Place at = scene_.onRay(body.lambda);
        vtkPoints* const points = data->GetPoints();
        for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k) {
            double p[3];
            points->GetPoint(k, p);
            points->SetPoint(k, at[0] + p[0], at[1] + p[1], at[2] + p[2] * stretch());
        }
        return data;
    }

    vtkSmartPointer<vtkPolyData> cone(const StepBody& body) const {
        auto points = vtkSmartPointer<vtkPoints>::New();
        auto cells = vtkSmartPointer<vtkCellArray>::New();
        points->InsertNextPoint(onCone(body, 0, 0).data());
        const double reach = reachOf(body);
        for (int n = 0; n <= kAround; ++n) {
            points->InsertNextPoint(onCone(body, reach, body.from + (body.to - body.from) * n / kAround).data());
        }
        for (vtkIdType n = 1; n <= kAround; ++n) {
            const vtkIdType triangle[3] = {0, n, n + 1};
            cells->InsertNextCell(3, triangle);
        }
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points);
        data->SetPolys(cells);
        return data;
    }

    const TraceScene& scene_;
    double slab_;
    relief::ViewRay ray_;
    double run_;  // of the ray, in texels per unit of lambda
    Point direction_;
    const Style& style_;
    Rgba color_;
    double tube_;
};

}  // namespace

Place aboveBody(const TraceScene& scene, const Snapshot& snapshot, const StepBody& body) {
    Place at = scene.onRay(body.lambda);
    const double slab = std::max(snapshot.request->field.slabTexels(), 1e-9);
    if (body.kind == StepBody::Kind::Sphere) at[2] += body.radius * scene.scale / slab;
    if (body.kind == StepBody::Kind::Cone) at[2] = scene.scale;
    return at;
}

std::vector<vtkSmartPointer<vtkActor>> bodyMarks(const TraceScene& scene, const Snapshot& snapshot, std::size_t chosen,
                                                 const Style& style, double radius) {
    std::vector<vtkSmartPointer<vtkActor>> marks;
    const std::vector<relief::Step>& steps = snapshot.trace.steps;
    if (chosen >= steps.size()) return marks;
    Bodies bodies(scene, snapshot, style, radius);
    Tubes earlier;
    for (std::size_t k = chosen > kMostOutlines ? chosen - kMostOutlines : 0; k < chosen; ++k) {
        const StepBody body = stepBody(steps[k]);
        if (!body) continue;
        bodies.take(snapshot, steps[k]);
        bodies.outline(earlier, body, 0.22);
    }
    auto faint = actorOf(earlier.take());
    shadeWeakly(faint);
    faint->GetProperty()->SetOpacity(kFaint);
    marks.push_back(faint);
    const StepBody body = stepBody(steps[chosen]);
    if (!body) return marks;
    bodies.take(snapshot, steps[chosen]);
    Tubes strong;
    bodies.outline(strong, body, 0.6);
    auto edge = actorOf(strong.take());
    shadeWeakly(edge);
    marks.push_back(edge);
    marks.push_back(bodies.filled(body));
    return marks;
}

}  // namespace reliefui
