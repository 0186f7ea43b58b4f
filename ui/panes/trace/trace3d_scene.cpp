#include "panes/trace/trace3d_scene.h"

#include <cmath>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include "filtering/sampler.h"
#include "relief/files.h"

namespace reliefui {

namespace {

// Margin of the patch around the ray, relative to the ray's extent, with a minimum in texels.
constexpr double kMarginShare = 0.35;
constexpr double kMarginTexels = 8;

vtkSmartPointer<vtkUnsignedCharArray> colorArray() {
    auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->SetNumberOfComponents(3);
    return colors;
}

}  // namespace

vtkSmartPointer<vtkPolyData> lineThrough(const std::vector<Place>& places, bool closed) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto lines = vtkSmartPointer<vtkCellArray>::New();
    for (const auto& place : places) points->InsertNextPoint(place.data());
    const auto count = static_cast<vtkIdType>(places.size());
    lines->InsertNextCell(static_cast<int>(count + (closed ? 1 : 0)));
    for (vtkIdType i = 0; i < count; ++i) lines->InsertCellPoint(i);
    if (closed) lines->InsertCellPoint(0);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    return data;
}

std::vector<double> sampleLines(double low, double high, int fine, int stride, bool middles) {
    std::vector<double> at{low};
    const double step = static_cast<double>(stride) / fine;
    const double first = middles && step == 1 ? low + 0.5 : low + step;
    for (int k = 0; first + k * step < high; ++k) at.push_back(first + k * step);
    at.push_back(high);
    return at;
}

TraceScene::TraceScene(const Snapshot& snapshot, double exaggeration)
    : path(snapshot.request->field, snapshot.trace.ray), snapshot_(snapshot), field_(snapshot.request->field) {
    // A slab without thickness is drawn as a flat sheet.
    scale = std::max(field_.slabTexels() * exaggeration, 1e-6 * field_.width());
    const PixelTrace& trace = snapshot.trace;
    baseLevel = trace.baseLevel;
    if (trace.hit.outcome == relief::Outcome::Hit) {
        end = trace.hit.lambda;
    } else if (!trace.steps.empty()) {
        end = std::clamp(trace.steps.back().lambdaOut, 0.0, 1.0);
    }
    const Point from = path.at(0);
    const Point to = path.at(end);
    const Box extent{std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x), std::max(from.y, to.y)};
    // For a small map, the minimum is reduced, so that the patch does not mainly consist of its copies.
    const double least = std::min(kMarginTexels, std::ceil(0.25 * std::min(field_.width(), field_.height())));
    const double margin = std::max(least, kMarginShare * std::hypot(extent.width(), extent.height()));
    patch = extent.grown(margin);
    if (field_.address() == relief::Address::Border) patch = patch.cut(texelDomain(field_));
    if (field_.address() == relief::Address::Clamp) patch = patch.cut(texelDomain(field_).grown(kMarginTexels));
    // A ray that ends outside the picture gets the whole picture as its patch.
    if (patch.empty() || patch.width() < 1 || patch.height() < 1) patch = texelDomain(field_);
    patch = {std::floor(patch.x0), std::floor(patch.y0), std::ceil(patch.x1), std::ceil(patch.y1)};
    bottom = foot();
}

// Z of the block's bottom: below the lowest point of the patch, but limited so that the block is not much higher than
// wide, because a single pit would make everything else small.
double TraceScene::foot() const {
    constexpr int kSamplesPerSide = 64;
    constexpr double kUnder = 0.06;   // relative to the slab
    constexpr double kHighest = 0.5;  // relative to the block's width
    constexpr double kDeep = 0.1;     // relative to the block's width, below the ray's end
    double low = 1;
    for (int j = 0; j <= kSamplesPerSide; ++j) {
        for (int i = 0; i <= kSamplesPerSide; ++i) {
            const double s = patch.x0 + patch.width() * i / kSamplesPerSide;
            low = std::min(low, field_.at(s, patch.y0 + patch.height() * j / kSamplesPerSide));
        }
    }
    double underRay = (1 - end) * scale;
    for (int k = 0; k <= kSamplesPerSide; ++k) underRay = std::min(underRay, underRayAt(end * k / kSamplesPerSide));
    const double width = std::hypot(patch.width(), patch.height());
    return std::max({0.0, (low - kUnder) * scale, std::min(scale - kHighest * width, underRay - kDeep * width)});
}

