// The view rays of all pixels of a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "rendering/frame.h"

namespace relief {

// rays: of the pixels that see a polygon, row by row from the top. x, y: their pixels; polygon: the index of the
// polygon that each sees, in `polygons`.
struct ViewRays {
    RayBlock rays;
    std::vector<std::int32_t> x, y;
    std::vector<std::uint8_t> polygon;
    std::vector<VisiblePolygon> polygons;
};

// Returns the rays of all pixels that see a polygon. Throws InputError for a degenerate camera, MemoryError.
ViewRays viewRays(const FrameRequest& request);

}  // namespace relief
