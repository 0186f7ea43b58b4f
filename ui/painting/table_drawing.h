// A table as a figure: the steps of a ray, the ledger of what was skipped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "painting/drawing.h"

namespace reliefui {

struct TableRow {
    std::vector<std::string> cells;  // a heading has one, over all columns
    bool heading = false;
    bool chosen = false;
    std::optional<relief::Decision> mark;  // before the text of TableSource::marked
};

// Texts are in the language of the reader already.
struct TableSource {
    std::vector<std::string> titles;
    std::vector<bool> numbers;  // of each column: at the right
    int marked = -1;
    std::vector<TableRow> rows;
    std::string below;  // a sentence under the table
};

// In points, `width` of them wide; the last column's text goes on in the next line where it is too long.
Drawing tableDrawing(const TableSource& source, double width);

}  // namespace reliefui