double TraceScene::underRayAt(double lambda) const {
    const Point p = path.at(lambda);
    return heightAt(p.x, p.y);
}

double TraceScene::diagonal() const {
    return std::hypot(patch.width(), patch.height(), scale - bottom);
}

Place TraceScene::onRay(double lambda) const {
    const Point p = path.at(lambda);
    return {p.x, -p.y, (1 - lambda) * scale};
}

Place TraceScene::underRay(double lambda) const {
    const Point p = path.at(lambda);
    return {p.x, -p.y, underRayAt(lambda)};
}

Place TraceScene::rayTop() const {
    // relative to the scene's diagonal; long enough to be visible if the hit is just below the top
    constexpr double kAbove = 0.14;
    return onRay(-kAbove * diagonal() / std::hypot(path.run.x, path.run.y, scale));
}

// Keeps the viewing direction, and chooses the distance so that the ray and the patch around it are visible. The
// visible depth below the hit is limited to a third of the ray's descent.
void TraceScene::fit(Turntable& camera, double aspect) const {
    double low = bottom;
    const relief::Hit& hit = snapshot_.trace.hit;
    if (hit.outcome == relief::Outcome::Hit) low = std::max(low, scale * (1 - hit.lambda * 4 / 3));
    std::vector<Place> places;
    for (const double z : {low, scale}) {
        for (const double s : {patch.x0, patch.x1}) {
            for (const double t : {patch.y0, patch.y1}) places.push_back({s, -t, z});
        }
    }
    camera.fit(places, aspect);
}

// Perpendicular to the ray and slightly from behind, so that the ray runs from left to right.
void TraceScene::faceRay(Turntable& camera) const {
    constexpr double kBehind = 0.45;
    const double length = std::hypot(path.run.x, path.run.y);
    const double dx = length > 0 ? path.run.x / length : 1;
    const double dy = length > 0 ? -path.run.y / length : 0;
    camera.lookAlong(-dy + kBehind * dx, dx + kBehind * dy);
}

Place TraceScene::topLabelPlace(const Turntable& camera) const {
    const Place right = camera.right();
    Place leftmost{};
    double least = 0;
    bool first = true;
    for (const double s : {patch.x0, patch.x1}) {
        for (const double t : {patch.y0, patch.y1}) {
            const double along = s * right[0] - t * right[1];
            if (!first && along >= least) continue;
            first = false;
            least = along;
            leftmost = {s, -t, scale};
        }
    }
    return leftmost;
}

void TraceScene::color(double s, double t, double height, unsigned char out[3]) const {
    relief::Color c(static_cast<float>(0.12 + 0.5 * height));
    if (snapshot_.assets.color) {
        const relief::ColorImage& image = *snapshot_.assets.color;
        c = relief::sampleBilinear(image, s * image.width() / field_.width(), t * image.height() / field_.height(),
                                   field_.address());
    }
    for (int k = 0; k < 3; ++k) {
        const float code = 255.0F * relief::srgbFromLinear(std::clamp(c[k], 0.0F, 1.0F));
        out[k] = static_cast<unsigned char>(std::lround(code));
    }
}

vtkSmartPointer<vtkPolyData> TraceScene::relief() const {
    return field_.surface() == relief::Surface::Bilinear ? surface() : boxes();
}

vtkSmartPointer<vtkPolyData> TraceScene::surface() const {
    const double longer = std::max(patch.width(), patch.height());
    int fine = kFinestSamples;
    while (fine > 1 && longer * fine > kPatchSamples) fine /= 2;
    const int stride = std::max(1, static_cast<int>(std::ceil(longer / kPatchSamples)));
    const double step = static_cast<double>(stride) / fine;
    const std::vector<double> across = sampleLines(patch.x0, patch.x1, fine, stride, true);
    const std::vector<double> along = sampleLines(patch.y0, patch.y1, fine, stride, true);
    const int columns = static_cast<int>(across.size()) - 1;
    const int rows = static_cast<int>(along.size()) - 1;
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    auto colors = colorArray();
    auto normals = vtkSmartPointer<vtkFloatArray>::New();
    normals->SetNumberOfComponents(3);
    for (const double t : along) {
        for (const double s : across) {
            const double height = field_.at(s, t);
            points->InsertNextPoint(s, -t, height * scale);
            // On a decimated patch, the slope is that between the samples.
            const double h = std::max(step, 1.0) / 2;
            const double dx = (field_.at(s + h, t) - field_.at(s - h, t)) / (2 * h) * scale;
            const double dy = (field_.at(s, t + h) - field_.at(s, t - h)) / (2 * h) * scale;
            const double length = std::hypot(dx, dy, 1.0);
            normals->InsertNextTuple3(-dx / length, dy / length, 1 / length);
            unsigned char rgb[3];
            color(s, t, height, rgb);
            colors->InsertNextTypedTuple(rgb);
        }
    }
    const auto at = [&](int i, int j) { return static_cast<vtkIdType>(j) * (columns + 1) + i; };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const vtkIdType quad[4] = {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)};
            cells->InsertNextCell(4, quad);
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetScalars(colors);
    data->GetPointData()->SetNormals(normals);
    return data;
}

