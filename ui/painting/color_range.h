// How values become places on a colour map: linear or logarithmic, between all values, percentiles or chosen ends, with
// a threshold. A plain value that a person chooses (ColorRange), what it comes to for the values of one picture
// (ColorScale), and these values as far as ranges and histograms need them (ValueSpread).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reliefui {

// What has a range of its own: layers of the result, distance maps, cone maps, differences of either, pyramids, errors
// of compared pictures.
enum class RangeOf : std::uint8_t {
    Steps,
    Error,
    Depth,
    Anisotropy,
    Hidden,
    Distance,
    Slope,
    Difference,
    SlopeDifference,
    Height,
    CompareL1,
    CompareFlip
};
inline constexpr std::size_t kRangesOf = 12;
// In scenarios: "steps", "slope-difference".
const std::string& rangeName(RangeOf of);

enum class RangeEnds : std::uint8_t { All, Percentile, Own };

struct ColorRange {
    bool logarithmic = false;
    RangeEnds ends = RangeEnds::All;
    // Percent of the values that are smaller, or values; nothing of all values. Two-sided pictures have `high` alone.
    double low = 0;
    double high = 1;
    std::optional<double> threshold;  // values up to it share one colour
    bool operator==(const ColorRange&) const = default;
};
// With which its picture is readable at once.
ColorRange standardRange(RangeOf of);

// Of all pictures; those that nobody has changed have the standard.
class ColorRanges {
  public:
    ColorRange of(RangeOf picture) const;
    bool changed(RangeOf picture) const;
    void set(RangeOf picture, const ColorRange& range);
    bool operator==(const ColorRanges&) const = default;

  private:
    std::array<std::optional<ColorRange>, kRangesOf> changed_;
};

// The numbers of a picture, sorted. With more than `most` of them every second is dropped, and again: what is counted
// is an estimate then.
class ValueSpread {
  public:
    static constexpr std::size_t kAll = ~std::size_t{0};
    explicit ValueSpread(std::size_t most = kAll) : most_(most) {}

    void add(float value);  // NaN is none
    void finish();          // before anything is asked for

    bool exact() const { return stride_ == 1; }
    bool empty() const { return added_ == 0; }
    std::int64_t count() const { return added_; }
    double least() const { return least_; }  // of all that were added
    double largest() const { return largest_; }
    double leastPositive() const { return leastPositive_; }  // of the absolute values; 0: all are 0
    double largestMagnitude() const;
    // The value (absolute value) that this share of them do not exceed.
    double quantile(double share) const;
    double magnitudeQuantile(double share) const;
    // How many are greater; how many lie in [from, to).
    std::int64_t above(double value) const;
    std::int64_t between(double from, double to) const;

  private:
    std::int64_t notBelow(double value) const;

    std::size_t most_;
    std::int64_t added_ = 0;
    std::int64_t stride_ = 1;
    double least_ = 0;
    double largest_ = 0;
    double leastPositive_ = 0;
    std::vector<float> values_;
};

struct ColorScale {
    double low = 0;  // of a two-sided one: absolute values, the smallest that a logarithmic one tells apart from 0
    double high = 1;
    bool logarithmic = false;
    bool twoSided = false;  // around 0, which lies in the middle
    std::optional<double> threshold;
    bool operator==(const ColorScale&) const = default;

    // On the colour map: 0 to 1 between the ends, less and more beyond them.
    double place(double value) const;
    double value(double place) const;
    // Not above the threshold: has the colour of these.
    bool under(double value) const { return threshold && (twoSided ? std::max(value, -value) : value) <= *threshold; }
};

// What "all values" means of a picture, and below what values nothing is told apart by a logarithmic scale; 0: the
// least that is not 0.
struct ScaleEnds {
    double low = 0;
    double high = 1;
    bool twoSided = false;
    double least = 0;
};
ColorScale colorScale(const ColorRange& range, const ValueSpread& spread, const ScaleEnds& ends);

}  // namespace reliefui
