#include "panes/trace/tubes.h"

#include <cmath>

#include <vtkCellData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace reliefui {

Place between(const Place& a, const Place& b, double f) {
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
}

void Tubes::cell(const std::vector<vtkIdType>& ids, Rgba color) {
    cells_->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    const unsigned char rgba[4] = {color.r, color.g, color.b, color.a};
    colors_->InsertNextTypedTuple(rgba);
}

void Tubes::cone(const Place& from, const Place& to, double radius, double endRadius, Rgba color) {
    constexpr int kSides = 14;
    const double d[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    const double length = std::hypot(d[0], d[1], d[2]);
    if (length <= 0) return;
    // Any direction that is not parallel to the tube.
    const bool steep = std::abs(d[2]) > 0.9 * length;
    const Place axis = steep ? Place{1, 0, 0} : Place{0, 0, 1};
    Place u{d[1] * axis[2] - d[2] * axis[1], d[2] * axis[0] - d[0] * axis[2], d[0] * axis[1] - d[1] * axis[0]};
    const double across = std::hypot(u[0], u[1], u[2]);
    for (double& part : u) part /= across;
    const Place v{(d[1] * u[2] - d[2] * u[1]) / length, (d[2] * u[0] - d[0] * u[2]) / length,
                  (d[0] * u[1] - d[1] * u[0]) / length};
    const vtkIdType first = points_->GetNumberOfPoints();
    for (const bool end : {false, true}) {
        for (int k = 0; k < kSides; ++k) {
            const double angle = 2 * M_PI * k / kSides;
            Place p = end ? to : from;
            for (std::size_t c = 0; c < 3; ++c) {
                p[c] += (end ? endRadius : radius) * (std::cos(angle) * u[c] + std::sin(angle) * v[c]);
            }
            points_->InsertNextPoint(p.data());
        }
    }
    std::vector<vtkIdType> caps[2];
    for (vtkIdType k = 0; k < kSides; ++k) {
        const vtkIdType next = (k + 1) % kSides;
        cell({first + k, first + next, first + kSides + next, first + kSides + k}, color);
        caps[0].push_back(first + k);
        caps[1].push_back(first + kSides + k);
    }
    cell(caps[0], color);
    cell(caps[1], color);
}

void Tubes::arrow(const Place& from, const Place& to, double radius, Rgba color) {
    constexpr double kHeadLength = 9;  // in radii
    constexpr double kHeadWidth = 3;
    const double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    if (length <= 0) return;
    const Place neck = between(to, from, std::min(0.5, kHeadLength * radius / length));
    add(from, neck, radius, color);
    cone(neck, to, kHeadWidth * radius, 0, color);
}

void Tubes::ball(const Place& at, double radius, Rgba color) {
    constexpr int kRings = 6;
    for (int k = 0; k < kRings; ++k) {
        const double low = M_PI * k / kRings - M_PI / 2;
        const double high = M_PI * (k + 1) / kRings - M_PI / 2;
        const Place from{at[0], at[1], at[2] + radius * std::sin(low)};
        const Place to{at[0], at[1], at[2] + radius * std::sin(high)};
        cone(from, to, radius * std::cos(low), radius * std::cos(high), color);
    }
}

vtkSmartPointer<vtkPolyData> Tubes::take() const {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetPolys(cells_);
    data->GetCellData()->SetScalars(colors_);
    return data;
}

vtkSmartPointer<vtkActor> actorOf(const vtkSmartPointer<vtkPolyData>& data) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    return actor;
}

void paintIn(vtkActor* actor, Rgba color) {
    actor->GetProperty()->SetColor(color.r / 255.0, color.g / 255.0, color.b / 255.0);
}

void shadeWeakly(vtkActor* actor) {
    actor->GetProperty()->SetAmbient(0.75);
    actor->GetProperty()->SetDiffuse(0.3);
}

}  // namespace reliefui
