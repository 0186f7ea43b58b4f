// Shared by the comparisons with other programs: parsing of command-line lists, and the rows that they write.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace relief::peers {

// A contender in one cell: a map or picture, its size, a view. Written as CSV or JSON with these columns and cpu,
// compiler, commit.
struct PeerRow {
    std::string what;    // map or picture
    std::string size;    // as on the command line
    std::string view;    // elevation in degrees; empty if there is none
    std::string method;  // ours: without a '/'; others: PROGRAM/VARIANT
    int threads = 1;
    // in units per second as described by the program; median of the rounds, (p75 - p25) / median
    double rate = 0, spread = 0;
    double ratio = 0, ratioSpread = 0;  // rate divided by that of the fastest peer in the same round; 0: not compared
    double error = 0;                   // as defined by the program
};

// Splits "a,b" into its parts.
std::vector<std::string> partsOf(const std::string& text, char separator = ',');

// Writes the columns what,size,view,method,threads,rate,spread,ratio,ratio_spread,error,cpu,compiler,commit; as JSON if
// the name ends in .json. The file is written under a temporary name and renamed. Throws WorkError.
void writePeerRows(const std::string& path, const std::vector<PeerRow>& rows);

// Set the row's rate from the rates of the rounds, and its ratio from those to `fastest`, round by round.
void setRates(PeerRow& row, const std::vector<double>& rates);
void setRatios(PeerRow& row, const std::vector<double>& rates, const std::vector<double>& fastest);
// Returns the largest rate of each round.
std::vector<double> fastestOf(const std::vector<const std::vector<double>*>& contenders);

}  // namespace relief::peers
