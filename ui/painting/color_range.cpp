#include "painting/color_range.h"

#include <cmath>

namespace reliefui {

namespace {

constexpr double kDecades = 6;  // largest span of a logarithmic scale that is chosen automatically
constexpr double kOneDecade = 10;

// Smallest share of a two-sided scale used for values other than 0, so that only 0 has the colour of 0.
constexpr double kLeastShare = 2e-3;

}  // namespace

const std::string& rangeName(RangeOf of) {
    static const std::array<std::string, kRangesOf> names{"steps",      "error",      "depth",
                                                          "anisotropy", "hidden",     "distance",
                                                          "slope",      "difference", "slope-difference",
                                                          "height",     "compare-l1", "compare-flip"};
    return names[static_cast<std::size_t>(of)];
}

ColorRange standardRange(RangeOf of) {
    ColorRange range;
    range.logarithmic = of == RangeOf::Error || of == RangeOf::Anisotropy || of == RangeOf::Slope;
    if (of == RangeOf::Steps) {
        // A single outlier ray takes many times as many steps as the others.
        range.ends = RangeEnds::Percentile;
        range.high = 99.9;
    }
    if (of == RangeOf::CompareL1) {
        // A few pixels at edges differ far more than all others.
        range.ends = RangeEnds::Percentile;
        range.high = 99;
    }
    if (of == RangeOf::Slope) {
        // A few cones at the deepest points are many times narrower than the others.
        range.ends = RangeEnds::Percentile;
        range.low = 1;
        range.high = 99.9;
    }
    return range;
}

ColorRange ColorRanges::of(RangeOf picture) const {
    return changed_[static_cast<std::size_t>(picture)].value_or(standardRange(picture));
}

bool ColorRanges::changed(RangeOf picture) const {
    return changed_[static_cast<std::size_t>(picture)].has_value();
}

void ColorRanges::set(RangeOf picture, const ColorRange& range) {
    auto& own = changed_[static_cast<std::size_t>(picture)];
    if (range == standardRange(picture)) {
        own.reset();
    } else {
        own = range;
    }
}

void ValueSpread::add(float value) {
    if (std::isnan(value)) return;
    const auto v = static_cast<double>(value);
    least_ = added_ == 0 ? v : std::min(least_, v);
    largest_ = added_ == 0 ? v : std::max(largest_, v);
    const double magnitude = std::abs(v);
    if (magnitude > 0 && (leastPositive_ == 0 || magnitude < leastPositive_)) leastPositive_ = magnitude;
    if (added_++ % stride_ != 0) return;
    values_.push_back(value);
    if (values_.size() <= most_) return;
    for (std::size_t i = 0; 2 * i < values_.size(); ++i) values_[i] = values_[2 * i];
    values_.resize((values_.size() + 1) / 2);
    stride_ *= 2;
}

void ValueSpread::finish() {
    std::sort(values_.begin(), values_.end());
}

double ValueSpread::largestMagnitude() const {
    return std::max(std::abs(least_), std::abs(largest_));
}

double ValueSpread::quantile(double share) const {
    if (values_.empty()) return 0;
    const auto last = static_cast<double>(values_.size() - 1);
    return static_cast<double>(values_[static_cast<std::size_t>(std::ceil(std::clamp(share, 0.0, 1.0) * last))]);
}

double ValueSpread::magnitudeQuantile(double share) const {
    if (values_.empty()) return 0;
    std::vector<float> magnitudes;
    magnitudes.reserve(values_.size());
    for (const float value : values_) magnitudes.push_back(std::abs(value));
    const auto at = static_cast<std::ptrdiff_t>(
        std::ceil(std::clamp(share, 0.0, 1.0) * static_cast<double>(magnitudes.size() - 1)));
    std::nth_element(magnitudes.begin(), magnitudes.begin() + at, magnitudes.end());
    return static_cast<double>(magnitudes[static_cast<std::size_t>(at)]);
}

std::int64_t ValueSpread::notBelow(double value) const {
    const auto at = std::lower_bound(values_.begin(), values_.end(), value,
                                     [](float a, double b) { return static_cast<double>(a) < b; });
    return values_.end() - at;
}

std::int64_t ValueSpread::above(double value) const {
    const auto at = std::upper_bound(values_.begin(), values_.end(), value,
                                     [](double a, float b) { return a < static_cast<double>(b); });
    return std::min(added_, (values_.end() - at) * stride_);
}

std::int64_t ValueSpread::between(double from, double to) const {
    return (notBelow(from) - notBelow(to)) * stride_;
}

double ColorScale::place(double v) const {
    const double from = twoSided && !logarithmic ? 0 : low;
    const double size = twoSided ? std::abs(v) : v;
    double share = 0;
    if (!(high > from)) {
        share = 0;
    } else if (!logarithmic) {
        share = (size - from) / (high - from);
    } else if (size > from) {
        share = std::log(size / from) / std::log(high / from);
    }
    if (!twoSided) return share;
    if (v != 0 && high > from) share = std::max(share, kLeastShare);
    return 0.5 + std::copysign(share / 2, v);
}

double ColorScale::value(double place) const {
    const double from = twoSided && !logarithmic ? 0 : low;
    const double share = twoSided ? std::abs(2 * place - 1) : place;
    double size = logarithmic ? from * std::pow(high / from, share) : from + share * (high - from);
    // The middle of the scale is exactly 0, although a logarithmic scale starts at `low`.
    if (twoSided && share == 0) size = 0;
    return twoSided && place < 0.5 ? -size : size;
}

ColorScale colorScale(const ColorRange& range, const ValueSpread& spread, const ScaleEnds& ends) {
    ColorScale scale;
    scale.twoSided = ends.twoSided;
    scale.low = ends.twoSided ? 0 : ends.low;
    scale.high = ends.high;
    scale.threshold = range.threshold;
    constexpr double kPercent = 100;
    if (range.ends == RangeEnds::Own) {
        if (!ends.twoSided) scale.low = range.low;
        scale.high = range.high;
    } else if (range.ends == RangeEnds::Percentile && !spread.empty()) {
        if (!ends.twoSided && range.low > 0) scale.low = spread.quantile(range.low / kPercent);
        if (range.high < kPercent) {
            const double share = range.high / kPercent;
            scale.high = ends.twoSided ? spread.magnitudeQuantile(share) : spread.quantile(share);
        }
        // Nearly all values are equal: the percentiles coincide, so the full range is used to show the values that
        // differ.
        if (!(scale.high > scale.low)) scale.high = ends.high;
    }
    if (!range.logarithmic) return scale;
    if (!(scale.high > 0)) return scale;
    if (!(scale.low > 0)) {
        scale.low =
            ends.least > 0 ? ends.least : std::max(spread.leastPositive(), scale.high * std::pow(10, -kDecades));
    }
    // An automatic logarithmic scale spans at least one decade; ends chosen by the user are kept.
    if (range.ends != RangeEnds::Own || !(scale.high > scale.low)) {
        scale.high = std::max(scale.high, kOneDecade * scale.low);
    }
    scale.logarithmic = true;
    return scale;
}

}  // namespace reliefui
