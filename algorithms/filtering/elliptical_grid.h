// elliptical-visible:form=grid: what a pixel sees, by points that neighbouring pixels share.
//
// The points are a lattice over the whole picture, `points` of them a pixel, the pixels' centres among them. A pixel
// whose hit and those of its eight neighbours lie on a plane is plain filtering with the Jacobian of that plane, which
// is the neighbours' difference: no ray is traced for it but the picture's own. Elsewhere the lattice's points within
// the pixel's weights are looked at: traced, but where all four centres round a point lie on smooth ground its hit is
// taken between theirs. Where the four centres' colours are even, as good as the same, a point's colour is taken
// between theirs, without a ray and without reading. Each hit is read with a small footprint on the tangent plane there
// (point_reader.h), and the pixel is the mean of these colours, weighed by its Gaussian at the points. Rays and colours
// are made once for all pixels of a tile that need them. Points that meet nothing are left out.
//
// A point hangs on the picture's view and its place alone, not on who asks: equal bits in any company and for any
// number of threads. Pixels of no view, with hits that are not exact, or next to the horizon go to elliptical_rays.h.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "filtering/elliptical_rays.h"
#include "filtering/point_lattice.h"
#include "filtering/point_reader.h"
#include "relief/methods/slope_scene.h"
#include "relief/simd/packed_cone_hits.h"

namespace relief {

inline constexpr std::string_view kGridForm = "grid";

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
    struct Tile;
    void gather(const FilterBlock& block, std::size_t first, std::size_t last, Tile& tile,
                std::vector<std::size_t>& alone) const;
    void filterTile(const FilterBlock& block, Tile& tile, std::span<Color> colors, FootprintCounts& counts, Work& work,
                    FootprintLog* log) const;
    void lay(const FilterBlock& block, Tile& tile) const;
    static void layPicture(Tile& tile);
    void trace(Tile& tile, Work& work) const;
    static void spread(const FilterBlock& block, std::span<const std::size_t> pixels, int reach, Tile& tile);
    bool wantCentres(const FilterBlock& block, std::span<const std::size_t> pixels, int reach, Tile& tile,
                     FootprintCounts& counts, Work& work) const;
    void findAround(Tile& tile) const;
    void parted(const FilterBlock& block, Tile& tile) const;
    void filterPlain(Tile& tile, std::span<Color> colors, FootprintCounts& counts, FootprintLog* log) const;
    void findWhole(Tile& tile) const;
    void askPoints(const FilterBlock& block, Tile& tile) const;
    void askCentres(Tile& tile) const;
    static void orderCells(Tile& tile);
    template <class Wanted>
    void pushPoints(Tile& tile, std::size_t k, const Wanted& wanted) const;
    void follow(Tile& tile, std::size_t k, PointBlock& out) const;
    void layPoints(Tile& tile) const;
    void takeCentres(Tile& tile, FootprintCounts& counts) const;
    void takeMeans(Tile& tile) const;
    void takePoints(Tile& tile, FootprintCounts& counts, Work& work) const;
    void tracePoints(Tile& tile, FootprintCounts& counts, Work& work) const;
    void readPoints(Tile& tile, FootprintCounts& counts) const;
    void sumEdges(const FilterBlock& block, Tile& tile, std::span<Color> colors, FootprintCounts& counts) const;
    std::vector<std::pair<std::size_t, float>> summedSlots(const FilterQuery& query, const Tile& tile) const;
    void logPoints(const FilterQuery& query, const Tile& tile, FootprintLog& log) const;

    EllipticalKernel plain_;
    PointReader reader_;
    RaysKernel alone_;
    std::shared_ptr<const Tracer> tracer_;
    std::shared_ptr<const PackedConeHits> coneHits_;
    PointLattice lattice_;
    float bounds_;                      // of what is smooth and even: boundsFor()
    std::optional<SlopeScene> slopes_;  // of bilinear relief
};

}  // namespace relief
