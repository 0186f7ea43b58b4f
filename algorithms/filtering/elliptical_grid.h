// elliptical-visible:form=grid: what a pixel sees, by sample points that neighbouring pixels share.
//
// The points form a lattice over the whole picture, with `points` points per pixel, among them the pixels' centres. If
// a pixel's hit and those of its eight neighbours lie on a plane, the pixel is filtered plainly with that plane's
// Jacobian, from the differences of the hits; no ray is traced except the picture's own. For the other pixels, called
// edges, the lattice's points within the pixel's weights are traced, with two exceptions: if the four centres around a
// point lie on smooth ground, its hit is interpolated from theirs, and if their colours are nearly equal, its colour is
// their mean, without a ray or a texel. Each hit is sampled with a small footprint on the tangent plane there
// (point_reader.h), and the pixel is the mean of these colours, weighted by its Gaussian at the points. Points without
// a hit are left out. Rays and colours are computed once for all edge pixels of a tile, in the stages of grid_stages.h.
//
// A point depends only on the picture's view and on its place, not on the pixels that need it. So the bits depend
// neither on the other pixels of the block nor on the number of threads. Pixels without a view, with hits that are not
// exact, next to the horizon, or with footprints larger than four height maps fall back to elliptical_rays.h.
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

// Input of the stages that is the same for all tiles (grid_stages.h).
struct GridSetup {
    EllipticalKernel plain;  // for pixels on planes
    PointReader reader;
    std::shared_ptr<const Tracer> tracer;
    std::shared_ptr<const PackedConeHits> coneHits;  // null: the tracer is used
    PointLattice lattice;
    float bounds;                      // boundsFor()
    std::optional<SlopeScene> slopes;  // of bilinear surfaces only
};

namespace grid {
struct Run;
struct TilePixels;
}  // namespace grid

class GridKernel {
  public:
    // plain: filters whole pixels. fallback: filters pixels that the grid does not support. coneHits: traces instead of
    // the tracer, unless null.
    GridKernel(EllipticalKernel plain, PointReader reader, RaysKernel fallback, std::shared_ptr<const Tracer> tracer,
               std::shared_ptr<const PackedConeHits> coneHits, int points);

    // Filters a block. scale: texels of the picture per texel of the height map. counts.tested: number of rays,
    // including those through neighbouring pixels whose hits neither the block nor its picture contains. log: null
    // unless the block has one pixel. Throws Cancelled.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                Work& work, FootprintLog* log = nullptr) const;

  private:
    struct Scratch;
    static void filterTile(grid::Run& run, const grid::TilePixels& pixels, Scratch& scratch, std::span<Color> colors);

    GridSetup setup_;
    RaysKernel fallback_;
};

}  // namespace relief
