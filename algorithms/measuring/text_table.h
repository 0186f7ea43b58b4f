// Tables for people, in a terminal's letters.
#pragma once

#include <string>
#include <vector>

namespace relief {

using TableRow = std::vector<std::string>;

// Columns as wide as their longest entry, two blanks apart, indented by two: the first `left` ones and those from
// `textFrom` on begin at their left edge, the others end at their right one. Each line ends with "\n".
std::string textTable(const std::vector<TableRow>& rows, std::size_t left = 1, std::size_t textFrom = 1000);

// `digits` significant digits; without an exponent from 0.001 to a million.
std::string readable(double value, int digits);

}  // namespace relief
