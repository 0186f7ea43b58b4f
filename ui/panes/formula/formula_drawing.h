// The formulas as a sheet: groups below each other, in several columns if the sheet is wide. Within a group, equations,
// numbers and values are aligned.
#pragma once

#include "painting/drawing.h"
#include "panes/formula/formula_data.h"

namespace reliefui {

struct FormulaSheet {
    // Position of a row, and its content as one line of text.
    struct Place {
        Box box;
        std::string words;
    };
    Drawing drawing;
    std::vector<Place> places;
};

// Lays out a sheet `width` points wide; the height follows. A sheet too narrow for its text is scaled down as a whole.
FormulaSheet formulaSheet(const std::vector<FormulaGroup>& groups, double width);

}  // namespace reliefui
