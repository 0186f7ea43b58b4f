// The comparison as a figure.
#pragma once

#include "panes/compare/compare_data.h"
#include "panes/figure.h"

namespace reliefui {

// shown: of flicker. The pictures are rendered anew in the size they have on the page, and compared and timed in it;
// one that differs from the last page's takes seconds.
std::shared_ptr<const Figure> compareFigure(std::shared_ptr<const Snapshot> snapshot, std::size_t shown);

}  // namespace reliefui
