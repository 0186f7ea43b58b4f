// The result as a figure.
#pragma once

#include "panes/figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Rendered anew in the size that it has on the page. The legend of its layer, if it has one, stands below the picture.
std::shared_ptr<const Figure> resultFigure(std::shared_ptr<const Snapshot> snapshot);

}  // namespace reliefui
