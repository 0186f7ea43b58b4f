// Joins tables and records of parts for `relief merge`. The parts passed in belong to one run and are sorted by number.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "part.h"
#include "session.h"

namespace relief::app {

// A part that is text: a CSV table, or the record of a stress run.
struct TextPart : PartFile {
    std::string text;      // of the whole file
    std::size_t body = 0;  // offset of the first line after the part line
};

// Writes the table that one process would have written, with the rows in the order of the cells, as CSV or, if `output`
// ends in .json, as JSON. In JSON a numeric field becomes a number unless its column is listed under the part's
// "words". Throws InputError (a truncated file, cells that do not fit together, another file ending) and WorkError.
void mergeTables(const std::vector<TextPart>& parts, const std::string& output, Session& session);

// Prints the report that one process would have printed, without the elapsed time, and writes the whole record to
// `output` if that is given. Returns the exit status: 1 if there are violations. Throws InputError (a truncated file,
// or one that holds cases of another part) and WorkError.
int mergeRecords(const std::vector<TextPart>& parts, const std::optional<std::string>& output, Session& session);

}  // namespace relief::app
