// The comparison as it is painted on the screen and into figures.
#pragma once

#include <functional>

#include <QPainter>

#include "painting/style.h"
#include "painting/view_map.h"
#include "panes/compare/compare_data.h"

namespace reliefui {

// Layout and pictures in a page of the painter's units; the legend below. place: where the whole picture lies for a
// room; null: fitted into it.
struct ComparePage {
    CompareLayout layout;
    Drawing legend;
    Box room;                // of the layout, in the painter's units
    double leastHeight = 0;  // of the page, below which pictures are too small; in the painter's units
};
ComparePage comparePage(const CompareSource& source, const Box& page, const Style& style);
void paintCompare(QPainter& painter, const ComparedView& view, const relief::Comparison& how, const ComparePage& parts,
                  const Box& page, const Style& style, std::optional<relief::PixelChoice> pixel,
                  const std::function<QRectF(const QRectF& room)>& place);

}  // namespace reliefui
