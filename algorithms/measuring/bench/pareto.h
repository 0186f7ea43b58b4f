// Run time against error: combines the tables of `relief bench tracers` into one point per method, and finds the
// methods that no other dominates.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measuring/bench/bench_tracers.h"

namespace relief {

// Which statistic of the errors of a block of rays, texels.
enum class ErrorMeasure : std::uint8_t { Mean, P95, P9999, Max };
inline constexpr std::array<std::string_view, 4> kErrorMeasureNames{"mean", "p95", "p9999", "max"};
// Throws InputError naming the option.
ErrorMeasure parseErrorMeasure(const std::string& text, const std::string& option);

struct ParetoPoint {
    MethodChoice method;
    Form form{};                  // the implementation whose time was measured
    std::string name;             // shown to users, without options that have their default values
    double nanoseconds = 0;       // per ray, median of the rounds
    double spread = 0;            // (p75 - p25) / median
    std::array<double, 4> error;  // by ErrorMeasure, texels, over rays that hit as `exact` does; NaN: there are none
    std::int64_t wrongOutcome = 0;
    double steps = 0;  // mean per ray

    // Returns the name; with the implementation form if `marked`.
    std::string label(bool marked) const { return marked ? name + " (" + std::string(formName(form)) + ")" : name; }
    double errorOf(ErrorMeasure measure) const { return error[static_cast<std::size_t>(measure)]; }
};

struct ParetoTable {
    std::vector<ParetoPoint> points;  // in the order of the table
    // Measured maps (name and size) and elevations, each once, in the order of the table.
    std::vector<std::string> heights, elevations;
    std::size_t cells = 0;             // number of blocks of rays that each point averages
    std::vector<std::string> leftOut;  // methods that were not measured in all of these blocks
    int threads = 0;
    std::string cpu, compiler;

    // Returns true if it has points of both SIMD and scalar implementations, so that labels must name the form.
    bool bothForms() const;
};

// Combines all rows of each method: the geometric mean of times; the mean of errors and steps; the maximum of the
// largest errors; the sum of wrong outcomes; the largest spread.
ParetoTable paretoTable(std::span<const BenchRow> rows);

// For each point, returns true if another point of the same form is at least as fast, at least as exact and has no more
// wrong outcomes, and is better in one of these. Times of SIMD and scalar implementations are not compared, because
// their ratio says nothing about the methods.
std::vector<bool> dominatedPoints(std::span<const ParetoPoint> points, ErrorMeasure measure);

// Returns "layers:layers=128", without options that have the method's default values. Methods that are not in the list
// (from other libraries) keep all options.
std::string shortMethodName(const MethodChoice& choice);

// Reads a file that `relief bench tracers -o` wrote: CSV if its name ends in .csv, JSON otherwise. Throws InputError if
// it is unreadable, not JSON (with the line), not such a table, or has a row with an invalid value.
std::vector<BenchRow> readBenchTable(const std::string& path);
std::vector<BenchRow> parseBenchJson(const std::string& text, const std::string& fileName);
std::vector<BenchRow> parseBenchCsv(const std::string& text, const std::string& fileName);
// Returns the rows of a relief and an elevation, spelled as in the table; empty: all. Throws InputError naming the
// option.
std::vector<BenchRow> chosenRows(std::vector<BenchRow> rows, const std::string& height, const std::string& elevation);

}  // namespace relief
