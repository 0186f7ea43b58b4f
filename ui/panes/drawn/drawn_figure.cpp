#include "panes/drawn/drawn_figure.h"

#include "panes/drawn/drawn_view.h"
#include "panes/figure_caption.h"

namespace reliefui {

std::shared_ptr<const Figure> drawnFigure(std::shared_ptr<const Snapshot> snapshot) {
    if (snapshot->scenario.pictures.drawn.empty()) throw EmptyFigure("drawn", relief::MessageId::ExportNoDrawn);
    return paintedFigure(
        [snapshot](QPainter& painter, const Box& page, const Style& style) {
            const DrawnSource source = drawnSource(*snapshot);
            paintDrawn(painter, source, page, style);
        },
        figureCaption(snapshot));
}

}  // namespace reliefui
