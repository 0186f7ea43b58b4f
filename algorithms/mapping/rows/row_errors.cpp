#include "mapping/rows/row_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relief {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::int32_t streamOf(const RowOptions& options, std::int64_t n, std::int64_t count, std::int64_t anchor) {
    switch (options.variant) {
        case RowVariant::Streams:
        case RowVariant::RowsParallel:
            return static_cast<std::int32_t>((anchor > 0 ? n % anchor : n) % options.streams);
        case RowVariant::Opposed:
            return n < (count + 1) / 2 ? 0 : 1;
        default:
            return 0;
    }
}

// Indices, from the first valid pixel, of the pixels whose values do not come from their neighbours'.
std::vector<std::int64_t> exactPixels(const RowOptions& options, std::int64_t count, std::int64_t anchor) {
    std::vector<std::int64_t> pixels;
    if (!drifts(options.variant)) return pixels;
    const bool subspan = options.variant == RowVariant::Subspan;
    const bool opposed = options.variant == RowVariant::Opposed;
    const std::int64_t reach = opposed ? count / 2 : count;
    const std::int64_t every = subspan ? options.span : anchor > 0 ? anchor : std::max<std::int64_t>(reach, 1);
    for (std::int64_t n = 0; n < reach; n += every) {
        pixels.push_back(n);
        if (opposed) pixels.push_back(count - 1 - n);
    }
    if (subspan && pixels.back() != count - 1) pixels.push_back(count - 1);
    if (opposed && count % 2 != 0) pixels.push_back(count / 2);
    std::sort(pixels.begin(), pixels.end());
    return pixels;
}

template <typename T>
RowCurve curveOf(const Homography& map, double y, const RowErrors& row, const RowOptions& options) {
    const auto size = static_cast<std::size_t>(row.span.size());
    std::vector<T> u(size), v(size);
    RowCurve curve;
    curve.options = options;
    curve.anchor = planRow<T>(map, y, row.span, options).anchor;
    curve.valid = evaluateRow(map, y, row.span, options, u.data(), v.data());
    curve.u.assign(size, kNone);
    curve.v.assign(size, kNone);
    curve.error.assign(size, kNone);
    curve.stream.assign(size, 0);
    curve.worstPixel = curve.valid.begin;
    for (std::int64_t pixel = curve.valid.begin; pixel < curve.valid.end; ++pixel) {
        const auto i = static_cast<std::size_t>(pixel - row.span.begin);
        curve.u[i] = static_cast<double>(u[i]);
        curve.v[i] = static_cast<double>(v[i]);
        curve.error[i] = std::max(std::abs(curve.u[i] - row.u[i]), std::abs(curve.v[i] - row.v[i]));
        curve.stream[i] = streamOf(options, pixel - curve.valid.begin, curve.valid.size(), curve.anchor);
        if (curve.error[i] > curve.worst) curve.worst = curve.error[i], curve.worstPixel = pixel;
    }
    if (!curve.valid.empty()) curve.exact = exactPixels(options, curve.valid.size(), curve.anchor);
    for (std::int64_t& pixel : curve.exact) pixel += curve.valid.begin;
    return curve;
}

}  // namespace

template <typename T>
RowErrors rowErrors(const Homography& map, double y, PixelSpan span, const std::vector<RowOptions>& variants) {
    RowErrors row;
    row.span = span;
    for (std::int64_t pixel = span.begin; pixel < span.end; ++pixel) {
        const double x = static_cast<double>(pixel) + 0.5;
        const TexelPoint at = map.at(x, y);
        row.x.push_back(x);
        row.u.push_back(at.q > 0 ? at.s : kNone);
        row.v.push_back(at.q > 0 ? at.t : kNone);
        row.q.push_back(at.q > 0 ? at.q : kNone);
    }
    if (span.empty()) return row;
    for (const RowOptions& options : variants) row.curves.push_back(curveOf<T>(map, y, row, options));
    return row;
}

template RowErrors rowErrors<float>(const Homography&, double, PixelSpan, const std::vector<RowOptions>&);
template RowErrors rowErrors<double>(const Homography&, double, PixelSpan, const std::vector<RowOptions>&);

}  // namespace relief
