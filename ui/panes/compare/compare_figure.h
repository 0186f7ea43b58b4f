// The comparison as a figure.
#pragma once

#include "panes/compare/compare_data.h"
#include "panes/figure.h"

namespace reliefui {

// The pictures are rendered anew in the size they have on the page. Numbers and scale are the view's, as the pane shows
// them; without a view they are measured in the size of the scenario. shown: of flicker.
std::shared_ptr<const Figure> compareFigure(std::shared_ptr<const Snapshot> snapshot,
                                            std::shared_ptr<const ComparedView> view, std::size_t shown);

}  // namespace reliefui
