// The formulas as a sheet: groups one below the other, in columns where the sheet is wide. In each group equations,
// numbers and values stand below each other.
#pragma once

#include "painting/drawing.h"
#include "panes/formula/formula_data.h"

namespace reliefui {

// In points, `width` of them wide; its height follows. A sheet too narrow for its words is set smaller as a whole.
Drawing formulaDrawing(const std::vector<FormulaGroup>& groups, double width);

}  // namespace reliefui
