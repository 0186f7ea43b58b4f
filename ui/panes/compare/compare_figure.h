// The comparison as a figure.
#pragma once

#include "panes/compare/compare_data.h"
#include "panes/figure.h"

namespace reliefui {

// view: null where there is nothing to compare with. shown: of flicker.
std::shared_ptr<const Figure> compareFigure(std::shared_ptr<const Snapshot> snapshot,
                                            std::shared_ptr<const ComparedView> view, std::size_t shown);
// Rendered and measured now: takes seconds.
std::shared_ptr<const Figure> measuredComparison(std::shared_ptr<const Snapshot> snapshot);

}  // namespace reliefui
