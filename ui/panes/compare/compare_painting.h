// The comparison as it is painted on the screen and into figures.
#pragma once

#include <functional>

#include <QPainter>

#include "painting/style.h"
#include "painting/view_map.h"
#include "panes/compare/compare_data.h"

namespace reliefui {

// Layout and pictures in a page of the painter's units; the legend below.
struct ComparePage {
    CompareLayout layout;
    Drawing legend;
    Box room;                // of the layout, in the painter's units
    double leastHeight = 0;  // of the page, below which pictures are too small; in the painter's units
};
// whole: the legend has all the room that it wants; else no more than a pane can spare.
ComparePage comparePage(const CompareSource& source, const Box& page, const Style& style, bool whole);
// For a screen. place: where the whole picture lies for a room.
void paintCompare(QPainter& painter, const ComparedView& view, const relief::Comparison& how, const ComparePage& parts,
                  const Box& page, const Style& style, std::optional<relief::PixelChoice> pixel,
                  const std::function<QRectF(const QRectF& room)>& place);
// For a page, with pictures that were rendered for it: each of their pixels is there as it is, on a page of pixels
// once.
void paintRedrawn(QPainter& painter, const std::vector<QImage>& pictures, const ComparePage& parts, const Box& page,
                  const Style& style, const relief::Scenario& scenario);

}  // namespace reliefui
