// elliptical-visible:form=grid: what a pixel sees, by sample points that neighbouring pixels share.
//
// The points are a lattice over the whole picture, `points` of them a pixel, the pixels' centres among them. A pixel
// whose hit and those of its eight neighbours lie on a plane is filtered plainly with that plane's Jacobian, from the
// neighbours' differences: no ray is traced for it but the picture's own. For the other pixels, edges, the lattice's
// points within the pixel's weights are traced; but where all four centres round a point lie on smooth ground, its hit
// is interpolated from theirs, and where their colours are nearly equal, its colour is their mean, without a ray or a
// fetch. Each hit is read with a small footprint on the tangent plane there (point_reader.h), and the pixel is the mean
// of these colours, weighted by its Gaussian at the points. Points that meet nothing are left out. Rays and colours
// are made once for all pixels of a tile that need them, in the stages of grid_stages.h.
//
// A point depends on the picture's view and its place alone, not on the pixels that need it: equal bits in any company
// and for any number of threads. Pixels of no view, with hits that are not exact, next to the horizon or
// with footprints larger than four height maps go to elliptical_rays.h.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "filtering/elliptical_rays.h"
#include "filtering/point_lattice.h"
#include "filtering/point_reader.h"
#include "relief/methods/slope_scene.h"
#include "relief/simd/packed_cone_hits.h"

namespace relief {

inline constexpr std::string_view kGridForm = "grid";

// What the stages of all tiles read (grid_stages.h).
struct GridSetup {
    EllipticalKernel plain;  // of pixels on planes
    PointReader reader;
    std::shared_ptr<const Tracer> tracer;
    std::shared_ptr<const PackedConeHits> coneHits;  // null: the tracer traces
    PointLattice lattice;
    float bounds;                      // boundsFor()
    std::optional<SlopeScene> slopes;  // of bilinear surfaces
};

namespace grid {
struct Run;
struct TilePixels;
}  // namespace grid

class GridKernel {
  public:
    // plain: of whole pixels; alone: of pixels without a view. coneHits: null, then the tracer traces.
    GridKernel(EllipticalKernel plain, PointReader reader, RaysKernel alone, std::shared_ptr<const Tracer> tracer,
               std::shared_ptr<const PackedConeHits> coneHits, int points);

    // scale: texels of the picture per texel of the height map. counts.tested: rays, those of neighbours that neither
    // the block nor its picture has included. log: null but for a block of one. Throws Cancelled.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                Work& work, FootprintLog* log = nullptr) const;

  private:
    struct Scratch;
    static void filterTile(grid::Run& run, const grid::TilePixels& pixels, Scratch& scratch, std::span<Color> colors);

    GridSetup setup_;
    RaysKernel alone_;
};

}  // namespace relief
