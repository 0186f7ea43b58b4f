// Perspective-correct texture coordinates along rows of pixels: the variants of [PERSP] and the sub-span division,
// behind one interface.
//
// Source: Romaniuk and Dudnyk, [PERSP] and [TEX]; Heckbert 1989; sub-spans: the games of the 1990s.
// Per pixel, u and v together (proved on a counting scalar; restarts not included):
//
//     variant                  mul   add    div   what
//     affine                    0     2      0    u, v linear along the row: wrong on purpose
//     direct                    8     8      2    (A x + B y + C) / (G x + H y + I), q made twice
//     row-constant              4     4      2    (u_t + A n) / (u_b + G n)
//     incremental               0     4      2    w += A, q += G
//     incremental-shared        0     3      2    one q for u and v
//     incremental-reciprocal    2     3      1    one division for u and v
//     streams                   0     3      2    k interleaved streams, w_n = w_n-k + k A; k lanes at once
//     opposed                   0     3      2    from both ends to the middle
//     rows-parallel             0     3      2    streams, the rows by several threads
//     subspan                  4/m  2+3/m  1/m    a division every m pixels, linear between
//
// Frames and units: pixels with centres at + 1/2, texels; homography.h. Rows lie at any real y.
//
// Where q nears zero: a row is cut to the pixels with q of at least smallestRowQ before it is evaluated, so that no
// rounding or drift brings q to zero. Nothing here makes NaN or infinity from a map that homography.h accepts.
//
// Errors in float (double: with 2^-53), with U the largest |u|, |v| on the row, e = 2^-24:
//   - forward differences drift, and as the same rounding is made again and again they come near their bound: with s
//     steps since the last restart (k streams: a k-th of the pixels) it is (2 s + 3) e U Q, Q the ratio of the largest
//     q to the smallest between two restarts. Unanchored Q is that of the whole row: oblique rows drift most.
//   - anchored rows start again from a correctly rounded value every `anchor` pixels. recommendedAnchor gives the
//     longest stretch that keeps a given error, 1/256 texel by itself: 6 steps for a texture of 4,096.
//   - direct and row-constant lose the digits that cancel in q and the numerators: 8 e U t / q with t = |G x| + |H y| +
//     |I|, for any q that smallestRowQ admits; the restarts of the others the same with 2^-53.
// Failure mode: none on valid maps; counts and options out of range assert. Cost: the table; each row 6 mul, 6 add.
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
// "affine", "direct", ... as in the table above.
std::string_view rowVariantName(RowVariant variant);
std::optional<RowVariant> rowVariant(std::string_view name);

inline constexpr int kMostStreams = 4096;
inline constexpr int kLongestSpan = 65536;

// What recommendedAnchor keeps by itself: a bilinear weight has 8 bits then.
inline constexpr double kAnchorError = 1.0 / 256;
inline constexpr int kRecommended = -1;
inline constexpr int kNever = 0;

struct RowOptions {
    RowVariant variant = RowVariant::Streams;
    int streams = 16;           // streams, rows-parallel: k, 1 to kMostStreams
    int span = 16;              // subspan: m, pixels, 1 to kLongestSpan
    int anchor = kRecommended;  // forward differences: pixels between restarts; rounded up to whole steps
    bool lanes = true;          // streams: the SIMD version where there is one, with the same bits

    bool operator==(const RowOptions&) const = default;
};

inline constexpr RowOptions kDirectRows{RowVariant::Direct};

// Whether a variant goes by forward differences (and so takes an anchor), and how many pixels one of its steps is.
bool drifts(RowVariant variant);
int pixelsPerStep(const RowOptions& options);

// Pixels between restarts that keep |u|, |v| <= largestTexel within `error` texels, at least one step. change: |G| over
// the smallest q of the row, by how much of itself q changes in a pixel.
template <typename T>
std::int64_t recommendedAnchor(double largestTexel, double change, const RowOptions& options,
                               double error = kAnchorError);

// The smallest q that a row is evaluated at in T: twice what rounding and the steps between restarts can add up to.
// count: pixels of the row; anchor: as resolved, 0 for never.
template <typename T>
double smallestRowQ(const Homography& map, double y, PixelSpan span, const RowOptions& options, std::int64_t anchor);

// The part of the row on which q is large enough, and the anchor used there.
struct RowPlan {
    PixelSpan valid;
    std::int64_t anchor = 0;  // pixels; 0: never restarts, or does not drift
};
template <typename T>
RowPlan planRow(const Homography& map, double y, PixelSpan span, const RowOptions& options);

// u[i - span.begin], v[i - span.begin] for the pixels i of the part returned; the others are not written.
// T: float or double.
template <typename T>
PixelSpan evaluateRow(const Homography& map, double y, PixelSpan span, const RowOptions& options, T* u, T* v);

// Many rows: pixels [0, width) of the lines y = firstY + r stepY, r from 0 to rows - 1.
struct RowBlock {
    std::int64_t width = 0;
    std::int64_t rows = 0;
    double firstY = 0.5;
    double stepY = 1.0;
};

// Room for rows of u and v, each row aligned to a cache line.
template <typename T>
class TexelRows {
  public:
    TexelRows(std::int64_t width, std::int64_t rows);
    T* u(std::int64_t row) { return u_.get() + row * stride_; }
    T* v(std::int64_t row) { return v_.get() + row * stride_; }
    PixelSpan& valid(std::int64_t row) { return valid_[static_cast<std::size_t>(row)]; }
    std::int64_t width() const { return width_; }
    std::int64_t rows() const { return rows_; }
    // Of u and v together.
    std::size_t bytes() const { return 2 * static_cast<std::size_t>(stride_ * rows_) * sizeof(T); }

  private:
    struct Free {
        void operator()(T* memory) const;
    };
    std::int64_t width_, rows_, stride_;
    std::unique_ptr<T, Free> u_, v_;
    std::vector<PixelSpan> valid_;
};

// All rows of the block into `out`, which must have at least its size. rows-parallel: on the threads of the work.
// Blocks that do not fit the cache are written past it (streams with lanes; the bits are the same). Throws Cancelled.
template <typename T>
void evaluateRows(const Homography& map, const RowBlock& block, const RowOptions& options, TexelRows<T>& out,
                  Work& work);

}  // namespace relief
