// base=auto: one base level for a whole frame, that of the resolution its pixels need. [MIP18]: tracing ends at the
// level "that corresponds to the resolution needed".
#pragma once

#include "rendering/frame.h"

namespace relief {

struct FootprintLevel {
    int level = 0;
    double pixelTexels = 0;  // width of the narrowest pixel, texels: minor semi-axis of the circle of radius 1 pixel
};
// The highest level whose texels are no wider than the narrowest pixel of the view; {0, 0} where no polygon is seen.
// Pixels are looked at where they lie on the top plane, on a grid of about 32 x 32 and at both ends of its rows.
// Throws InputError("--camera", ...).
FootprintLevel footprintLevel(const FrameRequest& request);

// The method with base=auto, its own or that of a method inside it, replaced by the view's level. The request's own
// method is not looked at.
MethodChoice methodOfView(const FrameRequest& request, MethodChoice method);

}  // namespace relief
