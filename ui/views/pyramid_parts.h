// The pyramids that the pyramid's pane and its figure show: one, or maxima, means and minima beside each other, each
// where it has most room.
#pragma once

#include <vector>

#include "views/figure.h"

namespace reliefui {

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
