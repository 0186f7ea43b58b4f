#pragma once

#include "panes/figure.h"
#include "panes/formula/formula_data.h"

namespace reliefui {

// The sheet of formulas; the height follows from the width. part: only this part, for a column of a page; std::nullopt:
// all parts.
std::shared_ptr<const Figure> formulaFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            std::optional<FormulaPart> part = {});

}  // namespace reliefui
