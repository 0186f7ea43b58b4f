// The view of the slab of one polygon: the view ray through any point of the picture. The renderer makes it with the
// frame; filters use it for rays between pixel centres.
//
// Frames and units: pixel (i, j) centred at (i + 1/2, j + 1/2), x right, y down; s, t in texels of the height map. A
// ray comes from the eye, which is at (sEye, tEye) and at some height above the top plane. If it enters at (s0, t0),
// its run per unit of descent is (s0 - sEye, t0 - tEye) * thickness / height.
#pragma once

#include <algorithm>
#include <cstdint>

#include "mapping/homography.h"
#include "relief/ray.h"

namespace relief {

struct PixelView {
    Homography texelFromScreen;
    double sEye = 0;
    double tEye = 0;
    double runPerTexel = 0;  // thickness / height of the eye above the plane
    int width = 1;           // size of the polygon's height map, texels
    int height = 1;
    std::uint8_t number = 0;  // index of the polygon in the scene

    ViewRay rayAt(double s0, double t0) const { return {s0, t0, (s0 - sEye) * runPerTexel, (t0 - tEye) * runPerTexel}; }
    // The ray through a point of the polygon; q > 0. Rounding may put a point on the edge outside the map, where border
    // addressing has no surface, so (s, t) is clamped to the map.
    ViewRay ray(const TexelPoint& at) const {
        return rayAt(std::clamp(at.s, 0.0, static_cast<double>(width)),
                     std::clamp(at.t, 0.0, static_cast<double>(height)));
    }
};

}  // namespace relief
