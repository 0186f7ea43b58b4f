#include "panes/drawn/drawn_figure.h"

#include "panes/drawn/drawn_view.h"

namespace reliefui {

namespace {

struct DrawnFigure : Figure {
    std::shared_ptr<const Snapshot> snapshot;

    void paint(QPainter& painter, const Box& page, const Style& style) const override {
        const DrawnSource source = drawnSource(*snapshot);
        if (source.relief.empty()) return paintEmpty(painter, relief::MessageId::DrawDrawnNone, page, style);
        paintDrawn(painter, source, page, style);
    }
};

}  // namespace

std::shared_ptr<const Figure> drawnFigure(std::shared_ptr<const Snapshot> snapshot) {
    auto figure = std::make_shared<DrawnFigure>();
    figure->snapshot = std::move(snapshot);
    return figure;
}

}  // namespace reliefui
