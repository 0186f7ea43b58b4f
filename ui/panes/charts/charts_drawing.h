// The charts pane: run time against error above, below how many rays of the frame took how many steps, and how far they
// end from the exact hit. Counts are logarithmic: the few rays that are worst are what is looked for.
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
    std::shared_ptr<const ParetoSource> pareto;                     // null: not measured yet
    relief::MessageId missing = relief::MessageId::DrawChartPress;  // what is said then
    std::shared_ptr<const relief::FrameHistograms> histograms;      // null: not counted yet
    std::int64_t chosenSteps = 0;                                   // of the chosen pixel's ray; 0: there is none
};

enum class BarKind : std::uint8_t { Steps, Exact, Before, Behind, Wrong };
struct HistogramBar {
    BarKind kind = BarKind::Steps;
    Box box;         // of the plot's height: what the pointer finds
    double low = 0;  // steps or texels, from low to below high
    double high = 0;
    std::int64_t rays = 0;
    std::size_t bin = 0;  // of steps or errors
};
struct HistogramPicture {
    Box plot;
    double countHigh = 1;  // decimal logarithm at the upper side
    std::vector<HistogramBar> bars;
    Drawing drawing;

    // The lower side lies below one ray, so that one is seen.
    static constexpr double kCountLow = -0.35;
    chart::Scale counts() const { return {kCountLow, countHigh, plot.y1, plot.y0, chart::Numbers::Powers}; }
    double yAt(std::int64_t rays) const { return rays > 0 ? counts().at(static_cast<double>(rays)) : plot.y1; }
};
// chosen: of the pixel's ray, marked; 0: none.
HistogramPicture stepsHistogram(const relief::FrameHistograms& data, std::int64_t chosen, const Box& room);
HistogramPicture errorHistogram(const relief::FrameHistograms& data, const Box& room);

struct ChartsPicture {
    std::optional<ParetoPicture> pareto;
    std::optional<HistogramPicture> steps, errors;
    Drawing drawing;
};
// width, height: points.
ChartsPicture chartsPicture(const ChartsSource& source, double width, double height, relief::Language language);
Drawing chartsLegend(const ChartsSource& source, double width, relief::Language language);

// What is under a point of the drawing.
struct ChartsReading {
    std::optional<std::size_t> point;  // of the table
    std::optional<HistogramBar> bar;
};
ChartsReading chartsReading(const ChartsPicture& picture, Point at);

}  // namespace reliefui
