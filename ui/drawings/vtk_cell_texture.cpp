#include "drawings/vtk_cell_texture.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>
#include <vtkViewport.h>
#include <vtkWindow.h>

#include "drawings/cell_image.h"

namespace reliefui {

VtkCellTexture::VtkCellTexture(const Cells& cells, const Style& style)
    : values_(cells.values),
      map_(cells.map),
      heights_(style.heights),
      theme_(style.theme),
      low_(cells.low),
      high_(cells.high) {
    const CellImage pixels = cellImage(cells, style);
    step_ = pixels.step;
    width_ = pixels.width;
    height_ = pixels.height;
    image_->SetDimensions(width_, height_, 1);
    image_->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    std::copy(pixels.rgb.begin(), pixels.rgb.end(), static_cast<std::uint8_t*>(image_->GetScalarPointer()));
    texture_->SetInputData(image_);
    texture_->RepeatOff();
    texture_->EdgeClampOn();
    texture_->MipmapOn();
    texture_->InterpolateOff();
    points_->SetNumberOfPoints(4);
    coordinates_->SetNumberOfComponents(2);
    coordinates_->SetNumberOfTuples(4);
    vtkNew<vtkCellArray> faces;
    faces->InsertNextCell({0, 1, 2, 3});
    quad_->SetPoints(points_);
    quad_->SetPolys(faces);
    quad_->GetPointData()->SetTCoords(coordinates_);
    mapper_->SetInputData(quad_);
    actor_->SetMapper(mapper_);
    actor_->SetTexture(texture_);
}

VtkCellTexture::~VtkCellTexture() = default;

bool VtkCellTexture::serves(const Cells& cells, const Style& style) const {
    return values_ == cells.values && map_ == cells.map && low_ == cells.low && high_ == cells.high &&
           (map_ != ColorMap::Height || heights_ == style.heights) &&
           (map_ != ColorMap::Distance || theme_ == style.theme) &&
           (map_ != ColorMap::Difference || theme_ == style.theme);
}

void VtkCellTexture::draw(const Cells& cells, const ViewMap& map, const Box& screen, int height,
                          vtkViewport* viewport) {
    used = true;
    const Box seen = cells.clip.cut(map.toDrawing(screen));
    if (seen.empty()) return;
    const bool shrunk = cells.cellWidth * step_ * map.scale < 1;
    if (shrunk != (texture_->GetInterpolate() != 0)) texture_->SetInterpolate(shrunk);
    const Box at = map.toScreen(seen);
    const double spanX = cells.cellWidth * step_ * width_;
    const double spanY = cells.cellHeight * step_ * height_;
    const double u0 = (seen.x0 - cells.x) / spanX;
    const double u1 = (seen.x1 - cells.x) / spanX;
    const double v0 = (seen.y0 - cells.y) / spanY;
    const double v1 = (seen.y1 - cells.y) / spanY;
    const auto corner = [&](vtkIdType k, double x, double y, double u, double v) {
        points_->SetPoint(k, x, height - y, 0);
        coordinates_->SetTuple2(k, u, v);
    };
    corner(0, at.x0, at.y0, u0, v0);
    corner(1, at.x0, at.y1, u0, v1);
    corner(2, at.x1, at.y1, u1, v1);
    corner(3, at.x1, at.y0, u1, v0);
    points_->Modified();
    coordinates_->Modified();
    quad_->Modified();
    actor_->RenderOverlay(viewport);
}

void VtkCellTexture::release(vtkWindow* window) {
    actor_->ReleaseGraphicsResources(window);
    texture_->ReleaseGraphicsResources(window);
}

}  // namespace reliefui
