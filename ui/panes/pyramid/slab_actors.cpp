#include "panes/pyramid/slab_actors.h"

#include <algorithm>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include "painting/cell_image.h"

namespace reliefui {

namespace {

constexpr int kMostPixels = 512;  // a side of a slab's picture

}  // namespace

vtkSmartPointer<vtkPolyData> quadOf(const std::array<std::array<double, 3>, 4>& corners) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (const std::array<double, 3>& corner : corners) points->InsertNextPoint(corner.data());
    auto faces = vtkSmartPointer<vtkCellArray>::New();
    faces->InsertNextCell({0, 1, 2, 3});
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(faces);
    return data;
}

vtkSmartPointer<vtkActor> flatActor(const vtkSmartPointer<vtkPolyData>& data) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLighting(false);
    return actor;
}

vtkSmartPointer<vtkActor> slabPicture(const Cells& cells, const Style& style,
                                      const std::array<std::array<double, 3>, 4>& corners) {
    const CellRange range = visibleCells(cells, cells.clip);
    int step = 1;
    while (std::max(range.i1 - range.i0, range.j1 - range.j0) > kMostPixels * step) step *= 2;
    const CellImage pixels = cellImage(cells, style, range, step);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(pixels.width, pixels.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    std::copy(pixels.rgb.begin(), pixels.rgb.end(), static_cast<std::uint8_t*>(image->GetScalarPointer()));
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(image);
    texture->RepeatOff();
    texture->EdgeClampOn();
    texture->InterpolateOff();
    texture->MipmapOn();
    const double spanX = pixels.width * step * cells.cellWidth;
    const double spanY = pixels.height * step * cells.cellHeight;
    const double u0 = (cells.clip.x0 - cells.x - pixels.i0 * cells.cellWidth) / spanX;
    const double u1 = (cells.clip.x1 - cells.x - pixels.i0 * cells.cellWidth) / spanX;
    const double v0 = (cells.clip.y0 - cells.y - pixels.j0 * cells.cellHeight) / spanY;
    const double v1 = (cells.clip.y1 - cells.y - pixels.j0 * cells.cellHeight) / spanY;
    auto coordinates = vtkSmartPointer<vtkFloatArray>::New();
    coordinates->SetNumberOfComponents(2);
    for (const auto& [u, v] : {std::pair(u0, v0), {u1, v0}, {u1, v1}, {u0, v1}}) coordinates->InsertNextTuple2(u, v);
    auto data = quadOf(corners);
    data->GetPointData()->SetTCoords(coordinates);
    auto actor = flatActor(data);
    actor->SetTexture(texture);
    return actor;
}

}  // namespace reliefui
