// The pyramids shown by the pyramid pane and its figure: one, or maxima, means and minima, arranged so that they are as
// large as possible.
#pragma once

#include <vector>

#include "painting/range_legend.h"
#include "panes/pyramid/pyramid_drawing.h"
#include "panes/pyramid/pyramid_state.h"
#include "scenario/scenario.h"
#include "workspace/snapshot.h"

namespace reliefui {

struct PyramidOptions {
    relief::PyramidKind kind = relief::PyramidKind::Max;  // maxima lie over the cells, the others over the texels
    bool nearRay = true;
    bool all = false;      // show maxima, means and minima
    bool slender = false;  // for the slab view, see PyramidSource::slender
    ColorRange heights = standardRange(RangeOf::Height);
};
PyramidOptions pyramidOptions(const relief::Scenario& scenario);
PyramidSource pyramidSource(const Snapshot& snapshot, const PyramidOptions& options);

struct PyramidPart {
    PyramidSource source;
    PyramidPicture picture;
};

// Holds references to the snapshot.
struct PyramidParts {
    std::vector<PyramidPart> parts;
    Drawing levels;        // of all parts
    RangedValues heights;  // values visible on any level, with the common colour range

    // The part at a point of the drawing; null: none.
    const PyramidPart* at(Point point) const;
};
// width, height: in points; language: of the name of the heights. For large pictures only the pyramids that exist.
PyramidParts pyramidParts(const Snapshot& snapshot, const PyramidOptions& options, double width, double height,
                          relief::Language language = relief::Language::English);
Drawing partsMarks(const PyramidParts& parts, int step);

}  // namespace reliefui
