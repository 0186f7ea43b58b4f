// The rows pane: texture coordinates along the scan line of the chosen pixel, computed by several variants. The upper
// plot shows u and v, the lower one the error of each variant against double precision; strips between them show which
// stream computes which pixel around the chosen one. [PERSP].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mapping/rows/row_errors.h"
#include "painting/chart.h"
#include "scenario/row_methods.h"

namespace reliefui {

inline constexpr std::size_t kMostRowCurves = 4;  // more could not be distinguished

struct RowsOptions {
    // Descriptions as for `relief bench rows`; row variants only, at most kMostRowCurves.
    std::vector<std::string> methods{"affine", "direct", "incremental:anchor=0", "streams:streams=4"};
    int pixels = 0;  // of the scan line across the picture, 1 to relief::kWidestRow; 0: the picture's width
    bool inDouble = false;
    bool logarithmic = true;

    bool operator==(const RowsOptions&) const = default;
};
// Throws InputError that names `option`.
std::vector<relief::RowMethod> rowMethods(const RowsOptions& options, const std::string& option);

// A scan line of a polygon, in the pixels of the picture or of a wider version of it.
struct RowsPlace {
    relief::Homography map;  // from these pixels
    double y = 0.5;          // centre of the picture's row
    int line = 0;            // index of the row
    relief::PixelSpan span;  // pixels in which the polygon is visible
    std::int64_t width = 0;  // of the picture, in pixels
    std::int64_t chosen = 0;
};
// The same line subdivided into this many pixels.
RowsPlace widened(const RowsPlace& place, std::int64_t pixels);

// Largest error of the affine variant, in closed form.
struct AffinePlace {
    double x = 0;
    double error = 0;  // in texels
    double share = 0;  // relative to the change of u and v
};

struct RowsData {
    RowsPlace place;
    bool inDouble = false;
    relief::RowErrors row;
    // Names and costs of the curves.
    std::vector<std::string> names;
    std::vector<relief::PixelCounts> counts;
    std::optional<AffinePlace> affine;  // set if this variant is shown and has an error
};
// Takes a few milliseconds per curve of 65,536 pixels.
RowsData rowsData(const RowsPlace& place, const std::vector<relief::RowMethod>& methods, bool inDouble);
// Number of streams of a curve: k, 2 for opposed, otherwise 1.
int streamsOf(const relief::RowCurve& curve);

// Visible part of the row, in pixels; empty: all of it.
struct RowsRange {
    double from = 0;
    double to = 0;
    bool operator==(const RowsRange&) const = default;
};

// Layout of the drawing, in points.
struct RowsFrame {
    Box whole;
    Box upper;
    Box lower;
    std::vector<Box> strips;               // one for each entry of stripCurves
    std::vector<std::size_t> stripCurves;  // curves whose streams are shown pixel by pixel
    relief::PixelSpan lens;                // the pixels shown in the strips
    double from = 0;                       // pixels at the left and right sides
    double to = 1;
    double low = 0;  // texels at the sides of the upper plot
    double high = 1;
    bool logarithmic = true;
    double errorLow = 0;  // errors at the sides of the lower plot, in texels, or their decimal logarithms
    double errorHigh = 1;

    chart::Scale places() const { return {from, to, upper.x0, upper.x1}; }
    // Ticks are at the centres of pixels.
    chart::Scale pixels() const {
        return {.low = from - 0.5, .high = to - 0.5, .from = upper.x0, .to = upper.x1, .leastStep = 1};
    }
    chart::Scale texels() const { return {low, high, upper.y1, upper.y0}; }
    chart::Scale errors() const {
        return {errorLow, errorHigh, lower.y1, lower.y0, logarithmic ? chart::Numbers::Powers : chart::Numbers::Plain};
    }
    double xAt(double x) const { return places().at(x); }
    double pixelAt(double x) const { return places().valueAt(x); }
    double yAt(double texel) const { return texels().at(texel); }
    // Errors below the range are drawn at the lower side.
    double errorAt(double error) const;
    relief::PixelSpan seen(const RowsData& data) const;
};
RowsFrame rowsFrame(const RowsData& data, const RowsOptions& options, const RowsRange& range, double width,
                    double height);

Drawing rowsPlots(const RowsData& data, const RowsFrame& frame);
// Adds a curve's number on a plate of its colour.
void addCurveNumber(Drawing& drawing, Point at, std::size_t curve, Point offset, Anchor anchor = Anchor::Center);
// Adds the strips, which show the stream of each pixel; part of rowsPlots().
void addStrips(Drawing& drawing, const RowsData& data, const RowsFrame& frame);
Drawing rowsAxes(const RowsData& data, const RowsFrame& frame);
// Content of the legend: Whole: curves, costs and marks; Curves: curves and costs; Names: only the curves' names.
enum class RowsLegend : std::uint8_t { Whole, Curves, Names };  // with the marks; what they cost; who they are
Drawing rowsLegend(const RowsData& data, double width, relief::Language language,
                   RowsLegend legend = RowsLegend::Whole);

// What is under a point of the drawing: a pixel of the row, and the curve that is nearest.
struct RowsReading {
    bool inside = false;
    std::int64_t pixel = 0;
    std::optional<std::size_t> curve;
};
RowsReading rowsReading(const RowsData& data, const RowsFrame& frame, Point at);

}  // namespace reliefui
