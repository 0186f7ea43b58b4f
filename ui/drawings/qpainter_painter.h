// Drawings through QPainter: pictures, SVG (QSvgGenerator), PDF (QPdfWriter). Needs no display.
#pragma once

#include <vector>

#include <QPainter>

#include "drawings/style.h"
#include "drawings/view_map.h"

namespace reliefui {

// Paints what lies within `screen` (pixels of the painter).
void paint(QPainter& painter, const Drawing& drawing, const ViewMap& map, const Style& style, const Box& screen);

// What of the page a figure's drawing gets beside this legend.
Box figureRoom(const Drawing& legend, const Box& page, const Style& style);

// A figure: the layers one over the other, fitted into the page, and the legend below them.
void paintFigure(QPainter& painter, const std::vector<const Drawing*>& layers, const Drawing& legend, const Box& page,
                 const Style& style);

}  // namespace reliefui
