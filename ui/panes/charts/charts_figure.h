// The charts as a figure, also measured specifically for one.
#pragma once

#include "panes/charts/charts_drawing.h"
#include "panes/figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

std::shared_ptr<const Figure> chartsFigure(std::shared_ptr<const ChartsSource> source, FigureCaption caption = {});

// The charts pane with measurements made by this call, which takes seconds. error: a name accepted by
// parseErrorMeasure(). Throws InputError.
std::shared_ptr<const Figure> measuredCharts(std::shared_ptr<const Snapshot> snapshot, const std::string& error);

}  // namespace reliefui
