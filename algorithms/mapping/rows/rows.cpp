#include "mapping/rows/rows.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <new>

#include "base/parallel.h"
#include "mapping/rows/row_kernels.h"
#include "mapping/rows/row_lanes.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, kRowVariants> kNames{
    "affine",  "direct",  "row-constant",  "incremental", "incremental-shared", "incremental-reciprocal",
    "streams", "opposed", "rows-parallel", "subspan"};

constexpr std::size_t kLineBytes = 64;
// Bytes. Output larger than this exceeds L2, and writing it through the cache would only evict useful data.
constexpr std::size_t kCacheBytes = std::size_t{2} << 20;
// Pixels per parallel task.
constexpr std::int64_t kPixelsPerPiece = 32768;

// Half a unit in the last place of 1.
template <typename T>
constexpr double kRoundoff = 0.5 * static_cast<double>(std::numeric_limits<T>::epsilon());
// Upper bound on the steps between restarts, also where the error would allow more: it gives a tighter bound of q.
template <typename T>
constexpr std::int64_t kMostSteps = sizeof(T) == sizeof(float) ? 64 : 65536;
// Number of roundings in q in addition to those of the steps.
constexpr double kOtherRoundings = 8;

std::int64_t stepsOf(const RowOptions& options, std::int64_t anchor, std::int64_t count) {
    if (!drifts(options.variant)) return 0;
    const std::int64_t pixels = anchor > 0 ? std::min(anchor, count) : count;
    return pixels / pixelsPerStep(options) + 1;
}

// The part of the span on which q >= minQ. q is monotone along the row, also in floating point.
PixelSpan inFrontOf(const Homography& map, double y, PixelSpan span, double minQ) {
    if (span.empty()) return {};
    const auto inFront = [&](std::int64_t pixel) {
        return map.denominator(static_cast<double>(pixel) + 0.5, y) >= minQ;
    };
    const bool first = inFront(span.begin);
    const bool last = inFront(span.end - 1);
    if (first && last) return span;
    if (!first && !last) return {};
    std::int64_t before = span.begin;
    std::int64_t after = span.end - 1;
    while (after - before > 1) {
        const std::int64_t middle = before + (after - before) / 2;
        (inFront(middle) == first ? before : after) = middle;
    }
    return first ? PixelSpan{span.begin, after} : PixelSpan{after, span.end};
}

template <typename T>
double smallestQ(const Homography& map, double y, PixelSpan span, const RowOptions& options, std::int64_t steps) {
    const double left = static_cast<double>(span.begin) + 0.5;
    const double right = static_cast<double>(span.end) - 0.5;
    const double largest = std::max(std::abs(map.denominator(left, y)), std::abs(map.denominator(right, y)));
    // G x + H y + I may cancel, so the error depends on the size of its terms, in the type in which they are added.
    const double terms =
        std::abs(map.qx) * std::max(std::abs(left), std::abs(right)) + std::abs(map.qy * y) + std::abs(map.q1);
    const double inT = options.variant == RowVariant::Direct ? terms : largest;
    const double error = kRoundoff<T> * (static_cast<double>(steps) + kOtherRoundings) * inT +
                         kRoundoff<double> * kOtherRoundings * terms;
    return std::max(2 * error, std::numeric_limits<double>::min());
}

template <typename T>
void evaluateValid(const RowTerms<T>& row, const RowOptions& options, bool pastCache, T* u, T* v) {
    const bool streams = options.variant == RowVariant::Streams || options.variant == RowVariant::RowsParallel;
    if (streams && options.lanes && hasStreamLanes(options.streams)) {
        return streamsRowLanes(row, options.streams, pastCache, u, v);
    }
    variantRow(row, options.variant, options.streams, options.span, u, v);
}

template <typename T>
PixelSpan evaluatePlanned(const Homography& map, double y, PixelSpan span, const RowOptions& options, bool pastCache,
                          T* u, T* v) {
    const RowPlan plan = planRow<T>(map, y, span, options);
    if (plan.valid.empty()) return {};
    const auto row = rowTerms<T>(map, y, plan.valid.begin, plan.valid.size(), plan.anchor);
    const std::int64_t offset = plan.valid.begin - span.begin;
    evaluateValid(row, options, pastCache, u + offset, v + offset);
    return plan.valid;
}

}  // namespace

std::string_view rowVariantName(RowVariant variant) {
    return kNames[static_cast<std::size_t>(variant)];
}

std::optional<RowVariant> rowVariant(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<RowVariant>(found - kNames.begin());
}

bool drifts(RowVariant variant) {
    return variant != RowVariant::Affine && variant != RowVariant::Direct && variant != RowVariant::RowConstant;
}

int pixelsPerStep(const RowOptions& options) {
    if (options.variant == RowVariant::Streams || options.variant == RowVariant::RowsParallel) return options.streams;
    return options.variant == RowVariant::Subspan ? options.span : 1;
}

