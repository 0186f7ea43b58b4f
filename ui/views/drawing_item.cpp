#include "views/drawing_item.h"

#include <vtkObjectFactory.h>
#include <vtkRenderer.h>

namespace reliefui {

vtkStandardNewMacro(DrawingItem);

bool DrawingItem::Paint(vtkContext2D* context) {
    painter.begin(context, renderer, width, height);
    for (const auto& layer : layers) painter.paint(*layer, map, style);
    if (legend) painter.paint(*legend, legendMap, style);
    painter.end(renderer->GetVTKWindow());
    return true;
}

}  // namespace reliefui
