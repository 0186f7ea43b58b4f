#include "views/trace3d_scene.h"

#include <array>
#include <cmath>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include "filtering/sampler.h"
#include "images/files.h"

namespace reliefui {

namespace {

// Of the patch around the ray, as a share of the ray's own extent, and at least so many texels.
constexpr double kMarginShare = 0.4;
constexpr double kMarginTexels = 10;

vtkSmartPointer<vtkUnsignedCharArray> colorArray() {
    auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->SetNumberOfComponents(3);
    return colors;
}

vtkSmartPointer<vtkPolyData> polyLine(const std::vector<std::array<double, 3>>& places, bool closed) {
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

}  // namespace

TraceScene::TraceScene(const Snapshot& snapshot, double exaggeration)
    : path(snapshot.request->field, snapshot.trace.ray), snapshot_(snapshot), field_(snapshot.request->field) {
    // A slab without thickness is drawn as a sheet.
    scale = std::max(field_.slabTexels() * exaggeration, 1e-6 * field_.width());
    const PixelTrace& trace = snapshot.trace;
    if (trace.hit.outcome == relief::Outcome::Hit) {
        end = trace.hit.lambda;
    } else if (!trace.steps.empty()) {
        end = trace.steps.back().lambdaOut;
    }
    const Point from = path.at(0);
    const Point to = path.at(end);
    const Box extent{std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x), std::max(from.y, to.y)};
    const double margin = std::max(kMarginTexels, kMarginShare * std::hypot(extent.width(), extent.height()));
    patch = extent.grown(margin);
    if (field_.address() != relief::Address::Repeat) patch = patch.cut(texelDomain(field_).grown(kMarginTexels));
    if (field_.address() == relief::Address::Border) patch = patch.cut(texelDomain(field_));
    patch = {std::floor(patch.x0), std::floor(patch.y0), std::ceil(patch.x1), std::ceil(patch.y1)};
    bottom = scale * lowest();
}

double TraceScene::lowest() const {
    constexpr int kLooks = 64;
    double low = 1;
    for (int j = 0; j <= kLooks; ++j) {
        for (int i = 0; i <= kLooks; ++i) {
            low =
                std::min(low, field_.at(patch.x0 + patch.width() * i / kLooks, patch.y0 + patch.height() * j / kLooks));
        }
    }
    constexpr double kUnder = 0.06;
    return std::max(0.0, low - kUnder);
}

void TraceScene::position(double lambda, double out[3]) const {
    const Point p = path.at(lambda);
    out[0] = p.x;
    out[1] = -p.y;
    out[2] = (1 - lambda) * scale;
}

void TraceScene::color(double s, double t, double height, unsigned char out[3]) const {
    relief::Color c(static_cast<float>(0.25 + 0.5 * height));
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
    const double longer = std::max(patch.width(), patch.height());
    const int step = std::max(1, static_cast<int>(std::ceil(longer / kPatchSamples)));
    const int columns = std::max(1, static_cast<int>(std::ceil(patch.width() / step)));
    const int rows = std::max(1, static_cast<int>(std::ceil(patch.height() / step)));
    return field_.surface() == relief::Surface::Bilinear ? surface(step, columns, rows) : boxes(step, columns, rows);
}

vtkSmartPointer<vtkPolyData> TraceScene::surface(int step, int columns, int rows) const {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    auto colors = colorArray();
    // Nodes of the bilinear surface lie at texel centres.
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const double s = patch.x0 + i * step + 0.5;
            const double t = patch.y0 + j * step + 0.5;
            const double height = field_.at(s, t);
            points->InsertNextPoint(s, -t, height * scale);
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
    return data;
}

vtkSmartPointer<vtkPolyData> TraceScene::boxes(int step, int columns, int rows) const {
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    auto colors = colorArray();
    const auto height = [&](int i, int j) {
        return field_.texel(static_cast<std::int64_t>(patch.x0) + i * step,
                            static_cast<std::int64_t>(patch.y0) + j * step);
    };
    const auto quad = [&](const std::array<std::array<double, 3>, 4>& corners, const unsigned char rgb[3]) {
        vtkIdType ids[4];
        for (std::size_t k = 0; k < 4; ++k) ids[k] = points->InsertNextPoint(corners[k].data());
        cells->InsertNextCell(4, ids);
        colors->InsertNextTypedTuple(rgb);
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const double x0 = patch.x0 + i * step;
            const double x1 = x0 + step;
            const double y0 = -(patch.y0 + j * step);
            const double y1 = y0 - step;
            const double z = height(i, j) * scale;
            unsigned char rgb[3];
            color(x0 + 0.5 * step, -y0 + 0.5 * step, height(i, j), rgb);
            quad({{{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}}}, rgb);
            // Walls to the neighbours on the right and below: each wall once.
            if (i + 1 < columns) {
                const double other = height(i + 1, j) * scale;
                if (other != z) quad({{{x1, y0, z}, {x1, y1, z}, {x1, y1, other}, {x1, y0, other}}}, rgb);
            }
            if (j + 1 < rows) {
                const double other = height(i, j + 1) * scale;
                if (other != z) quad({{{x0, y1, z}, {x1, y1, z}, {x1, y1, other}, {x0, y1, other}}}, rgb);
            }
        }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetCellData()->SetScalars(colors);
    return data;
}

vtkSmartPointer<vtkPolyData> TraceScene::slabFrame() const {
    return polyLine({{{patch.x0, -patch.y0, scale}},
                     {{patch.x1, -patch.y0, scale}},
                     {{patch.x1, -patch.y1, scale}},
                     {{patch.x0, -patch.y1, scale}}},
                    true);
}

vtkSmartPointer<vtkPolyData> TraceScene::ray() const {
    constexpr double kAbove = 0.12;  // of the way it goes in the slab
    std::array<double, 3> from{};
    std::array<double, 3> to{};
    position(-kAbove * std::max(end, 0.2), from.data());
    position(end, to.data());
    return polyLine({from, to}, false);
}

vtkSmartPointer<vtkPolyData> TraceScene::stretch(const relief::Step& step) const {
    std::array<double, 3> from{};
    std::array<double, 3> to{};
    position(step.lambdaIn, from.data());
    position(std::min(step.decision == relief::Decision::Hit ? step.lambdaAfter : step.lambdaOut, end), to.data());
    return polyLine({from, to}, false);
}

vtkSmartPointer<vtkPolyData> TraceScene::point(double lambda) const {
    std::array<double, 3> at{};
    position(lambda, at.data());
    auto data = polyLine({at}, false);
    auto vertices = vtkSmartPointer<vtkCellArray>::New();
    const vtkIdType id = 0;
    vertices->InsertNextCell(1, &id);
    data->SetLines(nullptr);
    data->SetVerts(vertices);
    return data;
}

vtkSmartPointer<vtkPolyData> TraceScene::box(const relief::Step& step) const {
    // Texels larger than the patch are shown as far as it goes.
    const Box base = stepBox(field_, step).cut(patch);
    auto points = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    auto data = vtkSmartPointer<vtkPolyData>::New();
    if (!base.empty()) {
        for (const double z : {bottom, std::max(bottom, step.value * scale)}) {
            points->InsertNextPoint(base.x0, -base.y0, z);
            points->InsertNextPoint(base.x1, -base.y0, z);
            points->InsertNextPoint(base.x1, -base.y1, z);
            points->InsertNextPoint(base.x0, -base.y1, z);
        }
        constexpr vtkIdType kFaces[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
        for (const auto& face : kFaces) cells->InsertNextCell(4, face);
    }
    data->SetPoints(points);
    data->SetPolys(cells);
    return data;
}

}  // namespace reliefui
