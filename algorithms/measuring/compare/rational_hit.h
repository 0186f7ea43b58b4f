// The first hit of a ray, decided in exact rational arithmetic. It is the judge where computations in double or long
// double disagree: at tangencies, at the corners of columns, and where a ray enters on a border between cells. It
// shares no code with the tracers.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

// The first hit of a ray with the surface that the stored heights describe, all numbers taken as the rationals that
// they are. lambda: rounded to double; meaningless for a miss.
// clearance: the smallest distance in height by which the answer was decided: how closely the ray passed a cell before
// the hit, or how far the surface rises above it in the cell of the hit. Infinite if nothing was close.
struct RationalHit {
    bool hit = false;
    double lambda = 0;
    double clearance = std::numeric_limits<double>::infinity();
};

// Number of cells that a ray may cross.
inline constexpr std::int64_t kRationalCells = std::int64_t{1} << 16;

// Returns the first hit; std::nullopt if the ray crosses more than kRationalCells cells or is not finite. A ray through
// the corner of four columns passes from one to the opposite one; the columns that it touches in a point do not count.
// Runs below 1e-300 are taken as 0, as by all tracers. The heights must be in memory. Cost: some microseconds per cell
// in which the surface comes close to the ray, nanoseconds for other cells.
std::optional<RationalHit> rationalHit(const HeightField& field, const ViewRay& ray);

// The surface minus the ray at lambda in [0, 1], a height, computed in rationals and rounded once. Columns: of the
// column that the ray is in, or is about to enter.
double rationalGap(const HeightField& field, const ViewRay& ray, double lambda);

// Rounding of positions in double along a ray over the field, texels: the uncertainty of the place at which a tracer
// computes the surface.
double placeRounding(const HeightField& field, const ViewRay& ray);

// How an answer relates to the exact one.
// Same: within kRationalTexels of it. Rounding: it differs, but would be right for a surface or a ray shifted by
// placeRounding(). Wrong: neither.
enum class RationalVerdict : std::uint8_t { Same, Rounding, Wrong };
// Bound of |lambda - exact lambda| max(1, hypot(a, b)), texels: the leaf's rounding where the ray is not tangent.
inline constexpr double kRationalTexels = 1e-9;
RationalVerdict judgeHit(const HeightField& field, const ViewRay& ray, const Hit& hit, const RationalHit& exact);

}  // namespace relief
