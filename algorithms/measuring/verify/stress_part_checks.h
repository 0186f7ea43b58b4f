// The checks of relief stress for any-hit queries, frames, homographies and rows, for one answer at a time.
#pragma once

#include <functional>
#include <span>

#include "mapping/rows/derivatives.h"
#include "mapping/rows/rows.h"
#include "measuring/verify/stress_checks.h"
#include "relief/visibility/any_hit.h"
#include "rendering/frame.h"

namespace relief {

// Returns a view ray as a segment through the whole slab; mu is its lambda.
AnyRay wholeSegment(const ViewRay& ray);

// The answer of an any-hit query for wholeSegment(ray), with a log.
struct CountedVisibility {
    Visibility visibility = Visibility::Clear;
    std::uint32_t steps = 0;
    StepLog log;
};

// Checks an any-hit query; reference: the answer of `exact`. any-hit: the segment is blocked although `exact` misses,
// or blocked in a cell that ends before the first hit, or clear although the surface rises above the ray behind the hit
// (by kSureHeight, at sampled positions); limit: a limit was reached within the domain; steps: more than
// AnyHitQuery::stepBound. Beyond the domain only the steps are checked.
std::optional<StressFault> anyHitFault(const AnyHitQuery& query, const ViewRay& ray, const CountedVisibility& answer,
                                       const Hit& reference);
// Height by which the surface must rise above a ray for the check to be certain: much larger than kVisibilityClearance
// and the rounding error of positions.
inline constexpr double kSureHeight = 1e-5;

// not-finite: a hit, a colour or a lit colour contains NaN or an infinite number.
std::optional<StressFault> finiteFault(const Frame& frame);
// Returns the fault `check` at the first pixel in which the frames differ: in polygon, depth, hit, colour or lit
// colour. `what` describes how the second frame was rendered.
std::optional<StressFault> differenceFault(const Frame& frame, const Frame& other, std::string_view check,
                                           std::string_view what);

// bounded: where both frames hit, a hit is farther than `bound` texels from that of the frame without approximations
// (whole).
std::optional<StressFault> boundFault(const Frame& frame, const Frame& whole, double bound);

// round-trip: the inverse homography does not map the pixel's texel back to the pixel (x, y); not-finite: a texel is
// NaN or infinite although q > 0. Tolerance: kStressSlack times the rounding error that follows from the sizes of the
// terms; not checked if this exceeds kTrustedShare of q.
std::optional<StressFault> roundTripFault(const Homography& map, const Homography& inverse, double x, double y);
// derivatives: the direct derivatives differ from central differences. For s and t, central differences differ from
// derivatives by the known factor 1 - (h q_x / q)^2, so that only rounding errors are tolerated, as above.
std::optional<StressFault> derivativeFault(const Homography& map, const DerivativeTerms<double>& terms, double x,
                                           double y);
inline constexpr double kStressSlack = 16;
inline constexpr double kTrustedShare = 1e-3;

struct LongTexel {
    long double s, t;
};
// Returns the texel at the centre of a pixel on the row's line y.
LongTexel truthAt(const Homography& map, double y, std::int64_t pixel);
// Returns the homography of a row of `width` pixels along which q goes from 1 to lastQ, u from 0 to `texels` and v from
// firstV to lastV, all texels not negative; the row's line is y = 0.5.
Homography rowOfRatio(double width, double lastQ, double texels, double firstV, double lastV);

// A row as evaluated by a variant; u, v: values for the pixels of the whole span.
template <typename T>
struct StressRow {
    const Homography* map = nullptr;
    double y = 0.5;  // the row's line, pixels
    PixelSpan span;
    RowOptions options;
    bool stated = false;  // the error bounds of rows.h apply, because no numerator cancels along the row
    PixelSpan valid;
    std::vector<T> u, v;
};
// evaluateRow(), or a function tested in its place.
template <typename T>
using RowEvaluator = std::function<PixelSpan(const Homography&, double, PixelSpan, const RowOptions&, T*, T*)>;
// Returns the row that `evaluate` computes.
template <typename T>
StressRow<T> evaluatedRow(const Homography& map, double y, PixelSpan span, const RowOptions& options, bool stated,
                          const RowEvaluator<T>& evaluate = evaluateRow<T>);
// Checks a row. not-finite: a texel is NaN or infinite; horizon: a pixel with q <= 0 was evaluated; row: the error
// relative to the homography in long double exceeds the variant's stated bound or, if `stated` is false, the error
// caused by a relative error of one half in q. affine and subspan are approximations and are only checked for finite
// values.
template <typename T>
std::optional<StressFault> rowFault(const StressRow<T>& row);

}  // namespace relief
