// Parts of one run, computed by independent commands (--part K/N) and joined by `relief merge`.
//
// Every part identifies its run by its *part line*, a JSON object
//     {"relief part": K, "of": N, "run": {"kind": ..., "commit": ..., "options": {...}, "cells": ...}, ...}
// kind: tracers, rows, filters, stress or render. options: everything that results depend on. cells: a hash of the
// names of all cells of the whole run. Two parts belong to the same run if their `run` objects are equal.
//
// Place of the part line: in a table (CSV) the first line, after "# "; in JSON lines the first object; in a picture its
// metadata (picture_bands.h). Tables also have "rows", [[cell, count], ...], the number of rows of each cell of the
// part in the file's order, and may have "words", the columns that hold text even where it looks like numbers. Pictures
// also have "first", "end" and "height": the part holds rows [first, end) of a picture of that height.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "json_line.h"
#include "rendering/frame.h"

namespace relief::app {

inline constexpr int kMostParts = 100'000;

// K/N: part K, counted from 1, of N.
struct PartNumber {
    int part = 1;
    int of = 1;
    // Returns true if the cell, frame or case of this index, counted from 0, belongs to this part.
    bool has(std::uint64_t index) const {
        return index % static_cast<std::uint64_t>(of) == static_cast<std::uint64_t>(part - 1);
    }
};

// Parses "2/3". Throws InputError naming --part.
PartNumber parsePartNumber(const std::string& text);

// Returns the band of a picture's rows that belongs to the part; the heights of bands differ by at most one row. Throws
// InputError naming --part if there are fewer rows than parts.
RowRange partRows(const PartNumber& number, int height);

struct Part : PartNumber {
    Json run;
    Json more = Json::object();  // what else stands in the line: "rows", "first", ...
};

// Returns the identity of a run. cells: the names of all its cells.
Json runJson(const std::string& kind, Json options, std::span<const std::string> cells);

// Returns the part line: one line of printable ASCII, without "\n".
std::string partLine(const Part& part);
// Returns the first line of a whole run: {"run": ...}.
std::string runLine(const Json& run);
// Returns std::nullopt if the text is not a part line.
std::optional<Part> parsePartLine(std::string_view text);

// Identifies the content of files and pictures: FNV-1a, with 64-bit words in place of bytes.
class ContentHash {
  public:
    void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3ULL; }
    std::string text() const;  // sixteen hexadecimal digits

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};
// Returns the hash of the bytes, each added as one word.
std::string hashText(std::span<const std::byte> bytes);

// The first difference of two runs, in the order: kind, commit, seed, the other options, cells. runDifference() returns
// std::nullopt if they are equal.
struct RunDifference {
    std::string what;         // "commit", "seed", "camera.elevation", ...
    std::string here, there;  // as JSON, truncated if long; null: not given
};
std::optional<RunDifference> runDifference(const Json& here, const Json& there);

// A file that holds a part.
struct PartFile {
    std::string path;
    Part part;
};
// Throws InputError, naming the files, unless they are all parts of one run, each exactly once. Requires at least one
// file.
void requireWholeRun(const std::vector<PartFile>& files);

}  // namespace relief::app
