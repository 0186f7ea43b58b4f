// The polygons of a scene that the camera sees, each with what turns a pixel into the view ray in its slab: the only
// text that makes rays of pixels, for whole frames and for single ones.
#pragma once

#include <optional>
#include <vector>

#include "mapping/clipping.h"
#include "relief/ray.h"
#include "rendering/camera.h"
#include "rendering/scene.h"

namespace relief {

// A view ray in slab coordinates comes from the eye at (sEye, tEye) and height above the top plane; where it enters at
// (s0, t0), its run per unit of descent is (s0 - sEye, t0 - tEye) * thickness / height.
struct VisiblePolygon {
    TexturedQuad quad;
    std::uint8_t number = 0;  // in the scene
    Homography texelFromScreen;
    std::vector<glm::dvec2> screen;  // its visible part
    double sEye = 0;
    double tEye = 0;
    double runPerTexel = 0;       // thickness / height of the eye above the plane
    double inverseDepthPerQ = 0;  // 1 / camera depth = q * this

    ViewRay rayAt(double s0, double t0) const { return {s0, t0, (s0 - sEye) * runPerTexel, (t0 - tEye) * runPerTexel}; }

    struct Entry {
        ViewRay ray;
        float inverseDepth;
    };
    // Through the centre of pixel (x, y), which lies in the polygon's span.
    Entry entry(int x, int y) const;
    // Pixels of row y, [begin, end) within [0, width).
    PixelSpan span(int y, int width) const;
};

struct VisiblePolygons {
    std::vector<VisiblePolygon> polygons;
    int total = 0;
    int backFacing = 0;
    int offScreen = 0;

    // The nearest polygon at a pixel; nothing: sky.
    const VisiblePolygon* at(int x, int y, int width) const;
};

// reliefDepth: slab thickness in texture widths.
VisiblePolygons visiblePolygons(const std::vector<TexturedQuad>& scene, const PinholeCamera& camera, int width,
                                int height, double reliefDepth);

}  // namespace relief
