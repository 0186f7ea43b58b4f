// The checks of relief stress beyond view rays: any-hit queries, frames, homographies, rows; one answer at a time.
#pragma once

#include <functional>
#include <span>

#include "mapping/rows/derivatives.h"
#include "mapping/rows/rows.h"
#include "measuring/verify/stress_checks.h"
#include "relief/visibility/any_hit.h"
#include "rendering/frame.h"

namespace relief {

// A view ray as a segment through the whole slab; mu is its lambda.
AnyRay wholeSegment(const ViewRay& ray);

// What an any-hit query answered for wholeSegment(ray), with a log.
struct CountedVisibility {
    Visibility visibility = Visibility::Clear;
    std::uint32_t steps = 0;
    StepLog log;
};

// any-hit: blocked where `exact` misses, or in a cell that ends before the first hit; clear although the surface
// rises above the ray behind it (by kSureHeight, at sampled places); limit: gave up within the domain; steps: more than
// AnyHitQuery::stepBound. Beyond the domain only the steps count. reference: what `exact` found.
std::optional<StressFault> anyHitFault(const AnyHitQuery& query, const ViewRay& ray, const CountedVisibility& answer,
                                       const Hit& reference);
// Heights by which the surface must rise above a ray for the check to be sure of it: well above kVisibilityClearance
// and the rounding of places.
inline constexpr double kSureHeight = 1e-5;

// not-finite: a hit, a colour or a lit colour with a number that is none.
std::optional<StressFault> finiteFault(const Frame& frame);
// The fault `check` at the first pixel in which the frames differ: polygons, depths, hits, colours, lit colours. `what`
// says what the second was rendered with.
std::optional<StressFault> differenceFault(const Frame& frame, const Frame& other, std::string_view check,
                                           std::string_view what);

// bounded: a hit is farther than `bound` texels from that of the frame in which nothing was spared (whole), where both
// hit.
std::optional<StressFault> boundFault(const Frame& frame, const Frame& whole, double bound);

// round-trip: the inverse map does not lead the pixel's texel back to the pixel (x, y); not-finite: a texel with a
// number that is none where q > 0. Allowed: kStressSlack times the rounding that the sizes of the terms admit; nothing
// is checked where that is more than kTrustedShare of q.
std::optional<StressFault> roundTripFault(const Homography& map, const Homography& inverse, double x, double y);
// derivatives: the direct derivatives differ from central differences. Of s and t they are off by the known factor 1 -
// (h q_x / q)^2, so that nothing but rounding is allowed for, as above.
std::optional<StressFault> derivativeFault(const Homography& map, const DerivativeTerms<double>& terms, double x,
                                           double y);
inline constexpr double kStressSlack = 16;
inline constexpr double kTrustedShare = 1e-3;

struct LongTexel {
    long double s, t;
};
// The texel at the middle of a pixel of the row's line y.
LongTexel truthAt(const Homography& map, double y, std::int64_t pixel);
// A row of `width` pixels whose q goes from 1 to lastQ and whose u goes from 0 to `texels`, v between two values, all
// texels not negative; the row's line is y = 0.5.
Homography rowOfRatio(double width, double lastQ, double texels, double firstV, double lastV);

// One row as a variant evaluated it; u, v: of the pixels of the whole span.
template <typename T>
struct StressRow {
    const Homography* map = nullptr;
    double y = 0.5;  // the row's line, pixels
    PixelSpan span;
    RowOptions options;
    bool stated = false;  // the bounds of rows.h apply: no numerator cancels along the row
    PixelSpan valid;
    std::vector<T> u, v;
};
// evaluateRow(), or what is tried in its place.
template <typename T>
using RowEvaluator = std::function<PixelSpan(const Homography&, double, PixelSpan, const RowOptions&, T*, T*)>;
// The row that it evaluates.
template <typename T>
StressRow<T> evaluatedRow(const Homography& map, double y, PixelSpan span, const RowOptions& options, bool stated,
                          const RowEvaluator<T>& evaluate = evaluateRow<T>);
// not-finite: a texel with a number that is none; horizon: a pixel with q <= 0 was evaluated; row: farther from the map
// in long double than the variant's stated bound, or (not stated) than a q that is half off makes it. affine and
// subspan are approximations: only finite.
template <typename T>
std::optional<StressFault> rowFault(const StressRow<T>& row);

}  // namespace relief
