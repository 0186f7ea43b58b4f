#pragma once

#include <functional>

#include "painting/drawing.h"
#include "panes/figure.h"
#include "panes/formula/formula_data.h"

namespace reliefui {

// Makes a sheet of this width, in points.
using SheetMaker = std::function<Drawing(double points, relief::Language)>;
// A figure of one sheet, as high as the sheet is at the page's width.
std::shared_ptr<const Figure> sheetFigure(SheetMaker sheet, FigureCaption caption);

// The sheet of formulas; the height follows from the width. part: only this part, for a column of a page; std::nullopt:
// all parts.
std::shared_ptr<const Figure> formulaFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            std::optional<FormulaPart> part = {});

}  // namespace reliefui
