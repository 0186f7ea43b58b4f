// Tables of text read line by line; what stood there is quoted in messages.
#pragma once

#include <string>
#include <string_view>

namespace relief {

// What stood in a file, fit for one line of a message.
std::string quoted(std::string_view text);
// Takes the next line, without its end ("\n" or "\r\n").
std::string_view takeLine(std::string_view& text);
// Takes what stands before the next comma.
std::string_view takeCell(std::string_view& line);
// Without a byte order mark.
std::string_view withoutMark(std::string_view text);
// A finite number, the whole text, whatever the locale; InputError with the line.
double finiteNumber(std::string_view text, const std::string& fileName, std::size_t line);

}  // namespace relief
