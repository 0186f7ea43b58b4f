// The result as a figure.
#pragma once

#include "panes/figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

// Rendered again at its size on the page. If its layer has a legend, it stands below the picture.
std::shared_ptr<const Figure> resultFigure(std::shared_ptr<const Snapshot> snapshot);

}  // namespace reliefui
