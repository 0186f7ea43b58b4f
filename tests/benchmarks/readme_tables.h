// The README's tables, made of the files that the benchmarks wrote.
#pragma once

#include <string>

namespace relief::claims {

// Everything between a line "<!-- table NAME -->" and the next "<!-- end -->" becomes the table of that name, made of
// the files in `folder`: rows.csv, filters_checker.csv, filters_relief.csv, peers.csv, filter_peers.csv,
// distance_peers.csv, frames.csv, and NAME.md
// as it stands for any other name. Tables whose file is not there stay as they are.
// Throws InputError: an unknown column, a missing row, a marker without an end.
std::string withTables(const std::string& readme, const std::string& folder);

}  // namespace relief::claims
