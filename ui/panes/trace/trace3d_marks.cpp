#include "panes/trace/trace3d_marks.h"

#include <cmath>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDiskSource.h>
#include <vtkFollower.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include "painting/vtk_text.h"
#include "panes/trace/tubes.h"

namespace reliefui {

namespace {

constexpr double kRadius = 0.0035;  // of the ray, relative to the scene's diagonal
constexpr double kSleeve = 2.1;     // relative to the ray's radius
constexpr double kChosen = 3.2;

}  // namespace

TraceMarks::TraceMarks(const TraceScene& scene, const relief::HeightField& field, const Style& style,
                       const StepPaint& paint)
    : scene_(scene),
      field_(field),
      style_(style),
      paint_(paint),
      radius_(kRadius * scene.diagonal() * (style.projector ? 1.7 : 1)) {}

vtkSmartPointer<vtkActor> TraceMarks::line(vtkSmartPointer<vtkPolyData> data, Role role, double width) const {
    auto actor = actorOf(data);
    actor->GetProperty()->SetLighting(false);
    const double fine = style_.screenPixelsPerPoint / Style().screenPixelsPerPoint;
    actor->GetProperty()->SetLineWidth(static_cast<float>(width * fine * (style_.projector ? 3 : 1)));
    paintIn(actor, style_.color(role));
    return actor;
}

vtkSmartPointer<vtkActor> TraceMarks::ray() const {
    Tubes tubes;
    tubes.add(scene_.rayTop(), scene_.onRay(scene_.end), radius_, style_.color(Role::Ray));
    auto actor = actorOf(tubes.take());
    shadeWeakly(actor);
    return actor;
}

std::vector<TraceMarks::Sleeve> TraceMarks::sleeves(const std::vector<relief::Step>& steps, std::size_t chosen,
                                                    bool later) const {
    constexpr std::size_t kMost = 400;
    constexpr double kGap = 0.04;  // between two sleeves, so that the ray is visible
    // Sleeves of successive refinements enclose each other.
    constexpr int kMostNested = 5;
    constexpr double kWiden = 0.3;
    int nested = 0;
    std::vector<Sleeve> sleeves;
    const std::size_t first = later ? chosen + 1 : (chosen > kMost ? chosen - kMost : 0);
    const std::size_t last = std::min(steps.size(), later ? chosen + kMost : chosen + 1);
    for (std::size_t k = first; k < last; ++k) {
        const relief::Step& step = steps[k];
        if (!coversStretch(step.decision)) continue;
        const bool after = k > 0 && steps[k - 1].decision == relief::Decision::Refine;
        nested = after ? std::min(nested + 1, kMostNested) : 0;
        // The hit of a refinement does not cover the refinement's sleeve.
        if (after && step.decision == relief::Decision::Hit) continue;
        const double out = std::min(step.decision == relief::Decision::Hit ? step.lambdaAfter : step.lambdaOut, 1.0);
        const Place from = scene_.onRay(std::min(step.lambdaIn, scene_.end));
        const Place to = scene_.onRay(step.decision == relief::Decision::Refine ? out : std::min(out, scene_.end));
        sleeves.push_back({between(from, to, kGap), between(from, to, 1 - kGap), (kSleeve + kWiden * nested) * radius_,
                           paint_.color(step, style_)});
    }
    return sleeves;
}

TraceMarks::Sleeve TraceMarks::sleeve(const relief::Step& step) const {
    const double out = std::min(step.decision == relief::Decision::Hit ? step.lambdaAfter : step.lambdaOut, 1.0);
    return {scene_.onRay(step.lambdaIn), scene_.onRay(out), kChosen * radius_, paint_.color(step, style_)};
}

vtkSmartPointer<vtkActor> TraceMarks::stretches(const std::vector<relief::Step>& steps, std::size_t chosen,
                                                bool later) const {
    Tubes tubes;
    for (const Sleeve& s : sleeves(steps, chosen, later)) tubes.add(s.from, s.to, s.radius, s.color);
    auto actor = actorOf(tubes.take());
    shadeWeakly(actor);
    if (later) actor->GetProperty()->SetOpacity(kLaterOpacity);
    return actor;
}

vtkSmartPointer<vtkActor> TraceMarks::stretch(const relief::Step& step) const {
    Tubes tubes;
    const Sleeve s = sleeve(step);
    tubes.add(s.from, s.to, s.radius, s.color);
    auto actor = actorOf(tubes.take());
    shadeWeakly(actor);
    return actor;
}

vtkSmartPointer<vtkActor> TraceMarks::curtain() const {
    constexpr int kSamples = 256;
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (int k = 0; k <= kSamples; ++k) {
        const double lambda = scene_.end * k / kSamples;
        points->InsertNextPoint(scene_.onRay(lambda).data());
        points->InsertNextPoint(scene_.underRay(lambda).data());
    }
    for (vtkIdType k = 0; k < 2 * kSamples; k += 2) {
        const vtkIdType quad[4] = {k, k + 1, k + 3, k + 2};
        cells->InsertNextCell(4, quad);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    auto actor = actorOf(data);
    actor->GetProperty()->SetLighting(false);
    actor->GetProperty()->SetOpacity(kCurtainOpacity);
    paintIn(actor, style_.color(Role::Ray));
    return actor;
}

vtkSmartPointer<vtkActor> TraceMarks::shadow() const {
    constexpr int kSamples = 256;
    std::vector<Place> places;
    for (int k = 0; k <= kSamples; ++k) {
        places.push_back(scene_.underRay(scene_.end * k / kSamples));
        places.back()[2] += radius_;
    }
    auto actor = line(lineThrough(places, false), Role::Ray, 2);
    actor->GetMapper()->SetResolveCoincidentTopologyToPolygonOffset();
    actor->GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, -300);
    return actor;
}

TraceMarks::Prism TraceMarks::prism(const relief::Step& step, const relief::MaxPyramidMap& maxima) const {
    const auto z = [&](double height) { return std::max(scene_.bottom, std::min(height, 1.0) * scene_.scale); };
    const Box sides = stepBox(field_, step, scene_.baseLevel);
    if (liesInVoxel(step)) {
        const VoxelHeights heights = voxelHeights(step);
        return {sides, z(heights.low), z(heights.high), paint_.color(step, style_)};
    }
    double height = step.value;
    if (const auto* const texel = step.as<relief::subject::Texel>()) {
        height = texel->maximum;
    } else if (!valueIsHeight(step)) {
        const relief::CellGrid grid(field_);
        const auto i = static_cast<int>(std::clamp<std::int64_t>(step.i - grid.x.firstName, 0, grid.x.cells - 1));
        const auto j = static_cast<int>(std::clamp<std::int64_t>(step.j - grid.y.firstName, 0, grid.y.cells - 1));
        height = static_cast<double>(maxima.tiled ? maxima.tiled->maximum(0, i, j) : maxima.pyramid.level(0)(i, j));
    }
    return {sides, scene_.bottom, z(height), paint_.color(step, style_)};
}

std::vector<std::array<Place, 4>> TraceMarks::faces(const Prism& prism) const {
    // A face coplanar with the cut side of the block would flicker.
    constexpr double kOutside = 0.0015;
    const Box inside = prism.sides.cut(scene_.patch);
    if (inside.width() <= 0 || inside.height() <= 0) return {};
    const Box b = inside.grown(kOutside * scene_.diagonal());
    std::array<Place, 8> corners;
    std::size_t n = 0;
    for (const double z : {prism.low, prism.high}) {
        corners[n++] = {b.x0, -b.y0, z};
        corners[n++] = {b.x1, -b.y0, z};
        corners[n++] = {b.x1, -b.y1, z};
        corners[n++] = {b.x0, -b.y1, z};
    }
    constexpr std::size_t kFaces[5][4] = {{4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    std::vector<std::array<Place, 4>> faces;
    for (const auto& f : kFaces) faces.push_back({corners[f[0]], corners[f[1]], corners[f[2]], corners[f[3]]});
    return faces;
}

vtkSmartPointer<vtkActor> TraceMarks::box(const Prism& prism) const {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& face : faces(prism)) {
        vtkIdType quad[4];
        for (std::size_t k = 0; k < 4; ++k) quad[k] = points->InsertNextPoint(face[k].data());
        cells->InsertNextCell(4, quad);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    auto actor = actorOf(data);
    actor->GetProperty()->SetLighting(false);
    actor->GetProperty()->SetOpacity(kPrismOpacity);
    paintIn(actor, prism.color);
    return actor;
}

std::vector<std::array<Place, 2>> TraceMarks::edges(const Prism& prism) const {
    const Box& whole = prism.sides;
    const Box b = whole.cut(scene_.patch);
    if (b.width() <= 0 || b.height() <= 0) return {};
    std::vector<std::array<Place, 2>> edges;
    // Sides at the end of the patch are not borders of the texel.
    const bool left = b.x0 == whole.x0;
    const bool right = b.x1 == whole.x1;
    const bool far = b.y0 == whole.y0;
    const bool near = b.y1 == whole.y1;
    const double low = prism.low;
    const double high = prism.high;
    const auto edge = [&](bool there, const Place& from, const Place& to) {
        if (there) edges.push_back({from, to});
    };
    for (const double z : {low, high}) {
        edge(far, {b.x0, -b.y0, z}, {b.x1, -b.y0, z});
        edge(near, {b.x0, -b.y1, z}, {b.x1, -b.y1, z});
        edge(left, {b.x0, -b.y0, z}, {b.x0, -b.y1, z});
        edge(right, {b.x1, -b.y0, z}, {b.x1, -b.y1, z});
    }
    edge(left && far, {b.x0, -b.y0, low}, {b.x0, -b.y0, high});
    edge(right && far, {b.x1, -b.y0, low}, {b.x1, -b.y0, high});
    edge(left && near, {b.x0, -b.y1, low}, {b.x0, -b.y1, high});
    edge(right && near, {b.x1, -b.y1, low}, {b.x1, -b.y1, high});
    return edges;
}

vtkSmartPointer<vtkActor> TraceMarks::boxEdges(const Prism& prism) const {
    Tubes tubes;
    for (const auto& [from, to] : edges(prism)) tubes.add(from, to, kEdge * radius_, prism.color);
    auto actor = actorOf(tubes.take());
    shadeWeakly(actor);
    return actor;
}

std::vector<vtkSmartPointer<vtkActor>> TraceMarks::hitRing(vtkCamera* camera, double lambda) const {
    struct Disk {
        double inner;
        double outer;
        Rgba color;
        double nearer;
    };
    constexpr Disk kDisks[2] = {{0, kHitDisk, {255, 255, 255, 255}, -40000},
                                {kHitInner, kHitOuter, {0, 0, 0, 255}, -60000}};
    std::vector<vtkSmartPointer<vtkActor>> ring;
    const Place at = scene_.onRay(lambda);
    for (const Disk& disk : kDisks) {
        auto source = vtkSmartPointer<vtkDiskSource>::New();
        source->SetInnerRadius(disk.inner * radius_);
        source->SetOuterRadius(disk.outer * radius_);
        source->SetCircumferentialResolution(36);
        source->Update();
        auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
        mapper->SetInputData(source->GetOutput());
        mapper->SetResolveCoincidentTopologyToPolygonOffset();
        mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, disk.nearer);
        auto actor = vtkSmartPointer<vtkFollower>::New();
        actor->SetMapper(mapper);
        actor->SetCamera(camera);
        actor->SetPosition(at[0], at[1], at[2]);
        actor->GetProperty()->SetLighting(false);
        paintIn(actor, disk.color);
        ring.push_back(actor);
    }
    return ring;
}

vtkSmartPointer<vtkTextActor> TraceMarks::words(const Place& at, const std::string& text, Role role,
                                                double size) const {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    // Leading spaces separate the text from its place.
    std::string spaced = " ";
    spaced += text;
    spaced += ' ';
    actor->SetInput(spaced.c_str());
    actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    actor->GetPositionCoordinate()->SetValue(at[0], at[1], at[2]);
    setText(actor->GetTextProperty(), style_.color(role), style_.textPixels(size));
    const Rgba ground = style_.background();
    actor->GetTextProperty()->SetBackgroundColor(ground.r / 255.0, ground.g / 255.0, ground.b / 255.0);
    actor->GetTextProperty()->SetBackgroundOpacity(0.7);
    return actor;
}

Place TraceMarks::labelPlace(const relief::Step& step) const {
    const double out = std::min(step.decision == relief::Decision::Hit ? step.lambdaAfter : step.lambdaOut, scene_.end);
    return scene_.onRay((step.lambdaIn + out) / 2);
}

}  // namespace reliefui
