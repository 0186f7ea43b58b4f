#pragma once

#include "panes/figure.h"
#include "panes/formula/formula_data.h"

namespace reliefui {

// The sheet of formulas, as high as its width makes it. part: alone, for the column of a page; none: all.
std::shared_ptr<const Figure> formulaFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            std::optional<FormulaPart> part = {});

}  // namespace reliefui
