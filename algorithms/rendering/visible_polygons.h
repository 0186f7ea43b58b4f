// The polygons of a scene that the camera sees, each with what turns a pixel into the view ray in its slab: the only
// text that makes rays of pixels, for whole frames and for single ones.
#pragma once

#include <optional>
#include <vector>

#include "filtering/pixel_view.h"
#include "mapping/clipping.h"
#include "relief/camera.h"
#include "rendering/scene.h"

namespace relief {

struct VisiblePolygon : PixelView {
    TexturedQuad quad;
    std::vector<glm::dvec2> screen;  // its visible part
    double inverseDepthPerQ = 0;     // 1 / camera depth = q * this

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
