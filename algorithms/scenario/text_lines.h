// Reads tables of text line by line, and quotes their content in messages.
#pragma once

#include <string>
#include <string_view>

namespace relief {

// Returns text from a file shortened to fit into one line of a message.
std::string quoted(std::string_view text);
// Removes and returns the next line, without its end ("\n" or "\r\n").
std::string_view takeLine(std::string_view& text);
// Removes and returns the text before the next comma.
std::string_view takeCell(std::string_view& line);
// Returns the text without a byte order mark.
std::string_view withoutMark(std::string_view text);
// Parses the whole text as a finite number, independent of the locale. Throws InputError with the line.
double finiteNumber(std::string_view text, const std::string& fileName, std::size_t line);

}  // namespace relief
