#include "panes/drawn/drawn_figure.h"

#include "panes/drawn/drawn_view.h"

namespace reliefui {

std::shared_ptr<const Figure> drawnFigure(std::shared_ptr<const Snapshot> snapshot) {
    return paintedFigure([snapshot = std::move(snapshot)](QPainter& painter, const Box& page, const Style& style) {
        const DrawnSource source = drawnSource(*snapshot);
        if (source.relief.empty()) return paintEmpty(painter, relief::MessageId::DrawDrawnNone, page, style);
        paintDrawn(painter, source, page, style);
    });
}

}  // namespace reliefui
