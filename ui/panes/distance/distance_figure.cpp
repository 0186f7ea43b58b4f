#include "panes/distance/distance_figure.h"

#include <algorithm>
#include <mutex>

#include "painting/painter.h"
#include "panes/distance/distance_maps.h"
#include "panes/figure_caption.h"
#include "panes/point_finder.h"
#include "workspace/pane_store.h"

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

void checkSlice(const Snapshot& snapshot, int slice, const std::string& what, relief::Work& work) {
    const DistanceOptions options = distanceOptions(stateOf<DistancePane>(snapshot.scenario));
    const DistanceMaps maps = distanceMaps(snapshot, options, {}, work);
    const DistanceFrame frame = distanceFrame(distanceSource(snapshot, maps), options, 0, 1, 1);
    requireRange(what, slice, 0, frame.slices - 1);
}

std::shared_ptr<const Figure> distanceFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                             const DistanceOptions& options, const std::optional<QueryPoint>& point,
                                             const std::vector<Annotation>& notes) {
    return computedFigure([snapshot, step, options, point, notes](const FigurePage& page, relief::Work& work) {
        const DistanceMaps maps = distanceMaps(*snapshot, options, {}, work);
        DistanceSource source = distanceSource(*snapshot, maps);
        source.point = pointOf(*snapshot, point, work);
        const auto legend = [source, options, step](double width, relief::Language language) {
            // The legend's entries do not depend on the size.
            return distanceLegend(source, distancePicture(source, options, step, width, width / 2, language), width,
                                  language);
        };
        // The lambda keeps the maps alive, to which the source refers.
        const auto layers = [source, maps, options, step, notes](double width, double height, const Style& style) {
            const DistancePicture picture = distancePicture(source, options, step, width, height, style.language);
            return std::vector{picture.drawing, distanceMarks(source, picture.frame, step),
                               annotationDrawing(notes, distanceAnnotations(picture.frame), style.language)};
        };
        ChartMaker maker{legend, layers};
        if (!options.nearRay) {
            // A whole slice is as wide as the page, unless it is higher than wide.
            const Box window = distanceFrame(source, options, step, 1, 1).window;
            const double slice = std::min(window.height() / std::max(window.width(), 1e-9), 1.0);
            maker.leastRoom = std::max(maker.leastRoom, slice / page.taller());
        }
        return chartFigure(std::move(maker), figureCaption(snapshot, step));
    });
}

AnnotationFrame distanceAnnotations(const DistanceFrame& frame) {
    constexpr std::array<std::string_view, 3> kViews{"distance-x", "distance-y", "distance-z"};
    const bool level = frame.axis == SliceAxis::Z;
    const auto turned = [level, slab = std::max(frame.slab, 1e-9)](Point p, bool toData) {
        if (level) return p;
        return toData ? Point{p.x, 1 - p.y / slab} : Point{p.x, (1 - p.y) * slab};
    };
    return {kViews[static_cast<std::size_t>(frame.axis)],
            [frame, turned](Point p) { return frame.at(turned(p, false)); },
            [frame, turned](Point p) { return turned(frame.uvAt(p), true); }, frame.plot};
}

}  // namespace reliefui
