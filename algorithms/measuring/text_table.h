// Plain-text tables for a terminal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "relief/messages.h"

namespace relief {

using TableRow = std::vector<std::string>;

// Formats a table. Columns are as wide as their longest entry, separated by two spaces, the table indented by two. The
// first `left` columns and those from `textFrom` on are left-aligned, the others right-aligned. Each line ends with
// "\n".
std::string textTable(const std::vector<TableRow>& rows, std::size_t left = 1, std::size_t textFrom = 1000);

// Formats a number with `digits` significant digits, without an exponent from 0.001 to a million.
std::string readable(double value, int digits);

// Formats a size in bytes, KiB (1024 bytes) or MiB (1024 KiB), with `digits` significant digits.
Message bytesText(std::int64_t bytes, int digits);

}  // namespace relief
