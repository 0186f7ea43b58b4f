// The painter of all drawings: on the screen, in pictures, SVG (QSvgGenerator) and PDF (QPdfWriter). Needs no display.
#pragma once

#include <vector>

#include <QPainter>

#include "painting/cell_pictures.h"

namespace reliefui {

inline QColor toColor(const Rgba& c) {
    return {c.r, c.g, c.b, c.a};
}

// Around drawings, on screen and on pages; points.
inline constexpr double kFigureMargin = 6;

// Paints what lies within `screen` (pixels of the painter). `kept`: on a screen, the cache of images for repeated
// painting; null for files.
void paint(QPainter& painter, const Drawing& drawing, const ViewMap& map, const Style& style, const Box& screen,
           CellPictures* kept = nullptr);

// Where the legend of a page lies.
ViewMap legendMap(const Drawing& legend, const Box& page, const Style& style);
// What of the page a figure's drawing gets beside this legend.
Box figureRoom(const Drawing& legend, const Box& page, const Style& style);

// A figure: the layers one over the other, fitted into the page, and the legend below them.
void paintFigure(QPainter& painter, const std::vector<const Drawing*>& layers, const Drawing& legend, const Box& page,
                 const Style& style);

}  // namespace reliefui
