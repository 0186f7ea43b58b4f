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
    std::vector<bool> numbers;  // per column: right-aligned, not wrapped
    int marked = -1;
    std::vector<TableRow> rows;
    std::string below;       // a sentence under the table
    std::vector<int> spare;  // columns that are left out, one after the other, where the table would be scaled much
};

// Draws the table `width` points wide. Texts are wrapped where it is narrower than they are; a table whose numbers and
// longest words do not fit is scaled.
Drawing tableDrawing(const TableSource& source, double width);

}  // namespace reliefui
