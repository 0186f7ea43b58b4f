// The SIMD arithmetic of the grid's stages (grid_stages.h): which pixels lie on a plane, the rays through points, their
// footprints and colours. The bits are the same on every instruction set, for any number of values at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "filtering/filter_block.h"
#include "filtering/pixel_view.h"
#include "filtering/point_lattice.h"
#include "filtering/point_reader.h"
#include "relief/methods/slope_scene.h"
#include "relief/ray.h"

namespace relief {

// How the hit of a pixel's centre lies among those of its eight neighbours, as bits: which of the four lines through it
// are smooth (hits in between can be interpolated) and which are straight (the line continues to the next hit), and
// whether all hits lie on a plane, at one height, and near each other. Order of the lines: across, down, to the right
// and down, to the right and up.
enum Surroundings : std::uint16_t { kSmooth = 1, kStraight = 16, kOnPlane = 256, kOnLevel = 512, kNearAround = 1024 };
enum Line : std::uint8_t { kAcross, kDown, kFalling, kRising };
inline constexpr unsigned kAllLines = 15;

// How much three hits in a line may be bent. `relative` bounds the second difference over the first; `absolute` bounds
// half the second difference in texels of the picture, where a bend is not visible.
//
// Measurements behind these constants and those below: on bricks, city and hills at 60, 25 and 8 degrees (160 x 120),
// and on the shipped pictures at 45 degrees (200 x 150; lines marked *: 320 x 240), with points=3, changing one
// constant at a time. Error (against the Gaussian pixel) and rays are relative changes of the mean over all scenes,
// except where a scene is named. Lines marked 1 were measured with earlier values of the other constants. See also
// tests/benchmarks/EXPERIMENTS.md.
//
//     constant                value   tried         error                                      rays
//     kPlaneBend.relative     0.1     0.15     1    bricks at 8 degrees +9%
//     kPlaneBend.absolute     0.05    0.025    *    0.0%                                       0
//                                     0.2      *    terrain +4.8%                              0
//     kSmoothBend.relative    0.32    0.4      1    city at 25 degrees +9%
//     kSmoothBend.absolute    0.3     0.15     *    -0.1%                                      +0.6%
//                                     0.6           terrain +1.7%                              -17%
//     kStraightBend.relative  0.07    0.1      1    city at 8 degrees +5%                      -10%
//     kStraightBend.absolute  0.1     0.05          0.0%                                       +0.3%
//                                     0.2           0.0%                                       -0.8%
//     kNear                   5       3             -0.2%                                      +0.9%
//                                     8             hills at 8 degrees +3.8%                   -0.8%
//     kLeastNear              1       none     1    terrain +3 to 10%
//                                     0.5, 2        0.0%
//     kNearPlaneBend          0.15    0.1           -0.1%                                      0
//                                     0.2           bricks at 8 degrees +2.3%, terrain +1.8%   0
//     kNearSmoothBend         0.4     0.32          -0.2%                                      +1.6%
//                                     0.5           bricks at 8 degrees +3.6%                  -1.4%
//     kUniformColors          1/64    1/128         tiles -0.2%                                +2.4%
//                                     1/32          rocks +3.5%                                -5%
//     kUniformShare           1/4     1/8, 1/2, 1   0.0%                                       0
struct Bend {
    double relative, absolute;
};
inline constexpr Bend kPlaneBend{0.1, 0.05};
inline constexpr Bend kSmoothBend{0.32, 0.3};
inline constexpr Bend kStraightBend{0.07, 0.1};
// Hits closer to each other than this, in texels, may be bent more, because little can be hidden between them.
inline constexpr double kNear = 5;
// Pixels whose hits are closer to each other than this, in texels, are not filtered as planes: plain filtering blurs a
// magnified picture more than points do.
inline constexpr double kLeastNear = 1;
// Replace Bend::relative where hits are near each other.
inline constexpr double kNearPlaneBend = 0.15, kNearSmoothBend = 0.4;
// With more points per pixel than this, all bounds and kUniformColors decrease in proportion, so that the detail that
// the points resolve is not lost. Together with other changes this lowered the error of points=5 on the stone wall at
// 25 degrees by 8%.
inline constexpr int kUsualPoints = 3;
inline float boundsFor(int points) {
    return static_cast<float>(kUsualPoints) / static_cast<float>(std::max(points, kUsualPoints));
}
// Heights of level ground, which keeps the pixel's own bits, differ by at most the rounding to float: its unit at 1.
inline constexpr float kLevelHeight = 0x1p-23F;

// Entries behind the columns' ends that vectors may read and write: 16 floats, and 2 more.
inline constexpr std::size_t kCellSlack = 18;
// Hits of a rectangle of pixels, at least 3 x 3, row by row, with kCellSlack more entries, in texels of the picture;
// NaN where there is no hit. Float has an error of 1e-4 texel at 1000 texels, far below kPlaneBend.absolute.
struct CellHits {
    int width = 0, height = 0;
    const float *s = nullptr, *t = nullptr, *lambda = nullptr;
};

// Writes the Surroundings of all cells to out (kCellSlack longer); 0 for the outermost cells. bounds: factor of every
// Bend.
void findSurroundings(const CellHits& cells, float bounds, std::uint16_t* out);

// Writes the view's rays through the places (x, y) of the picture to rays[first ...]. The polygon is continued beyond
// its edges. At pixels' centres the rays are the picture's own, which are outside the polygon by rounding at most.
void raysThrough(const PixelView& view, std::span<const double> x, std::span<const double> y, RayBlock& rays,
                 std::size_t first);

// Hits of points; all columns of one length.
struct PointHits {
    std::span<const double> x, y;  // in the picture, pixels
    std::span<const double> lambda, s, t;
};

// Appends to `points` the footprints with that blur on the surface's tangent plane at each hit, in texels of the
// picture. slopes: null if the ground is level at hits (columns).
void layFootprints(const PixelView& view, const SlopeScene* slopes, const PointBlur& blur, glm::dvec2 scale,
                   const PointHits& hits, PointBlock& points);

// Four centres' colours are uniform, so that points between them take their mean, if no channel differs by more than
// kUniformColors of white, nor by more than kUniformShare of its brightest value (differences are more visible in dark
// areas). Measurements: see Bend.
inline constexpr float kUniformColors = 1.0F / 64, kUniformShare = 0.25F;
// Sets all bits of each cell c of [0, count) if the colours of c, c + 1, c + row and c + row + 1 are uniform by
// `bounds` times kUniformColors, and no bits otherwise. Unknown colours are infinite. All columns are kCellSlack
// longer.
void findUniform(const std::array<const float*, 3>& channel, std::size_t row, std::size_t count, float bounds,
                 std::uint16_t* uniform);
// A job for meanUniform: the k-th points of cells.
struct MeanJob {
    std::size_t square = 0, row = 0;  // PointLattice::squareOf, cells per row
    std::size_t points = 0, point = 0;
    std::array<float, 4> share{};
};
// Sets the colours of the points of cells [first, last) that are needed and whose square is uniform to the weighted
// mean of the square's centres, and removes them from needed.
void meanUniform(const MeanJob& job, std::size_t first, std::size_t last, const std::uint16_t* uniform,
                 std::uint16_t* needed, PointColor* colors);
// Copies the centres' colours (the first of each cell's `points`) to columns of red, green and blue. They are infinite
// where the centre is not needed (bit 0) or has no hit. All columns are kCellSlack cells longer.
void splitCentres(const PointColor* colors, std::size_t points, const std::uint16_t* needed, std::size_t count,
                  const std::array<float*, 3>& out);
// sums[n] = sum over k, in their order, of weight[k] * colors[base[n] + offset[k]].
void sumPoints(const PointColor* colors, std::span<const std::int32_t> base, std::span<const std::int32_t> offset,
               std::span<const float> weight, std::span<PointColor> sums);

// A job for followPoints: the k-th points of cells, row by row, whose hits are interpolated from centres. Places and
// footprints follow from the differences of the surrounding centres, without a ray, a slope or a division. Columns are
// kCellSlack longer.
struct FollowJob {
    const double *s = nullptr, *t = nullptr;  // of centres, texels of the height map
    std::size_t row = 0, first = 0, last = 0;
    const std::uint16_t *needed = nullptr, *interpolated = nullptr;  // bits of the points
    std::size_t point = 0, points = 0;                               // k, and the number of points of the lattice
    std::size_t square = 0;                                          // PointLattice::squareOf
    std::array<double, 4> shares{};
    PointBlur blur;
    glm::dvec2 scale{1};
};

// Appends the points that are needed and interpolated, and their slots: cell * points + point. Centres use the
// differences of their neighbours; other points use means and differences of the four centres around them.
void followPoints(const FollowJob& job, PointBlock& out, std::vector<std::uint32_t>& slots);

// Of pixels [first, last) of a block: whether all have the same view and lie in one tile of 2^across x 2^down pixels;
// if so, their bounding rectangle, and whether all hits are exact and FilterBlock::sides() of all pixels is
// below `largest`.
struct TileScan {
    bool same = false;
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    bool usable = false;
};
TileScan scanTile(const FilterBlock& block, std::size_t first, std::size_t last, int across, int down, double largest);

// Hits of cells: in texels of the height map, and in float in texels of the picture. Columns are kCellSlack longer.
struct CellColumns {
    double *s = nullptr, *t = nullptr, *lambda = nullptr;
    float *pictureS = nullptr, *pictureT = nullptr, *floatLambda = nullptr;
    std::uint8_t* known = nullptr;  // 1 where the ray belongs to the polygon
};
// Sets the first `count` cells to the picture's rays from `from` on: NaN for other polygons' and for those without a
// hit. Also overwrites the columns of up to kPointSlack cells behind, except `known`. Returns true if all are known.
bool copyHits(const PictureHits& picture, std::size_t from, std::size_t count, std::uint8_t polygon, glm::dvec2 scale,
              const CellColumns& out);

// A job for splitRun: pixels of a block whose cells are consecutive. The cells' columns are kCellSlack longer.
struct SplitJob {
    const FilterBlock* block = nullptr;
    const double *s = nullptr, *t = nullptr;  // of centres, texels of the height map
    std::size_t row = 0;
    const std::uint16_t* around = nullptr;  // Surroundings
    glm::dvec2 scale{1};
};
// Pixels on planes, as places and Jacobians in texels of the picture, and the others. The columns are as long as the
// number of all pixels plus kPointSlack.
struct SplitColumns {
    std::size_t planeCount = 0, edgeCount = 0;
    FilterBlock planes;
    std::vector<std::size_t> planeOf, edges;  // indices in the block

