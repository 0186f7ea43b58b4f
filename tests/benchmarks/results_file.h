// Reads the files of benchmarks for the tables of RESULTS.md, and formats these.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "measuring/text_table.h"
#include "relief/describe.h"
#include "relief/errors.h"

namespace relief::claims {

// Throws InputError: the file is not what a benchmark writes.
[[noreturn]] void fail(const std::string& file, const std::string& why);

std::vector<std::string> linesOf(const std::string& text);

using Row = std::map<std::string, std::string>;

// A file of a benchmark.
class Table {
  public:
    explicit Table(const std::string& path);

    const std::vector<Row>& rows() const { return rows_; }
    const std::string& path() const { return path_; }
    // Returns the only row with these values.
    const Row& at(const Row& key) const {
        const Row* found = nullptr;
        for (const Row& row : rows_) {
            if (!std::all_of(key.begin(), key.end(), [&](const auto& w) { return text(row, w.first) == w.second; })) {
                continue;
            }
            if (found != nullptr) fail(path_, "two rows " + textOf(key));
            found = &row;
        }
        if (found == nullptr) fail(path_, "no row " + textOf(key));
        return *found;
    }
    const std::string& text(const Row& row, const std::string& column) const {
        const auto found = row.find(column);
        if (found == row.end()) fail(path_, "no column " + column);
        return found->second;
    }
    double number(const Row& row, const std::string& column) const { return parseNumber(text(row, column), path_); }
    // Returns the distinct values of a column, in the order of the rows.
    std::vector<std::string> values(const std::string& column) const {
        std::vector<std::string> all;
        for (const Row& row : rows_) {
            if (std::find(all.begin(), all.end(), text(row, column)) == all.end()) all.push_back(text(row, column));
        }
        return all;
    }

  private:
    static std::string textOf(const Row& key) {
        std::string out;
        for (const auto& [name, value] : key) out += (out.empty() ? "" : ", ") + name + " = " + value;
        return out;
    }

    std::string path_;
    std::vector<Row> rows_;
};

// The smallest and largest of some numbers, and their geometric mean.
class Range {
  public:
    void add(double value) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
        logarithms_ += std::log(value);
        ++count_;
    }
    bool empty() const { return count_ == 0; }
    double low() const { return low_; }
    double high() const { return high_; }
    double mean() const { return std::exp(logarithms_ / count_); }
    int count() const { return count_; }
    // "1.2 to 3.4"
    std::string text() const { return readable(low_, 2) + " to " + readable(high_, 2); }

  private:
    double low_ = 1e300, high_ = 0, logarithms_ = 0;
    int count_ = 0;
};

std::string line(const std::vector<std::string>& cells);
// Returns the head of a table; the first `left` columns are left-aligned.
std::string head(const std::vector<std::string>& names, std::size_t left);
// Returns the number with three significant digits.
std::string three(double value);
// "1 / 2 / 3"
std::string joined(const std::vector<std::string>& parts);
// Returns the last line, which names the machine and the date, that of the file.
std::string origin(const Table& table);

// Tables of the comparisons with other programs.
std::string peersTable(const Table& table);
std::string filterPeersTable(const Table& table);
std::string distancePeersTable(const Table& table);
std::string framesTable(const Table& table);

}  // namespace relief::claims
