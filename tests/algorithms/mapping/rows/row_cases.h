// Seeded rows for the tests of algorithms/mapping/rows, and their exact values in long double.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "algorithms/mapping/mapping_cases.h"
#include "mapping/rows/rows.h"
#include "measuring/verify/stress_part_checks.h"

namespace relief::test {

// relief::rowOfRatio(), optionally mirrored from left to right.
inline Homography rowOfRatio(double width, double lastQ, double texels, double firstV, double lastV, bool mirrored) {
    const Homography map = relief::rowOfRatio(width, lastQ, texels, firstV, lastV);
    if (!mirrored) return map;
    // x -> width - x
    return Homography{-map.sx, 0, map.s1 + map.sx * width, -map.tx, 0, map.t1 + map.tx * width,
                      -map.qx, 0, map.q1 + map.qx * width}
        .normalised();
}

struct EvaluatedRow {
    PixelSpan valid;
    double worst = 0;    // largest error in texels
    double largest = 0;  // largest |u| or |v|
    bool finite = true;
    double wildest = 0;  // largest error, relative to the rounding error at a q with half its true value
};
template <typename T>
EvaluatedRow evaluated(const Homography& map, double y, PixelSpan span, const RowOptions& options) {
    const auto size = static_cast<std::size_t>(span.size());
    std::vector<T> u(size), v(size);
    EvaluatedRow row;
    row.valid = evaluateRow(map, y, span, options, u.data(), v.data());
    // The largest terms of the numerators, to which their rounding is relative.
    const double x = static_cast<double>(std::max(std::abs(span.begin), std::abs(span.end)));
    const double terms = std::max(std::abs(map.sx) * x + std::abs(map.sy * y) + std::abs(map.s1),
                                  std::abs(map.tx) * x + std::abs(map.ty * y) + std::abs(map.t1));
    const double largestQ = std::max(map.denominator(static_cast<double>(row.valid.begin) + 0.5, y),
                                     map.denominator(static_cast<double>(row.valid.end) - 0.5, y));
    for (std::int64_t i = row.valid.begin; i < row.valid.end; ++i) {
        const auto n = static_cast<std::size_t>(i - span.begin);
        const LongTexel truth = truthAt(map, y, i);
        const auto error = static_cast<double>(std::max(std::abs(static_cast<long double>(u[n]) - truth.s),
                                                        std::abs(static_cast<long double>(v[n]) - truth.t)));
        row.finite = row.finite && std::isfinite(u[n]) && std::isfinite(v[n]);
        const auto here = static_cast<double>(std::max(std::abs(truth.s), std::abs(truth.t)));
        row.wildest = std::max(row.wildest, error / (here + terms / largestQ));
        row.worst = std::isnan(error) ? error : std::max(row.worst, error);
        row.largest =
            std::max({row.largest, static_cast<double>(std::abs(truth.s)), static_cast<double>(std::abs(truth.t))});
    }
    return row;
}

inline std::vector<RowOptions> exactVariants() {
    std::vector<RowOptions> all;
    for (const RowVariant variant :
         {RowVariant::Direct, RowVariant::RowConstant, RowVariant::Incremental, RowVariant::IncrementalShared,
          RowVariant::IncrementalReciprocal, RowVariant::Opposed}) {
        all.push_back({variant});
    }
    for (const int k : {1, 2, 3, 7, 16, 33}) {
        RowOptions options{RowVariant::Streams};
        options.streams = k;
        all.push_back(options);
    }
    return all;
}

inline std::string nameOf(const RowOptions& options) {
    return std::string(rowVariantName(options.variant)) + ", " + std::to_string(options.streams) + " streams, span " +
           std::to_string(options.span) + ", anchor " + std::to_string(options.anchor);
}

}  // namespace relief::test
