// One row evaluated by several variants, as plain arrays for plots: coordinates, errors along the row, and which stream
// computed which pixel.
//
// Frames and units: as in rows.h; errors in texels against the map in double. Pixels that a variant cuts off at the
// horizon hold NaN, so that curves break there. Cost: O(pixels) per variant.
#pragma once

#include <cstdint>
#include <vector>

#include "mapping/rows/rows.h"

namespace relief {

struct RowCurve {
    RowOptions options;
    PixelSpan valid;            // evaluated pixels
    std::int64_t anchor = 0;    // pixels between restarts, resolved; 0: none
    std::vector<double> u, v;   // texels, of the pixels of the span in order
    std::vector<double> error;  // the larger of the errors of u and v, texels
    // Index of the stream that computed each pixel. streams: n mod k; opposed: 0 left, 1 right; other variants: 0.
    std::vector<std::int32_t> stream;
    // Pixels whose value was computed exactly by a restart or a division, in order. Empty if all pixels are (direct,
    // row-constant) or only the ends (affine).
    std::vector<std::int64_t> exact;
    double worst = 0;  // largest error, texels
    std::int64_t worstPixel = 0;
};

struct RowErrors {
    PixelSpan span;               // pixels of the row
    std::vector<double> x;        // their centres
    std::vector<double> u, v, q;  // in double; NaN where q is not positive
    std::vector<RowCurve> curves;
};

// Evaluates the row by each variant. T: float or double, the precision of the variants.
template <typename T>
RowErrors rowErrors(const Homography& map, double y, PixelSpan span, const std::vector<RowOptions>& variants);

}  // namespace relief