vtkSmartPointer<vtkPolyData> TraceScene::boxes() const {
    const double longer = std::max(patch.width(), patch.height());
    const int step = std::max(1, static_cast<int>(std::ceil(longer / kPatchSamples)));
    const int columns = std::max(1, static_cast<int>(std::ceil(patch.width() / step)));
    const int rows = std::max(1, static_cast<int>(std::ceil(patch.height() / step)));
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    auto colors = colorArray();
    const auto height = [&](int i, int j) {
        return static_cast<double>(field_.texel(static_cast<std::int64_t>(patch.x0) + i * step,
                                                static_cast<std::int64_t>(patch.y0) + j * step));
    };
    const auto quad = [&](const std::array<Place, 4>& corners, const unsigned char rgb[3]) {
        vtkIdType ids[4];
        for (std::size_t k = 0; k < 4; ++k) ids[k] = points->InsertNextPoint(corners[k].data());
        cells->InsertNextCell(4, ids);
        colors->InsertNextTypedTuple(rgb);
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const double x0 = patch.x0 + i * step;
            const double x1 = std::min(x0 + step, patch.x1);
            const double y0 = -(patch.y0 + j * step);
            const double y1 = std::max(y0 - step, -patch.y1);
            const double z = height(i, j) * scale;
            unsigned char rgb[3];
            color(x0 + 0.5 * step, -y0 + 0.5 * step, height(i, j), rgb);
            quad({{{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}}}, rgb);
            // Walls to the right and lower neighbours, so that each wall is added once.
            const double right = i + 1 < columns ? height(i + 1, j) * scale : z;
            if (right != z) quad({{{x1, y0, z}, {x1, y1, z}, {x1, y1, right}, {x1, y0, right}}}, rgb);
            const double below = j + 1 < rows ? height(i, j + 1) * scale : z;
            if (below != z) quad({{{x0, y1, z}, {x1, y1, z}, {x1, y1, below}, {x0, y1, below}}}, rgb);
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetCellData()->SetScalars(colors);
    return data;
}

vtkSmartPointer<vtkPolyData> TraceScene::skirt() const {
    constexpr int kSamples = 256;
    constexpr double kInside = 1e-6;  // the sides of columns lie exactly on the texel's border
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    const Box edge = patch.grown(-kInside);
    const auto side = [&](Point from, Point to) {
        const vtkIdType first = points->GetNumberOfPoints();
        for (int k = 0; k <= kSamples; ++k) {
            const double f = static_cast<double>(k) / kSamples;
            const double s = from.x + f * (to.x - from.x);
            const double t = from.y + f * (to.y - from.y);
            points->InsertNextPoint(s, -t, std::max(bottom, heightAt(s, t)));
            points->InsertNextPoint(s, -t, bottom);
        }
        for (vtkIdType k = first; k < first + 2 * kSamples; k += 2) {
            const vtkIdType quad[4] = {k, k + 1, k + 3, k + 2};
            cells->InsertNextCell(4, quad);
        }
    };
    side({edge.x0, edge.y0}, {edge.x1, edge.y0});
    side({edge.x1, edge.y0}, {edge.x1, edge.y1});
    side({edge.x1, edge.y1}, {edge.x0, edge.y1});
    side({edge.x0, edge.y1}, {edge.x0, edge.y0});
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

vtkSmartPointer<vtkPolyData> TraceScene::slabFrame() const {
    return lineThrough({{patch.x0, -patch.y0, scale},
                        {patch.x1, -patch.y0, scale},
                        {patch.x1, -patch.y1, scale},
                        {patch.x0, -patch.y1, scale}},
                       true);
}

}  // namespace reliefui
