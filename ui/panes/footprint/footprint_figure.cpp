#include "panes/footprint/footprint_figure.h"

#include <algorithm>

#include "painting/painter.h"
#include "panes/footprint/weight_drawing.h"

namespace reliefui {

namespace {

struct FootprintFigure : Figure {
    std::shared_ptr<const Snapshot> snapshot;
    FootprintOptions options;

    bool weighed() const { return options.weights && snapshot->footprint && hasWeights(*snapshot->footprint); }
    // Points of the page for the weights below the footprint: plots, their legend, a margin.
    double weightsHeight(double points, relief::Language language) const {
        if (!weighed()) return 0;
        const Drawing legend = weightLegend(*snapshot->footprint, points - kFigureMargins, language);
        return std::clamp(0.42 * points, 110.0, 220.0) + legend.bounds.height() + 1.5 * kFigureMargins;
    }
    double aspect(const FigurePage& page) const override {
        const double points = page.widthMm / kMmPerPoint;
        return Figure::aspect(page) + weightsHeight(points, page.style.language) / points;
    }
    void paint(QPainter& painter, const Box& page, const Style& style) const override {
        const double unit = style.pixelsPerPoint();
        const double below = weightsHeight(page.width() / unit, style.language) * unit;
        paintFootprint(painter, {page.x0, page.y0, page.x1, page.y1 - below}, style);
        if (below > 0) paintWeights(painter, {page.x0, page.y1 - below, page.x1, page.y1}, style);
    }
    void paintWeights(QPainter& painter, const Box& page, const Style& style) const {
        const double unit = style.pixelsPerPoint();
        const Drawing legend = weightLegend(*snapshot->footprint, page.width() / unit - kFigureMargins, style.language);
        const Box room = figureRoom(legend, page, style);
        const Drawing plots = weightDrawing(*snapshot->footprint, {0, 0, room.width() / unit, room.height() / unit});
        paintFigure(painter, {&plots}, legend, page, style);
    }
    void paintFootprint(QPainter& painter, const Box& page, const Style& style) const {
        using relief::MessageId;
        if (!snapshot->footprint) {
            const MessageId why = snapshot->trace.onRelief ? MessageId::DrawFootprintNoHit : MessageId::DrawNoRelief;
            return paintEmpty(painter, snapshot->scenario.pixel ? why : MessageId::DrawFootprintNoPixel, page, style);
        }
        const PixelFootprint& footprint = *snapshot->footprint;
        const double width = page.width() / style.pixelsPerPoint() - kFigureMargins;
        FootprintOptions named = options;
        named.numbers = true;
        Drawing legend = footprintLegend(footprint, named, true, width, style.language);
        const Box room = figureRoom(legend, page, style);
        const Drawing texture = footprintTexture(footprint, room.width() / room.height());
        const double scale = ViewMap::fitting(texture.bounds, room).scale / style.pixelsPerPoint();
        const FootprintMarks marks = footprintMarks(footprint, options, texture.bounds, scale);
        if (!marks.weights) legend = footprintLegend(footprint, named, false, width, style.language);
        paintFigure(painter, {&texture, &marks.drawing}, legend, page, style);
    }
};

}  // namespace

std::shared_ptr<const Figure> footprintFigure(std::shared_ptr<const Snapshot> snapshot,
                                              const FootprintOptions& options) {
    auto figure = std::make_shared<FootprintFigure>();
    figure->snapshot = std::move(snapshot);
    figure->options = options;
    return figure;
}

}  // namespace reliefui
