// How the pixels of a picture see the slab of one polygon: the view ray through any point of the picture. Made with the
// frame; filters ask it for rays between the pixels' centres.
//
// Frames and units: pixel (i, j) centred at (i + 1/2, j + 1/2), x right, y down; s, t in texels of the height map. A
// ray comes from the eye at (sEye, tEye) and a height above the top plane; where it enters at (s0, t0), its run per
// unit of descent is (s0 - sEye, t0 - tEye) * thickness / height.
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
    int width = 1;           // of the polygon's picture, texels
    int height = 1;
    std::uint8_t number = 0;  // of the polygon in the scene

    ViewRay rayAt(double s0, double t0) const { return {s0, t0, (s0 - sEye) * runPerTexel, (t0 - tEye) * runPerTexel}; }
    // A point on the very edge may be rounded out of the picture, where under border nothing is; beyond it, the edge is
    // seen. q > 0.
    ViewRay ray(const TexelPoint& at) const {
        return rayAt(std::clamp(at.s, 0.0, static_cast<double>(width)),
                     std::clamp(at.t, 0.0, static_cast<double>(height)));
    }
};

}  // namespace relief
