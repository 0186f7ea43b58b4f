// Run time against error: one point a method from the tables of `relief bench tracers`, and which of them are worth
// choosing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measuring/bench/bench_tracers.h"

namespace relief {

// Of the errors of a block of rays, texels.
enum class ErrorMeasure : std::uint8_t { Mean, P95, P9999, Max };
inline constexpr std::array<std::string_view, 4> kErrorMeasureNames{"mean", "p95", "p9999", "max"};
// Throws InputError naming the option.
ErrorMeasure parseErrorMeasure(const std::string& text, const std::string& option);

struct ParetoPoint {
    MethodChoice method;
    Form form{};                  // what its time is of
    std::string name;             // for people: without options that are the defaults
    double nanoseconds = 0;       // a ray, median of the rounds
    double spread = 0;            // (p75 - p25) / median
    std::array<double, 4> error;  // by ErrorMeasure, texels, of rays that hit as `exact` does; NaN: there are none
    std::int64_t wrongOutcome = 0;
    double steps = 0;  // mean of a ray

    // The name; with the form where `marked`.
    std::string label(bool marked) const { return marked ? name + " (" + std::string(formName(form)) + ")" : name; }
    double errorOf(ErrorMeasure measure) const { return error[static_cast<std::size_t>(measure)]; }
};

struct ParetoTable {
    std::vector<ParetoPoint> points;  // in the order of the table
    // What was measured: maps (name and size) and elevations, each once, in the order of the table.
    std::vector<std::string> heights, elevations;
    std::size_t cells = 0;             // blocks of rays that each point is a mean of
    std::vector<std::string> leftOut;  // methods that were not measured in all of them
    int threads = 0;
    std::string cpu, compiler;

    // Whether points of both forms are in it: then each is labelled with its own.
    bool bothForms() const;
};

// Over all rows: the geometric mean of times, the mean of errors and steps (of the largest error, the largest), the sum
// of wrong outcomes; the spread is the largest.
ParetoTable paretoTable(std::span<const BenchRow> rows);

// Of each point whether another of the same form is no slower, no less exact and has no more wrong outcomes, and better
// in one of them. Times of SIMD and of scalar code tell nothing of the methods.
std::vector<bool> dominatedPoints(std::span<const ParetoPoint> points, ErrorMeasure measure);

// "layers:layers=128": options that are the method's defaults are left out. Methods that are not in the list (of other
// libraries) keep theirs.
std::string shortMethodName(const MethodChoice& choice);

// What `relief bench tracers -o FILE.json` wrote. Throws InputError: unreadable, no JSON (with the line), no such
// table, a row whose values are not those of its column.
std::vector<BenchRow> readBenchJson(const std::string& path);
std::vector<BenchRow> parseBenchJson(const std::string& text, const std::string& fileName);
// Those of a relief and of an elevation as the table spells them; empty: all. Throws InputError naming the option.
std::vector<BenchRow> chosenRows(std::vector<BenchRow> rows, const std::string& height, const std::string& elevation);

}  // namespace relief
