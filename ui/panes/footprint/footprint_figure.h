// The footprint of the chosen pixel as a figure.
#pragma once

#include "panes/figure.h"
#include "panes/footprint/footprint_drawing.h"
#include "workspace/snapshot.h"

namespace reliefui {

std::shared_ptr<const Figure> footprintFigure(std::shared_ptr<const Snapshot> snapshot,
                                              const FootprintOptions& options);

}  // namespace reliefui
