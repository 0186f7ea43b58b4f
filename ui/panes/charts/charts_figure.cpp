#include "panes/charts/charts_figure.h"

#include "painting/painter.h"
#include "panes/charts/charts_data.h"
#include "panes/figure_caption.h"

namespace reliefui {

std::shared_ptr<const Figure> chartsFigure(std::shared_ptr<const ChartsSource> source, FigureCaption caption) {
    const auto legend = [source](double width, relief::Language language) {
        return chartsLegend(*source, width, language);
    };
    const auto layers = [source](double width, double height, const Style& style) {
        return std::vector{chartsPicture(*source, width, height, style.language).drawing};
    };
    constexpr double kPareto = 0.68;  // aspect of the Pareto chart, with names next to the marks
    constexpr double kAll = 0.95;     // aspect with histograms below
    const double aspect = source->shown == ChartsShown::Pareto ? kPareto : kAll;
    return chartFigure({legend, layers, aspect, aspect - 0.1}, std::move(caption));
}

std::shared_ptr<const Figure> measuredCharts(std::shared_ptr<const Snapshot> snapshot, const std::string& error) {
    relief::Work work;
    auto charts = std::make_shared<ChartsSource>();
    charts->histograms = histogramsOf(*snapshot, work);
    charts->chosenSteps = chosenSteps(*snapshot);
    // The pane's default: building all maps of a large picture takes minutes.
    constexpr bool kWithMaps = false;
    charts->pareto =
        paretoSource(*snapshot, measureView(*snapshot, kWithMaps, work), relief::parseErrorMeasure(error, "--error"));
    return chartsFigure(std::move(charts), figureCaption(std::move(snapshot)));
}

}  // namespace reliefui
