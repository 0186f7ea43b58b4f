#include "views/pane_options.h"

namespace reliefui {

PyramidOptions pyramidOptions(const PyramidPane& pane) {
    PyramidOptions options;
    if (pane.levels == "mean") options.kind = relief::PyramidKind::Mean;
    if (pane.levels == "min") options.kind = relief::PyramidKind::Min;
    options.all = pane.levels == "all";
    options.nearRay = pane.nearRay;
    return options;
}

DistanceOptions distanceOptions(const DistancePane& pane) {
    DistanceOptions options;
    options.kind = pane.map;
    options.minus = pane.minus;
    if (!pane.axis.empty()) options.axis = static_cast<SliceAxis>(pane.axis.front() - 'x');
    options.slice = pane.slice;
    options.sector = pane.sector;
    options.isoLines = pane.lines;
    options.nearRay = pane.nearRay;
    return options;
}

DistancePane distancePane(const DistanceOptions& options) {
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

RowsOptions rowsOptions(const RowsPane& pane) {
    return {pane.variants, pane.pixels, pane.inDouble, pane.logarithmic};
}

RowsPane rowsPane(const RowsOptions& options) {
    return {options.methods, options.pixels, options.inDouble, options.logarithmic};
}

void takeProfile(ProfileOptions& options, const ProfilePane& pane) {
    options.levels = pane.allLevels ? LevelsShown::All : LevelsShown::Visited;
    options.nearRay = pane.nearRay;
    options.trueAspect = pane.trueAspect;
}

void takePanes(FigureRequest& request, const PaneStates& panes) {
    request.pyramid = pyramidOptions(panes.pyramid);
    takeProfile(request.profile, panes.profile);
    request.distance = distanceOptions(panes.distance);
    request.query = panes.query;
    request.rows = rowsOptions(panes.rows);
    request.trace.exaggeration = panes.trace.heights;
    request.trace.colors = stepColors(panes.trace.colors);
    request.footprint.neighbours = panes.footprint.neighbours;
}

}  // namespace reliefui
