// Private to the relief-aware filter.
#pragma once

#include "filtering/elliptical_visible.h"

namespace relief {

// A piece of the surface with one colour: a texel of the level, or a part of one where the relief under it is steep.
struct VisibleKernel::Piece {
    FootprintTexel texel;  // place, and the result of its test
    Color color{0};
    double share = 1;            // area in texels of the footprint's level
    double s = 0, t = 0, h = 0;  // surface point, texels of the height map and height
    double du = 0, dv = 0;       // place in the footprint, texels of the footprint's level
};

}  // namespace relief
