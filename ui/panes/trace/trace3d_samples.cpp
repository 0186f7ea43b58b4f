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

std::vector<Place> corners(const TraceScene& scene, double lambda) {
    const double z = (1 - lambda) * scene.scale;
    // Slightly outside the cut sides of the block, which would otherwise hide part of the rim.
    const Box p = scene.patch.grown(kOutside * scene.diagonal());
    return {{p.x0, -p.y0, z}, {p.x1, -p.y0, z}, {p.x1, -p.y1, z}, {p.x0, -p.y1, z}};
}

vtkSmartPointer<vtkActor> sheets(const TraceScene& scene, const std::vector<double>& lambdas, Rgba color,
                                 double opacity) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const double lambda : lambdas) {
        vtkIdType quad[4];
        int k = 0;
        for (const Place& corner : corners(scene, lambda)) quad[k++] = points->InsertNextPoint(corner.data());
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
        const std::vector<Place> rim = corners(scene, lambda);
        for (std::size_t k = 0; k < rim.size(); ++k) tubes.add(rim[k], rim[(k + 1) % rim.size()], radius, color);
    }
    auto actor = actorOf(tubes.take());
    shadeWeakly(actor);
    return actor;
}

// Adds a line from the ray to the height read below it.
void addStem(Tubes& tubes, const TraceScene& scene, double lambda, double height, double radius, Rgba color) {
    const Place onRay = scene.onRay(lambda);
    const Place read{onRay[0], onRay[1], std::max(scene.bottom, height * scene.scale)};
    tubes.add(onRay, read, 0.35 * radius, color);
    tubes.ball(read, 1.5 * radius, color);
}

}  // namespace

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

std::vector<vtkSmartPointer<vtkActor>> sampleMarks(const TraceScene& scene, const std::vector<relief::Step>& steps,
                                                   std::size_t chosen, const StepPaint& paint, const Style& style,
                                                   double radius) {
    constexpr std::size_t kMostStems = 200;
    std::vector<vtkSmartPointer<vtkActor>> marks;
    // Steps that use a map are drawn as spheres or cones instead.
    const bool trusts = std::any_of(steps.begin(), steps.end(), [](const relief::Step& s) { return s.trustsMap(); });
    if (trusts || std::none_of(steps.begin(), steps.end(), isPoint)) return marks;
    std::vector<double> lambdas = sheetLambdas(steps, chosen);
    // Sheets below the bottom of the block are not visible.
    std::erase_if(lambdas, [&](double lambda) { return (1 - lambda) * scene.scale < scene.bottom; });
    const Rgba advanced = style.color(Role::Advanced);
    marks.push_back(sheets(scene, lambdas, advanced, 0.05));
    marks.push_back(rims(scene, lambdas, advanced, 0.25 * radius));
    const relief::Step& step = steps[chosen];
    const Rgba color = paint.color(step, style);
    if (isLayer(steps, chosen)) {
        marks.push_back(sheets(scene, {step.lambdaOut}, color, 0.22));
        marks.push_back(rims(scene, {step.lambdaOut}, color, 0.6 * radius));
    }
    Tubes stems;
    const std::size_t first = chosen > kMostStems ? chosen - kMostStems : 0;
    for (std::size_t k = first; k <= chosen; ++k) {
        if (!isPoint(steps[k]) || !readsHeight(steps[k].decision)) continue;
        const double wide = (k == chosen ? 2.0 : 1.0) * radius;
        addStem(stems, scene, readAt(steps, k), steps[k].value, wide, paint.color(steps[k], style));
    }
    const bool shifted = isPoint(step) && step.decision == Decision::Hit && readAt(steps, chosen) < step.lambdaAfter;
    if (shifted && chosen > 0 && steps[chosen - 1].decision == Decision::Start) {
        const Place entry = scene.onRay(readAt(steps, chosen));
        stems.arrow({entry[0], entry[1], step.value * scene.scale}, scene.onRay(step.lambdaAfter), 1.2 * radius,
                    style.color(Role::Advanced));
    }
    auto actor = actorOf(stems.take());
    shadeWeakly(actor);
    marks.push_back(actor);
    return marks;
}

}  // namespace reliefui
