// Draws a table as a figure, such as the steps of a ray or the list of skipped work.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "painting/drawing.h"

namespace reliefui {

struct TableRow {
    std::vector<std::string> cells;  // a heading has one, which spans all columns
    bool heading = false;
    bool chosen = false;
    std::optional<relief::Decision> mark;  // drawn before the text of column TableSource::marked
};

// Content of a table; texts are already translated.
struct TableSource {
    std::vector<std::string> titles;
    std::vector<bool> numbers;  // per column: right-aligned
    int marked = -1;
    std::vector<TableRow> rows;
    std::string below;  // a sentence under the table
};

// Draws the table `width` points wide; the text of the last column is wrapped.
Drawing tableDrawing(const TableSource& source, double width);

}  // namespace reliefui
