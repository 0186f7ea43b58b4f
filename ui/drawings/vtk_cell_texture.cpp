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
#include "workspace/pause_log.h"

namespace reliefui {

VtkCellTexture::VtkCellTexture(const Cells& cells, const Style& style)
    : values_(cells.values),
      map_(cells.map),
      heights_(style.heights),
      theme_(style.theme),
      low_(cells.low),
      high_(cells.high) {
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

// With something around what is seen, so that not every move makes it anew; a large part of a large grid alone.
void VtkCellTexture::make(const Cells& cells, const Style& style, const CellRange& seen, int step) {
    const PauseLog::Part part("picture of values");
    constexpr int kMostAround = 384;  // pixels
    const int around = std::min(kMostAround * step, std::max(seen.i1 - seen.i0, seen.j1 - seen.j0) / 2);
    // Begins at whole pixels, whatever is seen: a move does not make the picture crawl.
    const auto first = [&](int at) { return std::max(0, at - around) / step * step; };
    range_ = {first(seen.i0), first(seen.j0), std::min(cells.values->width(), seen.i1 + around),
              std::min(cells.values->height(), seen.j1 + around)};
    const CellImage pixels = cellImage(cells, style, range_, step);
    step_ = step;
    width_ = pixels.width;
    height_ = pixels.height;
    image_->SetDimensions(width_, height_, 1);
    image_->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    std::copy(pixels.rgb.begin(), pixels.rgb.end(), static_cast<std::uint8_t*>(image_->GetScalarPointer()));
    image_->Modified();
}

VtkCellTexture::~VtkCellTexture() = default;

bool VtkCellTexture::serves(const Cells& cells, const Style& style) const {
    return values_ == cells.values && map_ == cells.map && low_ == cells.low && high_ == cells.high &&
           (map_ != ColorMap::Height || heights_ == style.heights) &&
           (map_ != ColorMap::Distance || theme_ == style.theme) &&
           (map_ != ColorMap::Difference || theme_ == style.theme);
}

void VtkCellTexture::draw(const Cells& cells, const ViewMap& map, const Style& style, const Box& screen, int height,
                          vtkViewport* viewport) {
    used = true;
    const Box visible = map.toDrawing(screen);
    const Box seen = cells.clip.cut(visible);
    const CellRange range = visibleCells(cells, visible);
    if (seen.empty() || range.count() <= 0) return;
    // Up to twice as fine as the screen; never more than this.
    constexpr double kMostPixels = double{1 << 22};
    const double side = std::min(cells.cellWidth, cells.cellHeight) * map.scale;
    int step = 1;
    while (2 * step * side < 1 || static_cast<double>(range.count()) > kMostPixels * step * step) step *= 2;
    const bool holds = range.i0 >= range_.i0 && range.j0 >= range_.j0 && range.i1 <= range_.i1 && range.j1 <= range_.j1;
    if (!holds || step != step_) make(cells, style, range, step);
    const bool shrunk = cells.cellWidth * step_ * map.scale < 1;
    if (shrunk != (texture_->GetInterpolate() != 0)) texture_->SetInterpolate(shrunk);
    const Box at = map.toScreen(seen);
    const double spanX = cells.cellWidth * step_ * width_;
    const double spanY = cells.cellHeight * step_ * height_;
    const double startX = cells.x + range_.i0 * cells.cellWidth;
    const double startY = cells.y + range_.j0 * cells.cellHeight;
    const double u0 = (seen.x0 - startX) / spanX;
    const double u1 = (seen.x1 - startX) / spanX;
    const double v0 = (seen.y0 - startY) / spanY;
    const double v1 = (seen.y1 - startY) / spanY;
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
