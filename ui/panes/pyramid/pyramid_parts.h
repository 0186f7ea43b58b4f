// The pyramids that the pyramid's pane and its figure show: one, or maxima, means and minima beside each other, each
// where it has most room.
#pragma once

#include <vector>

#include "panes/pyramid/pyramid_drawing.h"
#include "workspace/pane_states.h"
#include "workspace/snapshot.h"

namespace reliefui {

struct PyramidOptions {
    relief::PyramidKind kind = relief::PyramidKind::Max;  // the maxima are over the cells, the others over the texels
    bool nearRay = true;
    bool all = false;  // maxima, means and minima beside each other
};
PyramidOptions pyramidOptions(const PyramidPane& pane);
PyramidSource pyramidSource(const Snapshot& snapshot, const PyramidOptions& options);

struct PyramidPart {
    PyramidSource source;
    PyramidPicture picture;
};

// Refers to the snapshot.
struct PyramidParts {
    std::vector<PyramidPart> parts;
    Drawing levels;  // of all of them

    // Under a point of the drawing; null: none.
    const PyramidPart* at(Point point) const;
};
// width, height: points. Of large pictures only the pyramids that are there.
PyramidParts pyramidParts(const Snapshot& snapshot, const PyramidOptions& options, double width, double height);
Drawing partsMarks(const PyramidParts& parts, int step);

}  // namespace reliefui
