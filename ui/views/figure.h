// One pane as a figure in a file: the same drawings as on the screen, through QPainter. Needs no display and no window.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QImage>

#include "drawings/charts_drawing.h"
#include "drawings/distance_drawing.h"
#include "drawings/footprint_drawing.h"
#include "drawings/profile_drawing.h"
#include "drawings/pyramid_drawing.h"
#include "drawings/rows_drawing.h"
#include "drawings/step_colors.h"
#include "drawings/style.h"
#include "views/turntable.h"
#include "workspace/snapshot.h"

namespace reliefui {

// What panes draw of a snapshot.
struct PyramidOptions {
    relief::PyramidKind kind = relief::PyramidKind::Max;  // the maxima are over the cells, the others over the texels
    bool nearRay = true;
    bool all = false;  // maxima, means and minima beside each other
};
PyramidSource pyramidSource(const Snapshot& snapshot, const PyramidOptions& options);
ProfileSource profileSource(const Snapshot& snapshot);
// Nothing where the chosen pixel shows the sky, or there is none. Not of coarse snapshots.
std::optional<RowsPlace> rowsPlace(const Snapshot& snapshot);

// The heights are drawn so many times as high; without a camera it is seen from the side of the ray.
struct TraceOptions {
    double exaggeration = 1;
    StepColors colors = StepColors::Decision;
    std::optional<Turntable> camera;
};

struct ComparedView;
struct Duel;

struct FigureRequest {
    std::string view;      // one of figureViews()
    double widthMm = 160;  // the height follows from the view
    double dpi = 300;      // of pixels
    Style style;           // theme and language; points are the page's
    PyramidOptions pyramid;
    ProfileOptions profile;
    DistanceOptions distance;
    std::optional<QueryPoint> query;  // of "distance" and "profile": whose distances are shown
    RowsOptions rows;
    RowsRange rowsRange;
    FootprintOptions footprint;
    std::shared_ptr<const ChartsSource> charts;   // of "pareto", which needs nothing of the snapshot, and of "charts"
    std::shared_ptr<const ComparedView> compare;  // of "compare"; null: nothing to compare with
    std::size_t compareShown = 0;                 // of flicker
    TraceOptions trace;
    std::optional<Turntable> slabsCamera;  // from where the slabs are seen
    std::shared_ptr<const Duel> duel;      // of "duel"; null: no ray
    std::size_t duelMoment = 0;
    double duelUpTo = 0;  // as DuelSource::upTo
};

// "charts", "compare", "distance", "drawn", "duel", "footprint", "pareto", "profile", "pyramid", "result", "rows",
// "skipped", "slabs", "steps", "trace".
const std::vector<std::string>& figureViews();

// SVG, PDF or PNG, by the ending of the path. Throws InputError for an unknown view, ending, width or resolution,
// for maps that there are none of; "slabs" and "trace" are PNG only. WorkError if it cannot be drawn or written.
void checkFigure(const FigureRequest& request, const std::string& path);
void writeFigure(const Snapshot& snapshot, const FigureRequest& request, const std::string& path);

// The same as pixels, `width` of them wide.
QImage figureImage(const Snapshot& snapshot, const FigureRequest& request, int width);

}  // namespace reliefui
