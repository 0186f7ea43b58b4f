// What the comparisons with other programs share: words of a command line, and the rows that they write.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace relief::peers {

// One contender in one cell: a map or picture, its size, a view. Written as CSV or JSON with these columns, to which
// cpu, compiler, commit are added.
struct PeerRow {
    std::string what;    // map or picture
    std::string size;    // as said on the command line
    std::string view;    // degrees of elevation; empty where there is none
    std::string method;  // ours: without a '/'; others: PROGRAM/VARIANT
    int threads = 1;
    double rate = 0, spread = 0;        // of the unit below a second: median of the rounds, (p75 - p25) / median
    double ratio = 0, ratioSpread = 0;  // rate over that of the fastest peer in the same round; 0: not compared
    double error = 0;                   // as the program says
};

// "a,b" into its parts.
std::vector<std::string> partsOf(const std::string& text, char separator = ',');

// what,size,view,method,threads,rate,spread,ratio,ratio_spread,error,cpu,compiler,commit; JSON where the name ends so.
// Written aside and renamed. Throws WorkError.
void writePeerRows(const std::string& path, const std::vector<PeerRow>& rows);

// Rates of rounds into a row's, and the ratios to `fastest`, round by round.
void setRates(PeerRow& row, const std::vector<double>& rates);
void setRatios(PeerRow& row, const std::vector<double>& rates, const std::vector<double>& fastest);
// Of each round, the largest rate.
std::vector<double> fastestOf(const std::vector<const std::vector<double>*>& contenders);

}  // namespace relief::peers
