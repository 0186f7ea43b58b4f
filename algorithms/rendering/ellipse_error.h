// What a picture's footprints are wrong by where the filter computes them along rows.
#pragma once

#include "rendering/frame.h"

namespace relief {

// The largest relative difference of a footprint's semi-axis from ellipse=direct, over the rows of this part of a
// picture; 0 of filters without that option. Computes both anew. Throws Cancelled.
double ellipseError(const Frame& part, const FrameRequest& request, Work& work);

}  // namespace relief
