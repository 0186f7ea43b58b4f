// Drawings in a vtkContext scene: the two-dimensional panes. One painter a window; it keeps what is on the graphics
// card from one frame to the next.
#pragma once

#include <memory>
#include <vector>

#include "drawings/style.h"
#include "drawings/view_map.h"

class vtkContext2D;
class vtkViewport;
class vtkWindow;

namespace reliefui {

class VtkCellTexture;

class VtkContextPainter {
  public:
    VtkContextPainter();
    ~VtkContextPainter();

    // A frame: begin, any number of paint, end. width, height: of the window, pixels.
    void begin(vtkContext2D* context, vtkViewport* viewport, int width, int height);
    void paint(const Drawing& drawing, const ViewMap& map, const Style& style);
    // Forgets what this frame did not use.
    void end(vtkWindow* window);

  private:
    struct Pass;

    vtkContext2D* context_ = nullptr;
    vtkViewport* viewport_ = nullptr;
    int width_ = 0;
    int height_ = 0;
    std::vector<std::unique_ptr<VtkCellTexture>> textures_;
};

}  // namespace reliefui
