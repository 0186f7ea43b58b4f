// The grid's arithmetic in lanes, inside elliptical_grid.cpp, not for others: which pixels lie on a plane,
// the rays of points, and their footprints. Same bits on every instruction set, for any number of values at once.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

#include "filtering/pixel_view.h"
#include "filtering/point_lattice.h"
#include "filtering/point_reader.h"
#include "relief/methods/slope_scene.h"
#include "relief/ray.h"

namespace relief {

// How the hit of a pixel's centre lies among those of its eight neighbours, bits: which of the four lines through it
// are smooth (bent so little that hits between can be taken from the hits around), which are straight (so little that
// it goes on to the next hit), whether all lie on a plane, at one height, and near. Lines: across, down, to the right
// and down, to the right and up.
enum Surroundings : std::uint16_t { kSmooth = 1, kStraight = 16, kOnPlane = 256, kOnLevel = 512, kNearAround = 1024 };
enum Line : std::uint8_t { kAcross, kDown, kFalling, kRising };
inline constexpr unsigned kAllLines = 15;

// Second differences of neighbouring hits over the first, at most: on planes, smooth lines, straight lines; and half
// the second difference in texels of the picture that is not seen.
struct Bend {
    double share, unseen;
};
inline constexpr Bend kPlaneBend{0.1, 0.05}, kSmoothBend{0.32, 0.3}, kStraightBend{0.07, 0.1};
// Where hits are no farther apart, texels, little hides between them, and more may be bent. Planes from kLeastNear on:
// plain filtering blurs what is magnified more than points do.
inline constexpr double kNear = 5, kLeastNear = 1;
inline constexpr double kNearPlaneBend = 0.15, kNearSmoothBend = 0.4;
// Of all bounds, and of kEvenColors: for lattices of more points than these they fall with the points' number, so that
// what more points show is not lost to them.
inline constexpr int kUsualPoints = 3;
inline float boundsFor(int points) {
    return static_cast<float>(kUsualPoints) / static_cast<float>(std::max(points, kUsualPoints));
}
// Hits at one height, but for rounding to float: level ground, which keeps the pixel's own bits.
inline constexpr float kLevelHeight = 0x1p-23F;

// A rectangle of pixels, rows one after the other: hits in texels of the picture, NaN where there is none. In float:
// off by 1e-4 texel at 1000, where bends of 0.05 are not seen. At least 3 x 3; kCellSlack more at the columns' ends, of
// anything, and as many in what is found.
inline constexpr std::size_t kCellSlack = 18;
struct CellHits {
    int width = 0, height = 0;
    const float *s = nullptr, *t = nullptr, *lambda = nullptr;
};

// Of all cells but the outermost, which are set to 0; bounds: of each, so much.
void findSurroundings(const CellHits& cells, float bounds, std::uint16_t* out);

// The view's rays through the places (x, y) of the picture into rays[first ...], the polygon going on beyond its edges;
// for pixels' centres the picture's own rays, which never lie outside by more than rounding.
void raysThrough(const PixelView& view, std::span<const double> x, std::span<const double> y, RayBlock& rays,
                 std::size_t first);

// Hits between pixels' centres, and what is asked of them. All columns of one length.
struct PointHits {
    std::span<const double> x, y;  // places in the picture
    std::span<const double> lambda, s, t;
};

// Footprints of that blur on the surface's tangent plane at each hit, behind `points`, texels of the picture. slopes:
// null: on level ground (columns).
void layFootprints(const PixelView& view, const SlopeScene* slopes, const PointBlur& blur, glm::dvec2 scale,
                   const PointHits& hits, PointBlock& points);

// Whether the colours of four centres differ so little that those of points between are taken as their mean: by so
// much of white at most in each channel, and by no more than that part of the brightest, for in the dark less is seen.
inline constexpr float kEvenColors = 1.0F / 64, kEvenShare = 0.25F;
// Of each cell [0, count), all bits or none: whether the centres' colours of the cells c, c + 1, c + row, c + row + 1
// are so, by `bounds` of kEvenColors. Infinite where they are not known; kCellSlack more at all columns' ends.
void findEven(const std::array<const float*, 3>& channel, std::size_t row, std::size_t count, float bounds,
              std::uint16_t* even);
// Of centres, the first of each cell's `points` colours: red, green, blue of the cells that ask for theirs (bit 0) and
// met something, infinity of the others. kCellSlack cells more at all columns' ends.
void splitCentres(const PointColor* colors, std::size_t points, const std::uint16_t* asked, std::size_t count,
                  const std::array<float*, 3>& out);
// sums[n] = sum over k, in their order, of weight[k] * colors[base[n] + offset[k]].
void sumPoints(const PointColor* colors, std::span<const std::int32_t> base, std::span<const std::int32_t> offset,
               std::span<const float> weight, std::span<PointColor> sums);

}  // namespace relief