    void refill(std::size_t pixels) {
        planeCount = edgeCount = 0;
        if (planeOf.size() >= pixels + kPointSlack) return;
        planes.resize(pixels + kPointSlack);
        planeOf.resize(pixels + kPointSlack), edges.resize(pixels + kPointSlack);
    }
};
// Appends the pixels [first, first + count) of the block, whose cells start at `cell`. The Jacobian of pixels on a
// plane is that of the hits around, or the pixel's own on level ground.
void splitRun(const SplitJob& job, std::size_t first, std::size_t count, std::size_t cell, SplitColumns& out);

// A job for listPlaces: the k-th points of a row of cells, from column 0 of that row on.
struct PlacesJob {
    const std::uint16_t *needed = nullptr, *interpolated = nullptr;  // of the row; kCellSlack longer
    std::size_t point = 0, points = 0;                               // k, and the number of points of the lattice
    std::size_t row = 0, cell = 0;                                   // cells per row, and the first cell
    double x = 0, off = 0, y = 0;  // the first cell's centre; from there to the point along x; place of the point
};
// Writes the points of the row that are needed and not interpolated, and returns their number. The columns have room
// for a whole row and kPointSlack more.
std::size_t listPlaces(const PlacesJob& job, double* x, double* y, std::uint32_t* slots);

}  // namespace relief
