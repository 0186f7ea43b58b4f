// The stages in which the grid filter (elliptical_grid.h) filters one tile, in order, with their results. A stage takes
// the results of earlier stages as arguments and returns its own, so that none can be called too early; stages 3 and 6
// add to Centres, and stages 9 and 10 add the other points' colours to those of stage 8. Private to
// elliptical_grid*.cpp and simd/grid_plan.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "filtering/elliptical_grid.h"
#include "filtering/grid_lanes.h"

namespace relief::grid {

// Distance, in cells, from an edge pixel to the farthest centre that it needs: its points lie within kLatticeHalo, the
// centres around these one cell farther, and the neighbours by which those are judged another cell farther.
inline constexpr int kTileHalo = kLatticeHalo + 2;

// A stage's result, whose memory is reused from tile to tile. Only the stage calls refill(); other stages get what it
// returns.
template <class T>
class Reused {
  public:
    T& refill() { return value_; }

  private:
    T value_;
};

// Makes the column at least this long; keeps its contents.
template <class T>
void reserve(std::vector<T>& column, std::size_t count) {
    if (column.size() < count) column.resize(count);
}

// Bits of each cell: one per point, or Surroundings.
using BitColumn = std::vector<std::uint16_t>;

// The cells of a tile, row by row: the bounding rectangle of its pixels, extended by kTileHalo on each side. The colour
// of a cell's point has the slot cell * points + point; point 0 is the centre.
struct TileCells {
    const PixelView* view = nullptr;
    glm::dvec2 scale{1};  // texels of the picture per texel of the height map
    int x0 = 0, y0 = 0, width = 0, height = 0;

    std::size_t count() const { return row() * static_cast<std::size_t>(height); }
    std::size_t row() const { return static_cast<std::size_t>(width); }
    // The first cell with all eight neighbours; the last one is count() - 1 - inner().
    std::size_t inner() const { return row() + 1; }
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y - y0) * row() + static_cast<std::size_t>(x - x0);
    }
};

// Pixels [first, first + count) of the block, whose cells are consecutive.
struct PixelRun {
    std::size_t first = 0, count = 0;
};
struct TilePixels {
    TileCells cells;
    std::vector<std::size_t> indices;  // in the block
    std::vector<PixelRun> runs;        // the same pixels, in runs
};

// Hits of the view's rays through cells' centres. s is NaN where there is no hit, or none is known yet.
// findSurroundings reads the hits in float: pictureS and pictureT in texels of the picture, floatLambda.
struct Centres {
    TileCells cells;
    std::vector<double> s, t, lambda;
    std::vector<float> pictureS, pictureT, floatLambda;
    std::vector<std::uint8_t> known;
    bool allKnown = false;

    // Marks the cells [begin, end) as unknown.
    void clear(std::size_t begin, std::size_t end) {
        std::fill(s.begin() + static_cast<std::ptrdiff_t>(begin), s.begin() + static_cast<std::ptrdiff_t>(end),
                  std::numeric_limits<double>::quiet_NaN());
        std::fill(pictureS.begin() + static_cast<std::ptrdiff_t>(begin),
                  pictureS.begin() + static_cast<std::ptrdiff_t>(end), std::numeric_limits<float>::quiet_NaN());
        std::fill(known.begin() + static_cast<std::ptrdiff_t>(begin), known.begin() + static_cast<std::ptrdiff_t>(end),
                  std::uint8_t{0});
    }
    CellColumns columns(std::size_t cell) {
        return {s.data() + cell,        t.data() + cell,           lambda.data() + cell, pictureS.data() + cell,
                pictureT.data() + cell, floatLambda.data() + cell, known.data() + cell};
    }
    void set(std::size_t cell, double atS, double atT, double atLambda) {
        s[cell] = atS, t[cell] = atT, lambda[cell] = atLambda;
        pictureS[cell] = static_cast<float>(atS * cells.scale.x);
        pictureT[cell] = static_cast<float>(atT * cells.scale.y);
        floatLambda[cell] = static_cast<float>(atLambda);
    }
};

// Centres that are known at least one cell around all pixels of the tile, and their Surroundings. surveyEdges adds to
// both.
struct NearGround {
    Centres& centres;
    BitColumn& around;
};
// Centres that are known at least kTileHalo cells around the tile's edge pixels, and their Surroundings.
struct EdgeGround {
    const Centres& centres;
    const BitColumn& around;
};

// The pixels on planes, as queries with the planes' Jacobians, and the other pixels: edges.
struct PlaneSplit {
    SplitColumns columns;

    std::span<const std::size_t> planeOf() const { return {columns.planeOf.data(), columns.planeCount}; }
    std::span<const std::size_t> edges() const { return {columns.edges.data(), columns.edgeCount}; }
};

// Points that edge pixels sum, with the centres around them, and the points whose hits are interpolated from centres.
struct PointPlan {
    BitColumn needed, interpolated;
};

// A footprint that was sampled, for the log.
struct ReadPoint {
    std::uint32_t slot;
    glm::dvec2 place;
    Jacobian jacobian;
};

