// The SIMD arithmetic of the grid's stages (grid_stages.h): which pixels lie on a plane, the rays of points, their
// footprints and colours. The same bits on every instruction set, for any number of values at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "filtering/pixel_view.h"
#include "filtering/point_lattice.h"
#include "filtering/point_reader.h"
#include "relief/methods/slope_scene.h"
#include "relief/ray.h"

namespace relief {

// How the hit of a pixel's centre lies among those of its eight neighbours, bits: which of the four lines through it
// are smooth (hits between can be interpolated), which are straight (and go on to the next hit), whether all lie on a
// plane, at one height, and near. Lines: across, down, to the right and down, to the right and up.
enum Surroundings : std::uint16_t { kSmooth = 1, kStraight = 16, kOnPlane = 256, kOnLevel = 512, kNearAround = 1024 };
enum Line : std::uint8_t { kAcross, kDown, kFalling, kRising };
inline constexpr unsigned kAllLines = 15;

// How far three hits in a line may be bent: the second difference over the first, or half the second difference in
// texels of the picture, which is not seen. Measured, like the constants below, on bricks, city and hills at 60, 25, 8
// degrees (160 x 120) and the shipped pictures at 45 (200 x 150), points=3, one changed at a time; e, r: change of the
// error against the Gaussian pixel and of the rays, in the mean of all unless a scene is named. "notes":
// tests/benchmarks/EXPERIMENTS.md, with the values before these.
struct Bend {
    double share, unseen;
};
// share 0.15 (notes): bricks at 8 degrees e +9%. unseen (pictures 320 x 240) 0.025: e 0.0%, 0.2: terrain e +4.8%; r 0.
inline constexpr Bend kPlaneBend{0.1, 0.05};
// share 0.4 (notes): city at 25 degrees e +9%. unseen 0.15 (320 x 240): e -0.1%, r +0.6%; 0.6: terrain e +1.7%, r -17%.
inline constexpr Bend kSmoothBend{0.32, 0.3};
// share 0.1 (notes): city at 8 degrees e +5%, r -10%. unseen 0.05: e 0.0%, r +0.3%; 0.2: e 0.0%, r -0.8%.
inline constexpr Bend kStraightBend{0.07, 0.1};
// Where hits are no farther apart than this, texels, little hides between them, and more may be bent. 3: e -0.2%,
// r +0.9%; 8: hills at 8 degrees e +3.8%, r -0.8% of all.
inline constexpr double kNear = 5;
// Planes only from here on: plain filtering blurs what is magnified more than points do, terrain e +3 to 10% (notes).
// 0.5 and 2: e 0.0%.
inline constexpr double kLeastNear = 1;
// Shares where hits are near. Planes 0.1: e -0.1%, 0.2: bricks at 8 degrees e +2.3%, terrain +1.8%; r 0. Smooth 0.32:
// e -0.2%, r +1.6%; 0.5: bricks at 8 degrees e +3.6%, r -1.4% of all.
inline constexpr double kNearPlaneBend = 0.15, kNearSmoothBend = 0.4;
// More points than these lower all bounds, and kEvenColors, in proportion, lest what they show be lost. points=5, among
// other changes (notes): stone wall at 25 degrees e -8%.
inline constexpr int kUsualPoints = 3;
inline float boundsFor(int points) {
    return static_cast<float>(kUsualPoints) / static_cast<float>(std::max(points, kUsualPoints));
}
// Heights of level ground, which keeps the pixel's own bits, differ by rounding to float: its unit at 1.
inline constexpr float kLevelHeight = 0x1p-23F;

// Entries behind the columns' ends that vectors may read and write: 16 floats, and 2 more.
inline constexpr std::size_t kCellSlack = 18;
// A rectangle of pixels, at least 3 x 3, rows one after the other, and kCellSlack more: hits in texels of the picture,
// NaN where there is none. In float: off by 1e-4 texel at 1000, far below kPlaneBend.unseen.
struct CellHits {
    int width = 0, height = 0;
    const float *s = nullptr, *t = nullptr, *lambda = nullptr;
};

// Surroundings of all cells, 0 for the outermost, into out, kCellSlack longer; bounds: factor of every Bend.
void findSurroundings(const CellHits& cells, float bounds, std::uint16_t* out);

// The view's rays through the places (x, y) of the picture into rays[first ...], the polygon continued beyond its
// edges; for pixels' centres the picture's own rays, which never lie outside by more than rounding.
void raysThrough(const PixelView& view, std::span<const double> x, std::span<const double> y, RayBlock& rays,
                 std::size_t first);

// Hits of points; all columns of one length.
struct PointHits {
    std::span<const double> x, y;  // places in the picture
    std::span<const double> lambda, s, t;
};

// Appends to `points` the footprints of that blur on the surface's tangent plane at each hit, texels of the picture.
// slopes: null on level ground (columns).
void layFootprints(const PixelView& view, const SlopeScene* slopes, const PointBlur& blur, glm::dvec2 scale,
                   const PointHits& hits, PointBlock& points);

// Four centres' colours are even, so that points between take their mean, if no channel differs by more than this part
// of white, nor by more than this share of the brightest, for in the dark less is seen. Part 1/128: tiles e -0.2%,
// r +2.4%, 1/32: rocks e +3.5%, r -5%. Share 1/8, 1/2, 1: e 0.0%, r 0; these pictures have few dark places.
inline constexpr float kEvenColors = 1.0F / 64, kEvenShare = 0.25F;
// Sets for the cells [0, count) all bits where the colours of c, c + 1, c + row, c + row + 1 are even by `bounds` of
// kEvenColors, else none. Colours are infinite where not known; all columns are kCellSlack longer.
void findEven(const std::array<const float*, 3>& channel, std::size_t row, std::size_t count, float bounds,
              std::uint16_t* even);
// Copies centres' colours, the first of each cell's `points`, to columns of red, green and blue: infinity for cells
// whose centre is not needed (bit 0) or met nothing. All columns are kCellSlack cells longer.
void splitCentres(const PointColor* colors, std::size_t points, const std::uint16_t* needed, std::size_t count,
                  const std::array<float*, 3>& out);
// sums[n] = sum over k, in their order, of weight[k] * colors[base[n] + offset[k]].
void sumPoints(const PointColor* colors, std::span<const std::int32_t> base, std::span<const std::int32_t> offset,
               std::span<const float> weight, std::span<PointColor> sums);

// The k-th points of cells, rows one after the other, whose hits are interpolated from centres: places and footprints
// by the differences of the centres round them, without a ray, a slope or a division. Columns are kCellSlack longer.
struct FollowJob {
    const double *s = nullptr, *t = nullptr;  // of centres
    std::size_t row = 0, first = 0, last = 0;
    const std::uint16_t *needed = nullptr, *interpolated = nullptr;  // points' bits
    std::size_t point = 0, points = 0;                               // k, and the lattice's number
    std::size_t square = 0;                                          // PointLattice::squareOf
    std::array<double, 4> shares{};
    PointBlur blur;
    glm::dvec2 scale{1};
};

// Appends the points that are needed and interpolated, with their slots: cell * points + point. Centres take the
// differences of their neighbours, other points means and differences of the four centres round them.
void followPoints(const FollowJob& job, PointBlock& out, std::vector<std::uint32_t>& slots);

}  // namespace relief
