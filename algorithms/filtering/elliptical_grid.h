// elliptical-visible:form=grid: what a pixel sees, by points that neighbouring pixels share.
//
// The points are a lattice over the whole picture, `points` of them a pixel, the pixels' centres among them. A pixel
// whose hit and those of its eight neighbours lie on a plane is plain filtering with the Jacobian of that plane, which
// is the neighbours' difference: no ray is traced for it but the picture's own. Elsewhere the lattice's points within
// the pixel's weights are traced, each hit is read with a small footprint on the tangent plane there (point_reader.h),
// and the pixel is the mean of these colours, weighed by its Gaussian at the points. Rays and colours are made once for
// all pixels of a tile that need them. Points that meet nothing are left out.
//
// A point hangs on the picture's view and its place alone, not on who asks: equal bits in any company and for any
// number of threads. Pixels of no view, with hits that are not exact, or next to the horizon go to elliptical_rays.h.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "filtering/elliptical_rays.h"
#include "filtering/point_lattice.h"
#include "filtering/point_reader.h"
#include "relief/lanes/cone_twin.h"

namespace relief {

inline constexpr std::string_view kGridForm = "grid";

class GridKernel {
  public:
    // plain: of whole pixels; alone: of pixels without a view. twin: null, then the tracer traces.
    GridKernel(EllipticalKernel plain, PointReader reader, RaysKernel alone, std::shared_ptr<const Tracer> tracer,
               std::shared_ptr<const ConeTwin> twin, int points);

    std::size_t bytes() const { return plain_.bytes() + tracer_->bytes(); }
    // scale: texels of the picture per texel of the height map. counts.tested: rays, those of neighbours beyond the
    // block included. log: null but for a block of one. Throws Cancelled.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                Work& work, FootprintLog* log = nullptr) const;

  private:
    struct Tile;
    bool serves(const FilterQuery& query) const;
    void filterTile(const FilterBlock& block, Tile& tile, std::span<Color> colors, FootprintCounts& counts, Work& work,
                    FootprintLog* log) const;
    void lay(const FilterBlock& block, Tile& tile) const;
    void traceCentres(Tile& tile, Work& work) const;
    void wantPoints(const FilterBlock& block, Tile& tile) const;
    void tracePoints(Tile& tile, Work& work) const;
    void colorPoints(Tile& tile, FootprintCounts& counts) const;
    void trace(Tile& tile, Work& work) const;
    bool planeThrough(const FilterQuery& query, const Tile& tile, Jacobian& found) const;
    Color summed(const FilterQuery& query, const Tile& tile, FootprintCounts& counts) const;
    void logPoints(const FilterQuery& query, const Tile& tile, FootprintLog& log) const;

    EllipticalKernel plain_;
    PointReader reader_;
    RaysKernel alone_;
    std::shared_ptr<const Tracer> tracer_;
    std::shared_ptr<const ConeTwin> twin_;
    PointLattice lattice_;
};

}  // namespace relief
