// The pyramids that the pyramid's pane and its figure show: one, or maxima, means and minima beside each other, each
// where it has most room.
#pragma once

#include <vector>

#include "painting/range_legend.h"
#include "panes/pyramid/pyramid_drawing.h"
#include "panes/pyramid/pyramid_state.h"
#include "scenario/scenario.h"
#include "workspace/snapshot.h"

namespace reliefui {

struct PyramidOptions {
    relief::PyramidKind kind = relief::PyramidKind::Max;  // the maxima are over the cells, the others over the texels
    bool nearRay = true;
    bool all = false;      // maxima, means and minima beside each other
    bool slender = false;  // for slabs in space: PyramidSource::slender
    ColorRange heights = standardRange(RangeOf::Height);
};
PyramidOptions pyramidOptions(const relief::Scenario& scenario);
PyramidSource pyramidSource(const Snapshot& snapshot, const PyramidOptions& options);

struct PyramidPart {
    PyramidSource source;
    PyramidPicture picture;
};

// Refers to the snapshot.
struct PyramidParts {
    std::vector<PyramidPart> parts;
    Drawing levels;        // of all of them
    RangedValues heights;  // that are seen on any level, in the colours of all

    // Under a point of the drawing; null: none.
    const PyramidPart* at(Point point) const;
};
// width, height: points; language: of the name of the heights. Of large pictures only the pyramids that are there.
PyramidParts pyramidParts(const Snapshot& snapshot, const PyramidOptions& options, double width, double height,
                          relief::Language language = relief::Language::English);
Drawing partsMarks(const PyramidParts& parts, int step);

}  // namespace reliefui
