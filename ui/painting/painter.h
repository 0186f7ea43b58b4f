// Paints all drawings: on the screen, into pictures, SVG (QSvgGenerator) and PDF (QPdfWriter). Needs no display.
#pragma once

#include <vector>

#include <QPainter>

#include "painting/cell_pictures.h"

namespace reliefui {

inline QColor toColor(const Rgba& c) {
    return {c.r, c.g, c.b, c.a};
}

// Margin around drawings on screen and on pages, in points.
inline constexpr double kFigureMargin = 6;

// Paints the part of the drawing that lies within `screen` (pixels of the painter). `kept`: on a screen, the cache of
// images for repeated painting; null for files.
void paint(QPainter& painter, const Drawing& drawing, const ViewMap& map, const Style& style, const Box& screen,
           CellPictures* kept = nullptr);

// Position and scale of the legend on a page.
ViewMap legendMap(const Drawing& legend, const Box& page, const Style& style);
// The part of the page that remains for the figure's drawing.
Box figureRoom(const Drawing& legend, const Box& page, const Style& style);

// Paints a figure: the layers on top of each other, fitted to the page, and the legend below them.
void paintFigure(QPainter& painter, const std::vector<const Drawing*>& layers, const Drawing& legend, const Box& page,
                 const Style& style);

}  // namespace reliefui
