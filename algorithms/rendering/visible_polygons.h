// The polygons of a scene that the camera sees, each with what turns a pixel into the view ray in its slab: the only
// code that makes rays of pixels, for whole frames and for single ones.
#pragma once

#include <optional>
#include <vector>

#include "filtering/pixel_view.h"
#include "mapping/clipping.h"
#include "mapping/rows/rows.h"
#include "relief/camera.h"
#include "rendering/scene.h"

namespace relief {

struct VisiblePolygon : PixelView {
    TexturedQuad quad;
    std::vector<glm::dvec2> screen;  // its visible part
    double inverseDepthPerQ = 0;     // 1 / camera depth = q * this
    RowOptions mapping = kDirectRows;
    int screenWidth = 0;

    struct Entry {
        ViewRay ray;
        float inverseDepth;
    };
    // Through the centre of pixel (x, y), which lies in the polygon's span. Mappings but direct: makes the whole row.
    Entry entry(int x, int y) const;
    // Of the pixels [first, last) of row y, within its span. Returns the largest distance, in texels, between the
    // mapping's coordinates and those of direct.
    double entries(int y, PixelSpan span, int first, int last, Entry* out) const;
    float inverseDepth(int x, int y) const;
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

// reliefDepth: slab thickness in texture widths. mapping: how texture coordinates are made along the rows of pixels:
// direct in double, pixel by pixel; the others in float, a polygon's part of a row at a time, as [PERSP] has them.
VisiblePolygons visiblePolygons(const std::vector<TexturedQuad>& scene, const PinholeCamera& camera, int width,
                                int height, double reliefDepth, const RowOptions& mapping = kDirectRows);

}  // namespace relief
