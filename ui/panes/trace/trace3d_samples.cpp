#include "panes/trace/trace3d_samples.h"

#include <algorithm>
#include <cmath>

#include <vtkProperty.h>

#include "panes/trace/tubes.h"

namespace reliefui {

namespace {

constexpr double kOutside = 0.003;  // relative to the scene's diagonal

using relief::Decision;

bool isPoint(const relief::Step& step) {
    return step.as<relief::subject::Point>() != nullptr || step.as<relief::subject::Layer>() != nullptr;
}

// Returns true if the step samples a layer, as part of a linear search.
bool isLayer(const std::vector<relief::Step>& steps, std::size_t k) {
    const relief::Step& step = steps[k];
    if (!isPoint(step)) return false;
    if (step.decision == Decision::Advance) return true;
    // The sample of a method that shifts the ray by a single height is not a layer.
    return step.decision == Decision::Hit && !(k > 0 && steps[k - 1].decision == Decision::Start);
}

bool readsHeight(Decision decision) {
    return decision == Decision::Advance || decision == Decision::Hit || decision == Decision::Refine ||
           decision == Decision::Test;
}

vtkSmartPointer<vtkActor> sheets(const TraceScene& scene, const std::vector<double>& lambdas, Rgba color,
                                 double opacity) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const double lambda : lambdas) {
        vtkIdType quad[4];
        int k = 0;
        for (const Place& corner : sheetCorners(scene, lambda)) quad[k++] = points->InsertNextPoint(corner.data());
        cells->InsertNextCell(4, quad);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    auto actor = actorOf(data);
    actor->GetProperty()->SetLighting(false);
    actor->GetProperty()->SetOpacity(opacity);
    paintIn(actor, color);
    return actor;
}

// Outlines of the sheets, so that they can be counted.
vtkSmartPointer<vtkActor> rims(const TraceScene& scene, const std::vector<double>& lambdas, Rgba color, double radius) {
    Tubes tubes;
    for (const double lambda : lambdas) {
        const std::vector<Place> rim = sheetCorners(scene, lambda);
        for (std::size_t k = 0; k < rim.size(); ++k) tubes.add(rim[k], rim[(k + 1) % rim.size()], radius, color);
    }
    auto actor = actorOf(tubes.take());
    shadeWeakly(actor);
    return actor;
}

}  // namespace

std::vector<Place> sheetCorners(const TraceScene& scene, double lambda) {
    const double z = (1 - lambda) * scene.scale;
    // Slightly outside the cut sides of the block, which would otherwise hide part of the rim.
    const Box p = scene.patch.grown(kOutside * scene.diagonal());
    return {{p.x0, -p.y0, z}, {p.x1, -p.y0, z}, {p.x1, -p.y1, z}, {p.x0, -p.y1, z}};
}

double readAt(const std::vector<relief::Step>& steps, std::size_t index) {
    const relief::Step& step = steps[index];
    if (step.decision == Decision::Hit && index > 0 && steps[index - 1].decision == Decision::Start)
        return step.lambdaIn;
    // A bisection reads at the middle, which becomes one end of the interval.
    if (step.decision == Decision::Refine && step.lambdaAfter == step.lambdaIn) return step.lambdaIn;
    return step.lambdaOut;
}

std::vector<double> sheetLambdas(const std::vector<relief::Step>& steps, std::size_t chosen) {
    std::vector<std::size_t> layers;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (isLayer(steps, k)) layers.push_back(k);
    }
    const std::size_t stride = (layers.size() + kMostSheets - 1) / kMostSheets;
    std::vector<double> lambdas;
    for (std::size_t k = 0; k < layers.size(); k += stride) {
        if (layers[k] != chosen) lambdas.push_back(steps[layers[k]].lambdaOut);
    }
    return lambdas;
}

SampleShapes sampleShapes(const TraceScene& scene, const std::vector<relief::Step>& steps, std::size_t chosen,
                          const StepPaint& paint, const Style& style, double radius) {
    constexpr std::size_t kMostStems = 200;
    SampleShapes shapes;
    // Steps that use a map are drawn as spheres or cones instead.
    const bool trusts = std::any_of(steps.begin(), steps.end(), [](const relief::Step& s) { return s.trustsMap(); });
    if (trusts || std::none_of(steps.begin(), steps.end(), isPoint)) return shapes;
    shapes.sheets = sheetLambdas(steps, chosen);
    // Sheets below the bottom of the block are not visible.
    std::erase_if(shapes.sheets, [&](double lambda) { return (1 - lambda) * scene.scale < scene.bottom; });
    const relief::Step& step = steps[chosen];
    shapes.color = paint.color(step, style);
    if (isLayer(steps, chosen)) shapes.chosen = step.lambdaOut;
    const std::size_t first = chosen > kMostStems ? chosen - kMostStems : 0;
    for (std::size_t k = first; k <= chosen; ++k) {
        if (!isPoint(steps[k]) || !readsHeight(steps[k].decision)) continue;
        const Place onRay = scene.onRay(readAt(steps, k));
        const Place read{onRay[0], onRay[1], std::max(scene.bottom, steps[k].value * scene.scale)};
        shapes.stems.push_back({onRay, read, (k == chosen ? 2.0 : 1.0) * radius, paint.color(steps[k], style)});
    }
    const bool shifted = isPoint(step) && step.decision == Decision::Hit && readAt(steps, chosen) < step.lambdaAfter;
    if (shifted && chosen > 0 && steps[chosen - 1].decision == Decision::Start) {
        const Place entry = scene.onRay(readAt(steps, chosen));
        const Place from{entry[0], entry[1], step.value * scene.scale};
        shapes.shift = {from, scene.onRay(step.lambdaAfter), kShift * radius, style.color(Role::Advanced)};
    }
    return shapes;
}

std::vector<vtkSmartPointer<vtkActor>> sampleMarks(const TraceScene& scene, const std::vector<relief::Step>& steps,
                                                   std::size_t chosen, const StepPaint& paint, const Style& style,
                                                   double radius) {
    std::vector<vtkSmartPointer<vtkActor>> marks;
    const SampleShapes shapes = sampleShapes(scene, steps, chosen, paint, style, radius);
    if (shapes.empty()) return marks;
    const Rgba advanced = style.color(Role::Advanced);
    marks.push_back(sheets(scene, shapes.sheets, advanced, kSheetOpacity));
    marks.push_back(rims(scene, shapes.sheets, advanced, kRim * radius));
    if (shapes.chosen) {
        marks.push_back(sheets(scene, {*shapes.chosen}, shapes.color, kChosenSheetOpacity));
        marks.push_back(rims(scene, {*shapes.chosen}, shapes.color, kChosenRim * radius));
    }
    Tubes stems;
    for (const SampleShapes::Stem& stem : shapes.stems) {
        stems.add(stem.from, stem.to, kStem * stem.radius, stem.color);
        stems.ball(stem.to, kStemBall * stem.radius, stem.color);
    }
    if (shapes.shift) stems.arrow(shapes.shift->from, shapes.shift->to, shapes.shift->radius, shapes.shift->color);
    auto actor = actorOf(stems.take());
    shadeWeakly(actor);
    marks.push_back(actor);
    return marks;
}

}  // namespace reliefui
