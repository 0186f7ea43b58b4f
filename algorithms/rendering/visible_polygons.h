// The polygons of a scene that the camera sees, each with the mapping from a pixel to the view ray in its slab. This is
// the only code that makes rays from pixels, for whole frames and for single pixels.
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
    std::vector<glm::dvec2> screen;  // its visible part, pixels
    double inverseDepthPerQ = 0;     // 1 / camera depth = q * this
    RowOptions mapping = kDirectRows;
    int screenWidth = 0;

    struct Entry {
        ViewRay ray;
        float inverseDepth;
    };
    // Returns the entry for the centre of pixel (x, y), which must lie in the polygon's span. Mappings other than
    // direct evaluate the whole row.
    Entry entry(int x, int y) const;
    // Writes the entries of the pixels [first, last) of row y, within its span. Returns the largest distance, in
    // texels, between the mapping's coordinates and those of direct.
    double entries(int y, PixelSpan span, int first, int last, Entry* out) const;
    // Returns 1 / camera depth of the polygon at the centre of pixel (x, y), 1 / world units.
    float inverseDepth(int x, int y) const;
    // Returns the pixels of row y that the polygon covers, [begin, end) within [0, width).
    PixelSpan span(int y, int width) const;
};

struct VisiblePolygons {
    std::vector<VisiblePolygon> polygons;
    int total = 0;
    int backFacing = 0;
    int offScreen = 0;

    // Returns the nearest polygon at a pixel; null: sky.
    const VisiblePolygon* at(int x, int y, int width) const;
};

// Returns the scene's polygons that the camera sees. reliefDepth: slab thickness in texture widths. mapping: how
// texture coordinates are computed along the rows of pixels: direct in double for each pixel; the others in float, for
// a polygon's whole part of a row, as in [PERSP].
VisiblePolygons visiblePolygons(const std::vector<TexturedQuad>& scene, const PinholeCamera& camera, int width,
                                int height, double reliefDepth, const RowOptions& mapping = kDirectRows);

}  // namespace relief
