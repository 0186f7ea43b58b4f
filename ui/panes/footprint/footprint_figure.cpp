#include "panes/footprint/footprint_figure.h"

#include "painting/painter.h"
#include "panes/figure_caption.h"

namespace reliefui {

std::shared_ptr<const Figure> footprintFigure(std::shared_ptr<const Snapshot> snapshot,
                                              const FootprintOptions& options) {
    requireRay("footprint", *snapshot);
    if (!snapshot->footprint) emptyFigure("footprint", relief::MessageId::ExportNoHit);
    return paintedFigure(
        [snapshot, options](QPainter& painter, const Box& page, const Style& style) {
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
        },
        figureCaption(snapshot));
}

}  // namespace reliefui
