// Parts of one run, made by commands that need not know of each other (--part K/N) and put together by relief merge.
//
// Every part says which run it is of: its *part line*, a JSON object
//     {"relief part": K, "of": N, "run": {"kind": ..., "commit": ..., "options": {...}, "cells": ...}, ...}
// kind: tracers, rows, filters, stress or render; options: all that results depend on; cells: a hash of the names of
// all cells of the whole run. Two parts are of one run when their `run` are equal. Where the line stands: in a table
// (CSV) the first line, behind "# "; in JSON lines the first object; in a picture its metadata (picture_bands.h). A
// table's also has "rows", [[cell, count], ...]: how many rows each cell of the part has, in the file's order, and may
// have "words", the columns that hold text whatever it looks like. A picture's has "first", "end" and "height": rows
// [first, end) of so many.
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

// K/N: part K, from 1, of N.
struct PartNumber {
    int part = 1;
    int of = 1;
    // Whether the cell, frame or case of this index, from 0, is of this part.
    bool has(std::uint64_t index) const {
        return index % static_cast<std::uint64_t>(of) == static_cast<std::uint64_t>(part - 1);
    }
};

// "2/3". Throws InputError naming --part.
PartNumber parsePartNumber(const std::string& text);

// The part's band of a picture's rows: bands differ by one row at most. Throws InputError naming --part where there are
// fewer rows than parts.
RowRange partRows(const PartNumber& number, int height);

struct Part : PartNumber {
    Json run;
    Json more = Json::object();  // what else stands in the line: "rows", "first", ...
};

// All that tells one run from another. cells: the names of all its cells.
Json runJson(const std::string& kind, Json options, std::span<const std::string> cells);

// The part line: one line of printable ASCII, without "\n".
std::string partLine(const Part& part);
// Of a whole run: {"run": ...}.
std::string runLine(const Json& run);
// Empty where the text is none.
std::optional<Part> parsePartLine(std::string_view text);

// Tells what is in files and pictures from what is in others (FNV-1a), word by word.
class ContentHash {
  public:
    void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3ULL; }
    std::string text() const;  // sixteen hexadecimal digits

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};
// Of these bytes, each a word.
std::string hashText(std::span<const std::byte> bytes);

// What tells the runs apart, the first of: kind, commit, seed, the other options, cells. Empty where they are equal.
struct RunDifference {
    std::string what;         // "commit", "seed", "camera.elevation", ...
    std::string here, there;  // as JSON, cut where it is long; null: not given
};
std::optional<RunDifference> runDifference(const Json& here, const Json& there);

// A file that holds a part.
struct PartFile {
    std::string path;
    Part part;
};
// Throws InputError, naming the files, where they are not all parts of one run, once each. At least one file.
void requireWholeRun(const std::vector<PartFile>& files);

}  // namespace relief::app
