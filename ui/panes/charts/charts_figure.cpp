#include "panes/charts/charts_figure.h"

#include "painting/painter.h"
#include "panes/charts/charts_data.h"
#include "panes/figure_caption.h"

namespace reliefui {

std::shared_ptr<const Figure> chartsFigure(std::shared_ptr<const ChartsSource> source, FigureCaption caption) {
    return paintedFigure(
        [source](QPainter& painter, const Box& page, const Style& style) {
            const double unit = style.pixelsPerPoint();
            const Drawing legend = chartsLegend(*source, page.width() / unit - kFigureMargins, style.language);
            const Box room = figureRoom(legend, page, style);
            const ChartsPicture picture =
                chartsPicture(*source, room.width() / unit, room.height() / unit, style.language);
            paintFigure(painter, {&picture.drawing}, legend, page, style);
        },
        std::move(caption),
        [source](const FigurePage&) {
            constexpr double kPareto = 0.68;  // names beside their marks
            constexpr double kAll = 0.95;     // and histograms below
            return source->shown == ChartsShown::Pareto ? kPareto : kAll;
        });
}

std::shared_ptr<const Figure> measuredCharts(std::shared_ptr<const Snapshot> snapshot, const std::string& error) {
    relief::Work work;
    auto charts = std::make_shared<ChartsSource>();
    charts->histograms = histogramsOf(*snapshot, work);
    charts->chosenSteps = chosenSteps(*snapshot);
    // As the pane begins: building all maps of a large picture takes minutes.
    constexpr bool kWithMaps = false;
    charts->pareto =
        paretoSource(*snapshot, measureView(*snapshot, kWithMaps, work), relief::parseErrorMeasure(error, "--error"));
    return chartsFigure(std::move(charts), figureCaption(std::move(snapshot)));
}

}  // namespace reliefui
