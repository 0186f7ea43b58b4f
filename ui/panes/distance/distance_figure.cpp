#include "panes/distance/distance_figure.h"

#include "painting/painter.h"
#include "panes/distance/distance_maps.h"
#include "panes/figure_caption.h"
#include "panes/point_asker.h"

namespace reliefui {

DistanceOptions distanceOptions(const DistancePane& pane, const ColorRanges& ranges) {
    DistanceOptions options;
    options.kind = pane.map;
    options.minus = pane.minus;
    if (!pane.axis.empty()) options.axis = static_cast<SliceAxis>(pane.axis.front() - 'x');
    options.slice = pane.slice;
    options.sector = pane.sector;
    options.isoLines = pane.lines;
    options.nearRay = pane.nearRay;
    options.ranges = ranges;
    return options;
}

DistancePane paneOf(const DistanceOptions& options) {
    DistancePane pane;
    pane.map = options.kind;
    pane.minus = options.minus;
    if (options.axis) pane.axis = std::string(1, static_cast<char>('x' + static_cast<int>(*options.axis)));
    pane.slice = options.slice;
    pane.sector = options.sector;
    pane.lines = options.isoLines;
    pane.nearRay = options.nearRay;
    return pane;
}

std::shared_ptr<const Figure> distanceFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                             const DistanceOptions& options, const std::optional<QueryPoint>& point) {
    return computedFigure([snapshot, step, options, point](const FigurePage&, relief::Work& work) {
        const DistanceMaps maps = distanceMaps(*snapshot, options, {}, work);
        DistanceSource source = distanceSource(*snapshot, maps);
        source.point = pointOf(*snapshot, point, work);
        const auto paint = [snapshot, maps, source, step, options](QPainter& painter, const Box& page,
                                                                   const Style& style) {
            const double unit = style.pixelsPerPoint();
            const auto pictureIn = [&](const Box& room) {
                return distancePicture(source, options, step, room.width() / unit, room.height() / unit,
                                       style.language);
            };
            // What the legend names does not depend on the room.
            const Drawing legend = distanceLegend(source, pictureIn(figureRoom({}, page, style)),
                                                  page.width() / unit - kFigureMargins, style.language);
            const DistancePicture picture = pictureIn(figureRoom(legend, page, style));
            const Drawing marks = distanceMarks(source, picture.frame, step);
            paintFigure(painter, {&picture.drawing, &marks}, legend, page, style);
        };
        return paintedFigure(paint, figureCaption(snapshot, step));
    });
}

}  // namespace reliefui
