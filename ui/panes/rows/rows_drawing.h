// The rows pane: texture coordinates along the scan line of the chosen pixel by several variants side by side. Above u
// and v, below the error of each against double, between them who computes which of some pixels around the chosen one.
// [PERSP].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mapping/rows/row_errors.h"
#include "painting/chart.h"
#include "scenario/row_methods.h"

namespace reliefui {

inline constexpr std::size_t kMostRowCurves = 4;  // what can be told apart

struct RowsOptions {
    // As `relief bench rows` spells them; row variants only, at most kMostRowCurves.
    std::vector<std::string> methods{"affine", "direct", "incremental:anchor=0", "streams:streams=4"};
    int pixels = 0;  // of the scan line across the picture, 1 to relief::kWidestRow; 0: the picture's own
    bool inDouble = false;
    bool logarithmic = true;

    bool operator==(const RowsOptions&) const = default;
};
// Throws InputError naming `option`.
std::vector<relief::RowMethod> rowMethods(const RowsOptions& options, const std::string& option);

// A scan line of a polygon: pixels of the picture, or of one that is that much wider.
struct RowsPlace {
    relief::Homography map;  // of these pixels
    double y = 0.5;          // of the picture's row, its centre
    int line = 0;            // its number
    relief::PixelSpan span;  // in which the polygon is seen
    std::int64_t width = 0;  // of the picture
    std::int64_t chosen = 0;
};
// The same line with so many pixels.
RowsPlace widened(const RowsPlace& place, std::int64_t pixels);

// Where the affine variant is worst, in closed form.
struct AffinePlace {
    double x = 0;
    double error = 0;  // texels
    double share = 0;  // of the change of u and v
};

struct RowsData {
    RowsPlace place;
    bool inDouble = false;
    relief::RowErrors row;
    // Of each curve.
    std::vector<std::string> names;
    std::vector<relief::PixelCounts> counts;
    std::optional<AffinePlace> affine;  // where that variant is there and has an error
};
// Takes some milliseconds a curve of 65,536 pixels.
RowsData rowsData(const RowsPlace& place, const std::vector<relief::RowMethod>& methods, bool inDouble);
// How many streams make a curve: k, 2 for opposed, else 1.
int streamsOf(const relief::RowCurve& curve);

// The part of the row that is seen, pixels; empty: all of it.
struct RowsRange {
    double from = 0;
    double to = 0;
    bool operator==(const RowsRange&) const = default;
};

// Where what lies on the drawing, in points.
struct RowsFrame {
    Box whole;
    Box upper;
    Box lower;
    std::vector<Box> strips;               // of streamCurves
    std::vector<std::size_t> stripCurves;  // whose streams are shown pixel by pixel
    relief::PixelSpan lens;                // these pixels
    double from = 0;                       // pixels at the left and right side
    double to = 1;
    double low = 0;  // texels at the sides of the upper plot
    double high = 1;
    bool logarithmic = true;
    double errorLow = 0;  // at the sides of the lower one: texels, or their decimal logarithm
    double errorHigh = 1;

    chart::Scale places() const { return {from, to, upper.x0, upper.x1}; }
    // Marks stand at the middles of their pixels.
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
    // What is too small for the scale lies on its lower side.
    double errorAt(double error) const;
    relief::PixelSpan seen(const RowsData& data) const;
};
RowsFrame rowsFrame(const RowsData& data, const RowsOptions& options, const RowsRange& range, double width,
                    double height);

Drawing rowsPlots(const RowsData& data, const RowsFrame& frame);
// The number of a curve on a plate of its colour.
void addCurveNumber(Drawing& drawing, Point at, std::size_t curve, Point offset, Anchor anchor = Anchor::Center);
// Who computes which pixel; part of the plots.
void addStrips(Drawing& drawing, const RowsData& data, const RowsFrame& frame);
Drawing rowsAxes(const RowsData& data, const RowsFrame& frame);
// Curves, and on request what the marks are.
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
