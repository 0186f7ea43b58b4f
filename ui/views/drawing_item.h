// Drawings as an item of a VTK scene, painted when VTK asks.
#pragma once

#include <memory>
#include <vector>

#include <vtkContextItem.h>

#include "drawings/vtk_context_painter.h"

class vtkRenderer;

namespace reliefui {

class DrawingItem : public vtkContextItem {
  public:
    // The macro takes no semicolon of its own.
    vtkTypeMacro(DrawingItem, vtkContextItem) static DrawingItem* New();

    bool Paint(vtkContext2D* context) override;

    std::vector<std::shared_ptr<const Drawing>> layers;
    std::shared_ptr<const Drawing> legend;
    ViewMap map;
    ViewMap legendMap;
    Style style;
    vtkRenderer* renderer = nullptr;
    int width = 0;  // of the renderer, pixels
    int height = 0;
    VtkContextPainter painter;
};

}  // namespace reliefui
