// The footprint error of filters that compute footprints incrementally along rows.
#pragma once

#include "rendering/frame.h"

namespace relief {

// Returns the largest relative difference between a footprint's semi-axis and that of ellipse=direct, over the rows of
// this part of a picture; 0 for filters without that option. Computes both again. Throws Cancelled.
double ellipseError(const Frame& part, const FrameRequest& request, Work& work);

}  // namespace relief
