// Perspective-correct texture coordinates along rows of pixels: the variants of [PERSP] and sub-span division, with one
// interface.
//
// Source: Romaniuk and Dudnyk, [PERSP] and [TEX]; Heckbert 1989; sub-spans: the games of the 1990s. Operations per
// pixel for u and v together, without restarts (verified with a counting scalar):
//
//     variant                  mul   add    div   what
//     affine                    0     2      0    u, v linear along the row: no perspective, as a contrast
//     direct                    8     8      2    (A x + B y + C) / (G x + H y + I), q computed twice
//     row-constant              4     4      2    (u_t + A n) / (u_b + G n)
//     incremental               0     4      2    w += A, q += G
//     incremental-shared        0     3      2    one q for u and v
//     incremental-reciprocal    2     3      1    one division for u and v
//     streams                   0     3      2    k interleaved streams, w_n = w_n-k + k A; SIMD: k lanes
//     opposed                   0     3      2    from both ends to the middle
//     rows-parallel             0     3      2    streams, with the rows on several threads
//     subspan                  4/m  2+3/m  1/m    a division every m pixels, linear in between
//
// Frames and units: pixels with centres at + 1/2, texels; see homography.h. A row may lie at any real y.
//
// Near the horizon: a row is clipped to the pixels with q of at least smallestRowQ before it is evaluated, so that
// neither rounding nor drift can bring q to zero. No result is NaN or infinite if homography.h accepts the map.
//
// Errors in float (for double replace 2^-24 by 2^-53), with U the largest |u|, |v| on the row and e = 2^-24:
// - Forward differences drift, and as the same rounding recurs, the error comes near its bound. After s steps since the
//   last restart (with k streams a step is k pixels) the bound is (2 s + 3) e U Q, where Q is the ratio of the largest
//   q to the smallest between two restarts. Without restarts Q is that of the whole row, so oblique rows drift most.
// - Anchored rows restart from a correctly rounded value every `anchor` pixels. recommendedAnchor returns the longest
//   interval that keeps a given error, 1/256 texel by default: 6 steps for a texture of 4,096 texels.
// - Direct and row-constant lose the digits that cancel in q and the numerators: the error is 8 e U t / q with
//   t = |G x| + |H y| + |I|, for any q that smallestRowQ admits. The restarts of the others have the same error with
//   2^-53 for e.
//
// Errors: none on valid maps; counts and options out of range assert. Cost: see the table; each row adds 6 mul, 6 add.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mapping/clipping.h"
#include "mapping/homography.h"
#include "mapping/rows/row_terms.h"
#include "relief/work.h"

namespace relief {

enum class RowVariant : std::uint8_t {
    Affine,
    Direct,
    RowConstant,
    Incremental,
    IncrementalShared,
    IncrementalReciprocal,
    Streams,
    Opposed,
    RowsParallel,
    Subspan
};
inline constexpr int kRowVariants = 10;
// Names as in the table above: "affine", "direct", ... rowVariant returns std::nullopt for an unknown name.
std::string_view rowVariantName(RowVariant variant);
std::optional<RowVariant> rowVariant(std::string_view name);

inline constexpr int kMostStreams = 4096;
inline constexpr int kLongestSpan = 65536;

// Default error of recommendedAnchor, texels. It makes a bilinear weight accurate to 8 bits.
inline constexpr double kAnchorError = 1.0 / 256;
// Values of RowOptions::anchor: as recommendedAnchor() returns, or no restarts.
inline constexpr int kRecommended = -1;
inline constexpr int kNever = 0;

struct RowOptions {
    RowVariant variant = RowVariant::Streams;
    int streams = 16;           // streams, rows-parallel: k, 1 to kMostStreams
    int span = 16;              // subspan: m, pixels, 1 to kLongestSpan
    int anchor = kRecommended;  // forward differences: pixels between restarts; rounded up to whole steps
    bool lanes = true;          // streams: the SIMD version if there is one, with the same bits

    bool operator==(const RowOptions&) const = default;
};

inline constexpr RowOptions kDirectRows{RowVariant::Direct};

// Returns true if a variant uses forward differences (and so takes an anchor). pixelsPerStep: number of pixels that one
// of its steps advances.
bool drifts(RowVariant variant);
int pixelsPerStep(const RowOptions& options);

// Pixels between restarts that keep the error within `error` texels if |u|, |v| <= largestTexel; at least one step.
// change: relative change of q per pixel, |G| over the smallest q of the row.
template <typename T>
std::int64_t recommendedAnchor(double largestTexel, double change, const RowOptions& options,
                               double error = kAnchorError);

// The smallest q at which a row is evaluated in T: twice the accumulated error of rounding and of the steps between
// restarts. anchor: pixels, resolved; 0: never.
template <typename T>
double smallestRowQ(const Homography& map, double y, PixelSpan span, const RowOptions& options, std::int64_t anchor);

// The part of the row on which q is large enough, and the resolved anchor.
struct RowPlan {
    PixelSpan valid;
    std::int64_t anchor = 0;  // pixels; 0: no restarts, or no drift
};
template <typename T>
RowPlan planRow(const Homography& map, double y, PixelSpan span, const RowOptions& options);

// Writes u[i - span.begin], v[i - span.begin] for the pixels i of the returned part of the span; other elements are not
// written. T: float or double.
template <typename T>
PixelSpan evaluateRow(const Homography& map, double y, PixelSpan span, const RowOptions& options, T* u, T* v);

// A block of rows: pixels [0, width) of the lines y = firstY + r stepY, for r from 0 to rows - 1.
struct RowBlock {
    std::int64_t width = 0;
    std::int64_t rows = 0;
    double firstY = 0.5;
    double stepY = 1.0;
};

// Storage for rows of u and v, each row aligned to a cache line.
template <typename T>
class TexelRows {
  public:
    TexelRows(std::int64_t width, std::int64_t rows);
    T* u(std::int64_t row) { return u_.get() + row * stride_; }
    T* v(std::int64_t row) { return v_.get() + row * stride_; }
    // The part of the row that was evaluated.
    PixelSpan& valid(std::int64_t row) { return valid_[static_cast<std::size_t>(row)]; }
    std::int64_t width() const { return width_; }
    std::int64_t rows() const { return rows_; }
    // Memory of u and v together, bytes.
    std::size_t bytes() const { return 2 * static_cast<std::size_t>(stride_ * rows_) * sizeof(T); }

  private:
    struct Free {
        void operator()(T* memory) const;
    };
    std::int64_t width_, rows_, stride_;
    std::unique_ptr<T, Free> u_, v_;
    std::vector<PixelSpan> valid_;
};

// Evaluates all rows of the block into `out`, which must be at least as large. rows-parallel runs on the threads of the
// work. Output that does not fit the cache is written by non-temporal stores (streams in SIMD; same bits). Throws
// Cancelled.
template <typename T>
void evaluateRows(const Homography& map, const RowBlock& block, const RowOptions& options, TexelRows<T>& out,
                  Work& work);

}  // namespace relief
