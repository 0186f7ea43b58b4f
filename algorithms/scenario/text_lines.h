// Reads tables of text line by line, and quotes their content in messages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace relief {

// Number of characters of a text in UTF-8, not of bytes.
std::size_t characterCount(std::string_view text);
// Returns text from a file shortened to fit into one line of a message.
std::string quoted(std::string_view text);
// Removes and returns the next line, without its end ("\n" or "\r\n").
std::string_view takeLine(std::string_view& text);
// Removes and returns the text before the next comma.
std::string_view takeCell(std::string_view& line);
// Calls body(row, line) for each line after the header, line numbers from 2. Blank lines at the end are left out.
template <class Body>
void forEachRow(std::string_view text, const Body& body) {
    for (std::size_t line = 2; !text.empty(); ++line) {
        const std::string_view row = takeLine(text);
        if (row.empty() && text.find_first_not_of("\r\n") == std::string_view::npos) break;
        body(row, line);
    }
}
// Returns the names of the columns that follow `first`, the columns with which the header must begin; std::nullopt if
// it begins otherwise.
std::optional<std::vector<std::string_view>> columnsAfter(std::string_view header, std::string_view first);
// Throws InputError with the line if the row has another number of cells.
void requireCells(std::string_view row, std::size_t wanted, const std::string& fileName, std::size_t line);
// Returns the text without a byte order mark.
std::string_view withoutMark(std::string_view text);
// Parses the whole text as a finite number, independent of the locale. Throws InputError with the line.
double finiteNumber(std::string_view text, const std::string& fileName, std::size_t line);

}  // namespace relief
