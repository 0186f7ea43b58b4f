// Generates the tables of RESULTS.md from the files that the benchmarks wrote.
#pragma once

#include <string>

namespace relief::claims {

// Replaces everything between a line "<!-- table NAME -->" and the next "<!-- end -->" by the table of that name, made
// from the files in `folder`: NAME.csv for rows, filters_checker, filters_relief, filters_position, peers,
// filter_peers, distance_peers and frames; the text of NAME.md for any other name. Tables whose file is missing are not
// changed. Throws InputError: an unknown column, a missing row, a mark without an end.
std::string withTables(const std::string& document, const std::string& folder);

}  // namespace relief::claims
