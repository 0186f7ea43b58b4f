#include <algorithm>
#include <cmath>

#include "mapping/rows/row_planner.h"
#include "measuring/bench/bench_rows.h"
#include "panes/rows/rows_drawing.h"
#include "relief/errors.h"

namespace reliefui {

namespace {

using relief::RowVariant;

std::optional<AffinePlace> affinePlace(const RowsPlace& place, const relief::RowCurve& curve) {
    if (curve.valid.size() < 3) return std::nullopt;
    const double first = static_cast<double>(curve.valid.begin) + 0.5;
    const double last = static_cast<double>(curve.valid.end) - 0.5;
    const double q0 = place.map.denominator(first, place.y);
    const double q1 = place.map.denominator(last, place.y);
    const double ratio = std::max(q0, q1) / std::min(q0, q1);
    // Viewed perpendicularly, the linear interpolation is exact.
    constexpr double kFlat = 1e-9;
    if (!(ratio > 1 + kFlat)) return std::nullopt;
    const relief::AffineError worst = relief::affineError(ratio);
    const relief::RowSlopes slopes = relief::rowSlopes(place.map, place.y);
    AffinePlace at;
    at.share = worst.share;
    at.x = q0 > q1 ? first + worst.fraction * (last - first) : last - worst.fraction * (last - first);
    at.error =
        relief::linearError(std::max(std::abs(slopes.a), std::abs(slopes.b)), place.map.qx, last - first, q0, q1);
    return at;
}

// Span length of a sub-span method; if an error bound is given, the longest span that keeps it.
int spanOf(const relief::RowMethod& method, const RowsPlace& place) {
    if (!(method.settings.error > 0)) return method.settings.span;
    const std::int64_t longest = relief::longestSpan(place.map, place.y, place.span, method.settings.error);
    return static_cast<int>(std::min<std::int64_t>(longest, relief::kLongestSpan));
}

}  // namespace

std::vector<relief::RowMethod> rowMethods(const RowsOptions& options, const std::string& option) {
    std::vector<relief::RowMethod> methods;
    for (const std::string& text : options.methods) {
        relief::RowMethod method = relief::parseRowMethod(text, option);
        if (!std::holds_alternative<RowVariant>(method.description->kind)) {
            std::string known;
            for (int v = 0; v < relief::kRowVariants; ++v) {
                known += (v == 0 ? "" : ", ") + std::string(relief::rowVariantName(static_cast<RowVariant>(v)));
            }
            throw relief::InputError(
                option, relief::Message(relief::MessageId::UnknownName, {{"what", relief::MessageId::WordRowVariant},
                                                                         {"name", method.description->name},
                                                                         {"known", known}}));
        }
        methods.push_back(std::move(method));
    }
    if (methods.size() > kMostRowCurves) {
        throw relief::InputError(option, relief::Message(relief::MessageId::NumberOutOfRange,
                                                         {{"value", methods.size()},
                                                          {"range", relief::rangeOf<std::size_t>(1, kMostRowCurves)}}));
    }
    return methods;
}

RowsPlace widened(const RowsPlace& place, std::int64_t pixels) {
    if (pixels <= 0 || pixels == place.width) return place;
    RowsPlace wide = place;
    const double scale = static_cast<double>(pixels) / static_cast<double>(place.width);
    wide.map.sx /= scale;
    wide.map.tx /= scale;
    wide.map.qx /= scale;
    wide.map = wide.map.normalised();
    wide.width = pixels;
    const auto at = [&](double x) { return static_cast<std::int64_t>(x * scale); };
    wide.span = {at(static_cast<double>(place.span.begin)), at(static_cast<double>(place.span.end))};
    wide.span.end = std::max(wide.span.end, wide.span.begin + 1);
    wide.chosen = std::clamp(at(static_cast<double>(place.chosen) + 0.5), wide.span.begin, wide.span.end - 1);
    return wide;
}

int streamsOf(const relief::RowCurve& curve) {
    if (curve.options.variant == RowVariant::Opposed) return 2;
    const bool streams =
        curve.options.variant == RowVariant::Streams || curve.options.variant == RowVariant::RowsParallel;
    return streams ? curve.options.streams : 1;
}

RowsData rowsData(const RowsPlace& place, const std::vector<relief::RowMethod>& methods, bool inDouble) {
    RowsData data;
    data.place = place;
    data.inDouble = inDouble;
    std::vector<relief::RowOptions> variants;
    for (const relief::RowMethod& method : methods) {
        variants.push_back(method.options());
        variants.back().span = spanOf(method, place);
        data.names.push_back(method.text);
    }
    data.row = inDouble ? relief::rowErrors<double>(place.map, place.y, place.span, variants)
                        : relief::rowErrors<float>(place.map, place.y, place.span, variants);
    for (std::size_t c = 0; c < data.row.curves.size(); ++c) {
        const relief::RowCurve& curve = data.row.curves[c];
        // Counts cover two intervals between restarts; an interval longer than the row counts as no restarts.
        const bool restarts = curve.anchor > 0 && curve.anchor < place.span.size();
        data.counts.push_back(relief::pixelCounts(methods[c], curve.options.span, restarts ? curve.anchor : 0));
        if (curve.options.variant == RowVariant::Affine) data.affine = affinePlace(place, curve);
    }
    return data;
}

}  // namespace reliefui
