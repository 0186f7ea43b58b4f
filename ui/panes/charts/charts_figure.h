// Charts as a figure, and charts measured for one.
#pragma once

#include "panes/charts/charts_drawing.h"
#include "panes/figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

std::shared_ptr<const Figure> chartsFigure(std::shared_ptr<const ChartsSource> source, FigureCaption caption = {});

// The charts pane, measured now: takes seconds. error: as of parseErrorMeasure(). Throws InputError.
std::shared_ptr<const Figure> measuredCharts(std::shared_ptr<const Snapshot> snapshot, const std::string& error);

}  // namespace reliefui
