// Benchmark of the evaluation of texture coordinates along rows: operations, rate and error of each variant, next to
// the papers' own table.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "measuring/bench/bench_columns.h"
#include "relief/work.h"
#include "scenario/row_methods.h"

namespace relief {

enum class RowPrecision : std::uint8_t { Float, Double };
std::string_view precisionName(RowPrecision precision);

// The test view: a square wall with `texels` texels along each side, whose width fills a row of `width` pixels exactly.
// The eye is kWallDistance wall widths from the wall's centre, at `elevation` degrees to its plane (90: straight in
// front). Along a row q falls to 0.37 of its maximum at 60 degrees, to 0.10 at 25 and to 0.05 at 8. The rows lie on
// lines y that cover the visible height of the wall's far edge.
inline constexpr double kWallDistance = 0.55;
// obliqueWall: the homography from pixels to texels of this view. wallRows: the lines of the view's rows.
Homography obliqueWall(double texels, std::int64_t width, double elevation);
RowBlock wallRows(std::int64_t width, std::int64_t rows, double elevation);

// A row of the table. errorMax for coordinates: maximum over u and v of the difference from long double, texels; for
// derivatives: the error of the half extents of the ellipse of radius 1 pixel; for the variant fill: NaN.
struct RowBenchRow {
    std::string variant;
    std::int64_t width = 0;
    std::int64_t rows = 0;  // in a block
    double elevation = 0;
    RowPrecision precision{};
    std::int64_t streams = 1;
    std::int64_t span = 1;    // pixels between exact values; affine: the whole row
    std::int64_t anchor = 0;  // pixels between restarts; 0: none
    int threads = 1;
    PixelCounts counts;  // operations per pixel, including those of restarts
    double rate = 0;     // pixels per second, median of the rounds
    double spread = 0;   // (p75 - p25) / median
    double errorMax = 0;
};

std::string
rowBenchCsvHeader();  // variant,width,elevation,precision,streams,span,anchor,threads,mul,add,div,rate,...,rows
std::string rowBenchCsvLine(const RowBenchRow& row);
std::string rowBenchJson(std::span<const RowBenchRow> rows);
// Text table with a block for each width, elevation and precision.
std::string rowBenchText(std::span<const RowBenchRow> rows);

inline constexpr std::int64_t kWidestRow = 1 << 20;

struct RowBenchOptions {
    std::vector<RowMethod> methods = defaultRowMethods();
    std::vector<std::int64_t> widths{640, 3840, 16384, 65536};  // up to kWidestRow
    std::vector<double> elevations{60, 25, 8};                  // kLowestElevation to 90
    std::vector<RowPrecision> precisions{RowPrecision::Float, RowPrecision::Double};
    double texels = 4096;
    std::int64_t pixels = 1 << 22;  // measured by one timing: a block of rows, repeated if it has fewer pixels
    std::int64_t rows = 0;          // of a block; at most pixels / width. 0: that number
    int rounds = 5;                 // each round runs all methods in turn
    BenchPass pass = BenchPass::Both;
    std::function<void(const RowBenchRow&)> onRow;
};

// Throws Cancelled.
std::vector<RowBenchRow> benchRows(const RowBenchOptions& options, Work& work);

}  // namespace relief
