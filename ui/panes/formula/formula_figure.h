#pragma once

#include "panes/figure.h"
#include "workspace/snapshot.h"

namespace reliefui {

// The sheet of formulas, as high as its width makes it.
std::shared_ptr<const Figure> formulaFigure(std::shared_ptr<const Snapshot> snapshot);

}  // namespace reliefui