// Colours by slot: of centres, and after stage 10 of all needed points. The centres' colours also as columns over the
// cells, infinite where unknown.
struct CentreColors {
    std::vector<PointColor> slots;
    std::array<std::vector<float>, 3> channel;
    std::vector<ReadPoint> read;  // only if there is a log
};

// The needed points whose colour is not a mean of centres' colours.
struct RestPoints {
    BitColumn needed;
};

// The colours of all needed points, by slot.
struct PointColors {
    const std::vector<PointColor>& slots;
    const std::vector<ReadPoint>& read;
};

// Input of the stages in addition to earlier results. counts.tested: number of rays that they trace.
struct Run {
    const GridSetup& setup;
    const FilterBlock& block;
    FootprintCounts& counts;
    Work& work;
    FootprintLog* log;  // null unless the block has one pixel
};

// Scratch memory of the stages. It carries no data from one stage to another.
struct RayBatch {
    RayBlock rays;
    HitBlock hits;
};
// Places of points. The first `count` entries of the columns are in use.
struct Places {
    std::size_t count = 0;
    std::vector<std::uint32_t> slots;
    std::vector<double> x, y;  // in the picture, pixels

    void reserve(std::size_t more) {
        grid::reserve(slots, count + more), grid::reserve(x, count + more), grid::reserve(y, count + more);
    }
};
// Footprints of points, and the slots of their colours; also the slots of points without a hit.
struct Footprints {
    PointBlock block;
    std::vector<std::uint32_t> slots, missed;
};
struct SurveyWork {
    std::vector<std::uint8_t> own, along, near;
    Places missing;
    RayBatch batch;
};
struct PointWork {
    BitColumn mask;
    Places places;
    HitBlock centreHits;
    RayBatch batch;
    Footprints footprints;
};
struct SumWork {
    std::vector<Color> planes;
    std::vector<std::int32_t> base, offset;
    std::vector<PointColor> sums;
};

// Traces rays through the places [begin, begin + count), at most kRayGrain. Hits are at the places where colours are
// sampled.
void traceBatch(Run& run, const PixelView& view, const Places& places, std::size_t begin, std::size_t count,
                RayBatch& batch);

// 1. Collects the block's pixels from `first` on that have one view and lie in one tile, and sets `last` behind these.
// Indices of pixels that the grid does not support are appended to `fallback`.
const TilePixels& gatherPixels(const Run& run, std::size_t first, std::size_t& last, glm::dvec2 scale,
                               Reused<TilePixels>& out, std::vector<std::size_t>& fallback);
// 2. Copies the known hits of centres from the picture or, without one, from the block.
Centres& takeCentres(const Run& run, const TilePixels& pixels, Reused<Centres>& out);
// 3. Traces the unknown centres within one cell of any pixel.
NearGround surveyPixels(Run& run, const TilePixels& pixels, Centres& centres, SurveyWork& survey,
                        Reused<BitColumn>& out);
// 4. Divides the pixels by their surroundings.
const PlaneSplit& splitPixels(const Run& run, const TilePixels& pixels, const NearGround& ground,
                              Reused<PlaneSplit>& out);
// 5. Filters the pixels on planes.
void filterPlanes(Run& run, const PlaneSplit& split, SumWork& sum, std::span<Color> colors);
// 6. Traces the unknown centres within kTileHalo cells of any edge pixel.
EdgeGround surveyEdges(Run& run, const PlaneSplit& split, const NearGround& ground, SurveyWork& survey);
// Input of planCells, the arithmetic of stage 7.
struct PlanJob {
    const PointLattice& lattice;
    const FilterBlock& block;
    std::span<const std::size_t> edges;
    const TileCells& cells;
    const BitColumn& around;
};
// mask: scratch memory.
void planCells(const PlanJob& job, BitColumn& mask, PointPlan& out);

// 7. Determines which points the edge pixels need, and which of these need no ray.
const PointPlan& planPoints(const Run& run, const PlaneSplit& split, const EdgeGround& ground, PointWork& points,
                            Reused<PointPlan>& out);
// 8. Samples the colours of the needed centres.
CentreColors& readCentres(Run& run, const EdgeGround& ground, const PointPlan& plan, PointWork& points,
                          Reused<CentreColors>& out);
// 9. Sets the colour of points between centres of nearly equal colours to the mean of these; returns the other points.
const RestPoints& meanColors(const Run& run, const EdgeGround& ground, const PointPlan& plan, CentreColors& colors,
                             PointWork& points, Reused<RestPoints>& out);
// 10. Samples the colours of the other points, after tracing those that are not interpolated.
PointColors readPoints(Run& run, const EdgeGround& ground, const PointPlan& plan, const RestPoints& rest,
                       CentreColors& colors, PointWork& points);
// 11. Computes the edge pixels' colours: weighted means of their points'.
void sumEdges(Run& run, const EdgeGround& ground, const PlaneSplit& split, const PointColors& points, SumWork& sum,
              std::span<Color> colors);
// 12. Logs the texels of the block's only pixel, an edge, as shares of its points' weights.
void logEdge(Run& run, const EdgeGround& ground, const RestPoints& rest, const PointColors& points);

}  // namespace relief::grid
