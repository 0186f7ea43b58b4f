// A big grid of values on the graphics card: of what is seen of it as much as the screen can show, made anew where
// something else is seen.
#pragma once

#include <vtkNew.h>

#include "drawings/style.h"
#include "drawings/view_map.h"

class vtkImageData;
class vtkPoints;
class vtkFloatArray;
class vtkPolyData;
class vtkPolyDataMapper2D;
class vtkTexture;
class vtkTexturedActor2D;
class vtkViewport;
class vtkWindow;

namespace reliefui {

class VtkCellTexture {
  public:
    VtkCellTexture(const Cells& cells, const Style& style);
    ~VtkCellTexture();
    VtkCellTexture(const VtkCellTexture&) = delete;
    VtkCellTexture& operator=(const VtkCellTexture&) = delete;

    // Made from these very values in these colours?
    bool serves(const Cells& cells, const Style& style) const;
    // Draws the part of the cells that lies in `screen` (pixels, y downwards, of a window `height` pixels high).
    void draw(const Cells& cells, const ViewMap& map, const Style& style, const Box& screen, int height,
              vtkViewport* viewport);
    void release(vtkWindow* window);

    bool used = false;  // since the painter last looked

  private:
    void make(const Cells& cells, const Style& style, const CellRange& seen, int step);

    std::shared_ptr<const relief::FloatImage> values_;
    ColorMap map_;
    HeightColors heights_;
    Theme theme_;
    double low_;
    double high_;
    CellRange range_;  // of the cells that the texture shows; empty: it was not made yet
    int step_ = 1;
    int width_ = 0;
    int height_ = 0;
    vtkNew<vtkImageData> image_;
    vtkNew<vtkTexture> texture_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkFloatArray> coordinates_;
    vtkNew<vtkPolyData> quad_;
    vtkNew<vtkPolyDataMapper2D> mapper_;
    vtkNew<vtkTexturedActor2D> actor_;
};

}  // namespace reliefui
