// The charts pane: run time against error at the top, below it histograms of the frame's rays by number of steps and by
// distance from the exact hit. Counts are logarithmic, because the few worst rays are of most interest.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "measuring/bench/view_bench.h"
#include "panes/charts/pareto_drawing.h"

namespace reliefui {

enum class ChartsShown : std::uint8_t { All, Pareto, Histograms };

struct ChartsSource {
    ChartsShown shown = ChartsShown::All;
    std::shared_ptr<const ParetoSource> pareto;                        // null: not measured yet
    relief::MessageId missing = relief::MessageId::DrawChartPress;     // message shown if pareto is null
    std::shared_ptr<const relief::FrameHistograms> histograms;         // null: not counted yet
    relief::Message uncounted{relief::MessageId::DrawComparePending};  // message shown if histograms is null
    std::int64_t chosenSteps = 0;                                      // of the chosen pixel's ray; 0 without a ray
};

enum class BarKind : std::uint8_t { Steps, Exact, Before, Behind, Wrong };
struct HistogramBar {
    BarKind kind = BarKind::Steps;
    Box box;         // full height of the plot, for picking
    double low = 0;  // range [low, high) in steps or texels
    double high = 0;
    std::int64_t rays = 0;
    std::size_t bin = 0;  // index in the histogram of steps or errors
};
struct HistogramPicture {
    Box plot;
    double countHigh = 1;  // decimal logarithm of the count at the top
    std::vector<HistogramBar> bars;
    Drawing drawing;

    // The bottom of the axis corresponds to less than one ray, so that a bar of one ray is visible.
    static constexpr double kCountLow = -0.35;
    chart::Scale counts() const { return {kCountLow, countHigh, plot.y1, plot.y0, chart::Numbers::Powers}; }
    double yAt(std::int64_t rays) const { return rays > 0 ? counts().at(static_cast<double>(rays)) : plot.y1; }
};
// chosen: number of steps of the pixel's ray, which is marked; 0: no mark.
HistogramPicture stepsHistogram(const relief::FrameHistograms& data, std::int64_t chosen, const Box& room);
HistogramPicture errorHistogram(const relief::FrameHistograms& data, const Box& room);

struct ChartsPicture {
    std::optional<ParetoPicture> pareto;
    std::optional<HistogramPicture> steps, errors;
    Drawing drawing;
};
// width, height: in points.
ChartsPicture chartsPicture(const ChartsSource& source, double width, double height, relief::Language language);
Drawing chartsLegend(const ChartsSource& source, double width, relief::Language language);

// The item under a point of the drawing.
struct ChartsReading {
    std::optional<std::size_t> point;  // index in the table
    std::optional<HistogramBar> bar;
};
ChartsReading chartsReading(const ChartsPicture& picture, Point at);

}  // namespace reliefui