template <typename T>
std::int64_t recommendedAnchor(double largestTexel, double change, const RowOptions& options, double error) {
    assert(error > 0 && change >= 0);
    const int pixels = pixelsPerStep(options);
    // (2 s + 3) e U Q <= error; the left side grows with s.
    const auto keeps = [&](std::int64_t steps) {
        const auto s = static_cast<double>(steps);
        return (2 * s + 3) * kRoundoff<T> * largestTexel * (1 + s * pixels * change) <= error;
    };
    // The root of the quadratic, without cancellation, then corrected to the exact integer in spite of rounding.
    const double most = error / (kRoundoff<T> * largestTexel) - 3;
    if (!(most > 2)) return pixels;
    const double growth = static_cast<double>(pixels) * change;
    const double linear = 2 + 3 * growth;
    const double root = 2 * most / (linear + std::sqrt(linear * linear + 8 * growth * most));
    if (root >= static_cast<double>(kMostSteps<T>)) return kMostSteps<T> * pixels;
    auto steps = std::max(static_cast<std::int64_t>(root), std::int64_t{1});
    if (steps > 1 && !keeps(steps)) --steps;
    if (keeps(steps + 1)) ++steps;
    return steps * pixels;
}

template <typename T>
double smallestRowQ(const Homography& map, double y, PixelSpan span, const RowOptions& options, std::int64_t anchor) {
    return smallestQ<T>(map, y, span, options, stepsOf(options, anchor, span.size()));
}

template <typename T>
RowPlan planRow(const Homography& map, double y, PixelSpan span, const RowOptions& options) {
    assert(options.streams >= 1 && options.streams <= kMostStreams);
    assert(options.span >= 1 && options.span <= kLongestSpan);
    if (span.empty()) return {};
    const int step = pixelsPerStep(options);
    std::int64_t anchor = 0;
    if (drifts(options.variant)) {
        anchor = options.anchor == kRecommended ? kMostSteps<T> * step : options.anchor;
        anchor = (anchor + step - 1) / step * step;
    }
    RowPlan plan{inFrontOf(map, y, span, smallestRowQ<T>(map, y, span, options, anchor)), anchor};
    if (plan.valid.empty() || !drifts(options.variant)) return plan;
    if (options.anchor == kRecommended) {
        // u and v are monotone where q does not change sign, so they are largest at the ends.
        const TexelPoint left = map.at(static_cast<double>(plan.valid.begin) + 0.5, y);
        const TexelPoint right = map.at(static_cast<double>(plan.valid.end) - 0.5, y);
        const double largest = std::max({std::abs(left.s), std::abs(left.t), std::abs(right.s), std::abs(right.t)});
        plan.anchor = recommendedAnchor<T>(largest, std::abs(map.qx) / std::min(left.q, right.q), options);
    }
    if (plan.anchor >= plan.valid.size()) plan.anchor = 0;  // the row ends before the first restart
    return plan;
}

template <typename T>
PixelSpan evaluateRow(const Homography& map, double y, PixelSpan span, const RowOptions& options, T* u, T* v) {
    return evaluatePlanned(map, y, span, options, false, u, v);
}

template <typename T>
void TexelRows<T>::Free::operator()(T* memory) const {
    ::operator delete (memory, std::align_val_t{kLineBytes});
}

template <typename T>
TexelRows<T>::TexelRows(std::int64_t width, std::int64_t rows)
    : width_(width), rows_(rows), valid_(static_cast<std::size_t>(rows)) {
    constexpr auto kLine = static_cast<std::int64_t>(kLineBytes / sizeof(T));
    stride_ = (width + kLine - 1) / kLine * kLine;
    const std::size_t bytes = std::max<std::size_t>(static_cast<std::size_t>(stride_ * rows) * sizeof(T), 1);
    u_.reset(static_cast<T*>(::operator new (bytes, std::align_val_t{kLineBytes})));
    v_.reset(static_cast<T*>(::operator new (bytes, std::align_val_t{kLineBytes})));
}

template <typename T>
void evaluateRows(const Homography& map, const RowBlock& block, const RowOptions& options, TexelRows<T>& out,
                  Work& work) {
    assert(out.width() >= block.width && out.rows() >= block.rows);
    const bool pastCache = out.bytes() > kCacheBytes;
    const auto piece = [&](std::int64_t begin, std::int64_t end) {
        work.throwIfStopped();
        for (std::int64_t r = begin; r < end; ++r) {
            const double y = block.firstY + static_cast<double>(r) * block.stepY;
            out.valid(r) = evaluatePlanned(map, y, {0, block.width}, options, pastCache, out.u(r), out.v(r));
        }
        if (pastCache) finishStores();
    };
    const std::int64_t grain = std::max<std::int64_t>(1, kPixelsPerPiece / std::max<std::int64_t>(block.width, 1));
    if (options.variant != RowVariant::RowsParallel) {
        for (std::int64_t r = 0; r < block.rows; r += grain) piece(r, std::min(r + grain, block.rows));
        return;
    }
    parallelRanges(work, block.rows, grain, piece);
}

// clang-format off
#define RELIEF_ROWS(T)                                                                                              \
    template std::int64_t recommendedAnchor<T>(double, double, const RowOptions&, double);                                   \
    template double smallestRowQ<T>(const Homography&, double, PixelSpan, const RowOptions&, std::int64_t);          \
    template RowPlan planRow<T>(const Homography&, double, PixelSpan, const RowOptions&);                            \
    template PixelSpan evaluateRow<T>(const Homography&, double, PixelSpan, const RowOptions&, T*, T*);              \
    template class TexelRows<T>;                                                                                     \
    template void evaluateRows<T>(const Homography&, const RowBlock&, const RowOptions&, TexelRows<T>&, Work&)
// clang-format on
RELIEF_ROWS(float);
RELIEF_ROWS(double);
#undef RELIEF_ROWS

}  // namespace relief
