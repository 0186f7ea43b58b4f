// Tables and records of parts put together, as relief merge does; the parts are those of one run, in the order of their
// numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "part.h"
#include "session.h"

namespace relief::app {

// A part that is text: a table as CSV, or the record of a stress run.
struct TextPart : PartFile {
    std::string text;      // of the whole file
    std::size_t body = 0;  // where the lines after the part line begin
};

// Writes the table that one process would have written, the rows in the order of the cells, as CSV or, where `output`
// ends in .json, as JSON: there a field that is a number becomes one, unless its column is among the part's "words".
// Throws InputError (a file that is cut short, cells that do not fit together, another ending), WorkError.
void mergeTables(const std::vector<TextPart>& parts, const std::string& output, Session& session);

// Prints the report that one process would have printed, without the time that it took; writes the whole record to
// `output` where that is given. Returns the exit status: 1 where there are violations. Throws InputError (a file that
// is cut short, or holds other cases than its part), WorkError.
int mergeRecords(const std::vector<TextPart>& parts, const std::optional<std::string>& output, Session& session);

}  // namespace relief::app
