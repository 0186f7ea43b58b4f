// Inside the relief-aware filter, not for others.
#pragma once

#include "filtering/elliptical_visible.h"

namespace relief {

// A piece of the surface that one colour stands for: a texel of the level, or a part of one where the relief under it
// is steep. Before and after its test.
struct VisibleKernel::Piece {
    FootprintTexel texel;  // place, and what became of it
    Color color{0};
    double share = 1;            // of a texel of the footprint's level
    double s = 0, t = 0, h = 0;  // its surface point, texels of the height map
    double du = 0, dv = 0;       // its place in the footprint, texels of the footprint's level
};

}  // namespace relief
