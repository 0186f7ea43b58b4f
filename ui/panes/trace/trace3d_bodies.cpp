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

constexpr int kAround = 72;  // points of a circle

// Adds tubes along polylines.
void addTubes(Tubes& tubes, const std::vector<std::vector<Place>>& lines, double radius, Rgba color) {
    for (const auto& line : lines) {
        for (std::size_t k = 1; k < line.size(); ++k) tubes.add(line[k - 1], line[k], radius, color);
    }
}

vtkSmartPointer<vtkPolyData> ball(const BodyShape& shape) {
    auto source = vtkSmartPointer<vtkSphereSource>::New();
    source->SetRadius(shape.body().radius);
    source->SetThetaResolution(kAround);
    source->SetPhiResolution(kAround / 2);
    source->Update();
    vtkSmartPointer<vtkPolyData> data = source->GetOutput();
    const Place at = shape.center();
    vtkPoints* const points = data->GetPoints();
    for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k) {
        double p[3];
        points->GetPoint(k, p);
        points->SetPoint(k, at[0] + p[0], at[1] + p[1], at[2] + p[2] * shape.stretch());
    }
    return data;
}

vtkSmartPointer<vtkPolyData> cone(const BodyShape& shape) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    points->InsertNextPoint(shape.onCone(0, 0).data());
    for (int n = 0; n <= kAround; ++n) points->InsertNextPoint(shape.onRim(n).data());
    for (vtkIdType n = 1; n <= kAround; ++n) {
        const vtkIdType triangle[3] = {0, n, n + 1};
        cells->InsertNextCell(3, triangle);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

}  // namespace

BodyShape::BodyShape(const TraceScene& scene, const Snapshot& snapshot, const StepBody& body)
    : scene_(scene),
      body_(body),
      stretch_(scene.scale / std::max(snapshot.request->field.slabTexels(), 1e-9)),
      ray_(snapshot.trace.ray) {}

Place BodyShape::onSphere(double x, double y, double z) const {
    const Place at = center();
    return {at[0] + body_.radius * x, at[1] - body_.radius * y, at[2] + body_.radius * z * stretch_};
}

// Up to where the cone reaches the top of the slab, or somewhat farther than the ray travels in it.
double BodyShape::reach() const {
    constexpr double kFarther = 1.4;
    constexpr double kLeast = 1.5;  // in texels
    const double away = body_.away(ray_.a, ray_.b);
    const double way = (1 - body_.lambda - body_.apex) / (1 + body_.slope * away) * away;
    const double far = std::max(kFarther * way, kLeast);
    return body_.slope > 0 ? std::min(far, (1 - body_.apex) / body_.slope) : far;
}

Place BodyShape::onCone(double reach, double azimuth) const {
    const Place over = center();
    const double x = std::cos(azimuth), y = std::sin(azimuth), far = reach / body_.away(x, y);
    return {over[0] + far * x, over[1] - far * y, (body_.apex + body_.slope * reach) * scene_.scale};
}

Place BodyShape::onRim(int n) const {
    return onCone(reach(), body_.from + (body_.to - body_.from) * n / kAround);
}

std::vector<std::vector<Place>> BodyShape::outline() const {
    std::vector<std::vector<Place>> lines(body_.kind == StepBody::Kind::Sphere ? 2 : 3);
    const double run = std::hypot(ray_.a, ray_.b);
    const Point direction = run > 0 ? Point{ray_.a / run, ray_.b / run} : Point{1, 0};
    if (body_.kind == StepBody::Kind::Sphere) {
        for (int n = 0; n <= kAround; ++n) {
            const double angle = 2 * std::numbers::pi * n / kAround;
            const double c = std::cos(angle), s = std::sin(angle);
            lines[0].push_back(onSphere(c, s, 0));
            lines[1].push_back(onSphere(c * direction.x, c * direction.y, s));
        }
        return lines;
    }
    for (int n = 0; n <= kAround; ++n) lines[0].push_back(onRim(n));
    const double ahead = std::atan2(direction.y, direction.x);
    const double first = body_.whole() ? ahead : body_.from;
    const double second = body_.whole() ? ahead + std::numbers::pi : body_.to;
    lines[1] = {onCone(0, first), onCone(reach(), first)};
    lines[2] = {onCone(0, second), onCone(reach(), second)};
    return lines;
}

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
    const auto colorOf = [&](const relief::Step& step) {
        return style.color(bodyRole(step, snapshot.trace.ray, snapshot.trace.exact));
    };
    Tubes earlier;
    for (std::size_t k = firstOutline(chosen); k < chosen; ++k) {
        const StepBody body = stepBody(steps[k]);
        if (!body) continue;
        addTubes(earlier, BodyShape(scene, snapshot, body).outline(), kEarlierOutline * radius, colorOf(steps[k]));
    }
    auto faint = actorOf(earlier.take());
    shadeWeakly(faint);
    faint->GetProperty()->SetOpacity(kEarlierOpacity);
    marks.push_back(faint);
    const StepBody body = stepBody(steps[chosen]);
    if (!body) return marks;
    const BodyShape shape(scene, snapshot, body);
    const Rgba color = colorOf(steps[chosen]);
    Tubes strong;
    addTubes(strong, shape.outline(), kOutline * radius, color);
    auto edge = actorOf(strong.take());
    shadeWeakly(edge);
    marks.push_back(edge);
    auto filled = actorOf(body.kind == StepBody::Kind::Sphere ? ball(shape) : cone(shape));
    paintIn(filled, color);
    shadeWeakly(filled);
    filled->GetProperty()->SetOpacity(kBodyOpacity);
    marks.push_back(filled);
    return marks;
}

}  // namespace reliefui
