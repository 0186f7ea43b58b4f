// Painting of the comparison, on the screen and in figures.
#pragma once

#include <functional>

#include <QPainter>

#include "painting/style.h"
#include "painting/view_map.h"
#include "panes/compare/compare_data.h"

namespace reliefui {

// Layout and legend on a page, in the painter's units.
struct ComparePage {
    CompareLayout layout;
    Drawing legend;
    Box room;                // box of the layout, in the painter's units
    double leastHeight = 0;  // smallest page height at which the pictures are large enough; in the painter's units
};
// whole: the legend gets all the room it needs; otherwise only what a pane can spare.
ComparePage comparePage(const CompareSource& source, const Box& page, const Style& style, bool whole);
// Paints on the screen. place: maps a picture's box to the rectangle of the whole picture at the current zoom.
void paintCompare(QPainter& painter, const ComparedView& view, const relief::Comparison& how, const ComparePage& parts,
                  const Box& page, const Style& style, std::optional<relief::PixelChoice> pixel,
                  const std::function<QRectF(const QRectF& room)>& place);
// Paints a page with pictures rendered for it; on a page of pixels, each of their pixels is copied exactly once.
void paintRedrawn(QPainter& painter, const std::vector<QImage>& pictures, const ComparePage& parts, const Box& page,
                  const Style& style, const relief::Scenario& scenario);

}  // namespace reliefui
