// Where the slabs of pyramids stand in space: in piles side by side, the finest level undermost, so many of them as
// make the slabs largest in the room there is. Seen from the elevation at which panes begin, no slab hides another or
// the title at its front edge.
#pragma once

#include <vector>

namespace reliefui {

struct SlabSize {
    double width = 1;  // in space
    double depth = 1;
    double titleWidth = 0;  // pixels
    double titleHeight = 0;
};

struct SlabPlace {
    int pile = 0;  // from the left
    double x = 0;  // of its left edge
    double z = 0;
};

struct SlabPiles {
    double scale = 1;                            // pixels of a unit of space
    bool titled = true;                          // there is room for the titles
    std::vector<std::vector<SlabPlace>> places;  // of each pyramid's levels
};

// width, height: pixels of the view.
SlabPiles slabPiles(const std::vector<std::vector<SlabSize>>& pyramids, double width, double height);

}  // namespace reliefui
