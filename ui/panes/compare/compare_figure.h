// The comparison as a figure.
#pragma once

#include "panes/compare/compare_data.h"
#include "panes/figure.h"

namespace reliefui {

// The pictures are rendered again at their size on the page. Numbers and scale are the view's, as shown in the pane;
// without a view they are measured at the scenario's size. shown: index of the picture in flicker mode.
std::shared_ptr<const Figure> compareFigure(std::shared_ptr<const Snapshot> snapshot,
                                            std::shared_ptr<const ComparedView> view, std::size_t shown);

}  // namespace reliefui
