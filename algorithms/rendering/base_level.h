// Computes the base level for base=auto: one pyramid level for a whole frame, at the resolution that its pixels need.
// [MIP18]: tracing ends at the level "that corresponds to the resolution needed".
#pragma once

#include "rendering/frame.h"

namespace relief {

struct FootprintLevel {
    int level = 0;
    double pixelTexels = 0;  // width of the narrowest pixel, texels: minor semi-axis of the circle of radius 1 pixel
};
// Returns the highest pyramid level whose texels are no wider than the narrowest pixel of the view, or {0, 0} if no
// polygon is visible. Pixel widths are measured on the top plane, on a grid of about 32 x 32 pixels including both ends
// of its rows. Throws InputError("--camera", ...) for a degenerate camera.
FootprintLevel footprintLevel(const FrameRequest& request);

// Returns `method` with base=auto, its own or that of a method inside it, replaced by the level that footprintLevel()
// finds for the request's view. The request's own method is ignored.
MethodChoice methodOfView(const FrameRequest& request, MethodChoice method);

}  // namespace relief
