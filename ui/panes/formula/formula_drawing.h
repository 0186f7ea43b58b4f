// The formulas as a sheet: groups one below the other, in columns where the sheet is wide. In each group equations,
// numbers and values stand below each other.
#pragma once

#include "painting/drawing.h"
#include "panes/formula/formula_data.h"

namespace reliefui {

struct FormulaSheet {
    // Where a row stands, and what it says in one line.
    struct Place {
        Box box;
        std::string words;
    };
    Drawing drawing;
    std::vector<Place> places;
};

// In points, `width` of them wide; its height follows. A sheet too narrow for its words is set smaller as a whole.
FormulaSheet formulaSheet(const std::vector<FormulaGroup>& groups, double width);

}  // namespace reliefui
