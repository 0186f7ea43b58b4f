// A table as a figure.
#pragma once

#include <functional>

#include "painting/table_drawing.h"
#include "panes/figure.h"

namespace reliefui {

// Creates the table's content in a language.
using TableMaker = std::function<TableSource(relief::Language language)>;
std::shared_ptr<const Figure> tableFigure(TableMaker table, FigureCaption caption);

}  // namespace reliefui
