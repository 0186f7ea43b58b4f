// Displacement mapping in a frame: the mesh is projected, clipped at the near plane and rasterised with
// perspective-correct rows and a depth buffer. It fills the same data as tracing the rays: outcome, lambda, s, t of
// every pixel.
//
// As with the tracers, a polygon shows only what is seen through it. Not drawn are pixels that another polygon or the
// sky covers, pixels whose view ray enters outside the picture (border addressing), and surface outside the polygon's
// texels. Back faces are not drawn, since a view ray comes from above. The result has equal bits for any division into
// areas: every pixel sees the same triangles in the same order, by the fill rule of mapping/clipping.h, and the nearest
// wins. It agrees with DisplacementTracer to within the rounding of projected coordinates, except at silhouettes, where
// the side of an edge on which a pixel centre lies is decided on the screen here and in the slab there. Cost:
// O(vertices) per frame and O(vertices of the blocks that touch it) per area; memory: 16 bytes per block of 16 x 16
// quads.
#pragma once

#include <cstdint>
#include <vector>

#include "relief/methods/displacement_mesh.h"
#include "relief/ray.h"
#include "rendering/visible_polygons.h"

namespace relief {

struct RayStage;

// A rectangle of pixels, [x0, x1) x [y0, y1).
struct PixelArea {
    int x0, y0, x1, y1;
};

class MeshRaster {
  public:
    // Computes the screen rectangles of all blocks, in parallel. Keeps references to the arguments, which must outlive
    // it.
    MeshRaster(const DisplacementMesh& mesh, const VisiblePolygons& visible, const PinholeCamera& camera, int width,
               Work& work);

    // Sets hits (and, as their steps, the number of triangles that cover the pixel) for the pixels of the area that see
    // a polygon. Rays and hits contain the picture's rows from firstRow on. Returns the number of triangles processed.
    std::int64_t draw(const PixelArea& area, const RayStage& rays, HitBlock& hits, int firstRow = 0) const;

  private:
    // The blocks of quads over one polygon: block (i, j) starts at quad (firstColumn + i * kBlock, firstRow + j *
    // kBlock). Box: a block's rectangle on the screen, pixels.
    struct Box {
        float x0, y0, x1, y1;
    };
    struct Part {
        const VisiblePolygon* polygon = nullptr;
        int firstColumn = 0;  // the quad that begins at the polygon's edge, or before it
        int firstRow = 0;
        int columns = 0;  // in quads
        int rows = 0;
        int blocksAcross = 0;
        int blocksDown = 0;
        glm::dvec3 slab{0};  // from the top plane to the bottom plane, world units
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
