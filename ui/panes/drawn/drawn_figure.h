// The relief edited by hand as a figure.
#pragma once

#include "panes/figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

std::shared_ptr<const Figure> drawnFigure(std::shared_ptr<const Snapshot> snapshot);

}  // namespace reliefui
