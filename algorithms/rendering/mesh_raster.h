// Displacement mapping in a frame: the mesh projected, cut at the near plane, rasterised with perspective-correct rows
// and a depth buffer. It fills what tracing the rays would fill: outcome, lambda, s, t of every pixel.
//
// A polygon shows what is seen through it, as the tracers do: pixels that another polygon or the sky covers are not
// drawn, nor (border) those where the view ray enters outside the picture, nor what lies outside the polygon's texels.
// Back faces are not drawn: a view ray comes from above. Equal bits for any division into areas: every pixel sees the
// same triangles in the same order, by the fill rule of mapping/clipping.h, and the nearest wins. Agrees with
// DisplacementTracer to the rounding of projected coordinates, except at silhouettes, where the sides of a pixel's
// centre are decided on the screen here and in the slab there. Cost: O(vertices) a frame and O(vertices of the blocks
// that touch it) an area; 16 bytes a block of 16 x 16 quads.
#pragma once

#include <cstdint>
#include <vector>

#include "relief/methods/displacement_mesh.h"
#include "relief/ray.h"
#include "rendering/visible_polygons.h"

namespace relief {

struct RayStage;

// Pixels [x0, x1) x [y0, y1).
struct PixelArea {
    int x0, y0, x1, y1;
};

class MeshRaster {
  public:
    // Finds where the blocks lie on the screen, in parallel. References are kept: they must outlive it.
    MeshRaster(const DisplacementMesh& mesh, const VisiblePolygons& visible, const PinholeCamera& camera, int width,
               Work& work);

    // Sets hits (and in their steps how many triangles covered the pixel) for the pixels of the area that see a
    // polygon. Rays and hits are of the picture's rows from firstRow on. Returns the triangles looked at.
    std::int64_t draw(const PixelArea& area, const RayStage& rays, HitBlock& hits, int firstRow = 0) const;

  private:
    // Blocks of quads over one polygon: block (i, j) has the quads from firstColumn + i * kBlock.
    struct Box {
        float x0, y0, x1, y1;
    };
    struct Part {
        const VisiblePolygon* polygon = nullptr;
        int firstColumn = 0;  // the quad that begins at the polygon's edge, or before it
        int firstRow = 0;
        int columns = 0;  // of quads
        int rows = 0;
        int blocksAcross = 0;
        int blocksDown = 0;
        glm::dvec3 slab{0};  // from the top plane to the bottom, world units
        std::vector<Box> boxes{};
    };
    struct Target;

    ClipVertex vertex(const Part& part, int i, int j) const;
    Box boxOf(const Part& part, int blockX, int blockY) const;
    void drawBlock(const Part& part, int blockX, int blockY, Target& target) const;

    const DisplacementMesh& mesh_;
    const PinholeCamera& camera_;
    int width_;
    std::vector<Part> parts_;
};

}  // namespace relief
