// Mapping of values to positions on a colour map: linear or logarithmic, over all values, percentiles or chosen ends,
// with an optional threshold. ColorRange is the user's choice, ColorScale the mapping that results for one picture's
// values, ValueSpread the statistics of these values that ranges and histograms need.
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

// Pictures that have a colour range of their own: layers of the result, distance maps, cone maps, differences of
// either, pyramids, errors of compared pictures.
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
// Name in scenario files, e.g. "steps", "slope-difference".
const std::string& rangeName(RangeOf of);

enum class RangeEnds : std::uint8_t { All, Percentile, Own };

struct ColorRange {
    bool logarithmic = false;
    RangeEnds ends = RangeEnds::All;
    // Ends of the range: percentiles (0 to 100) or values, depending on `ends`; unused for RangeEnds::All. Two-sided
    // pictures use `high` only.
    double low = 0;
    double high = 1;
    std::optional<double> threshold;  // values up to it share one colour
    bool operator==(const ColorRange&) const = default;
};
// Default range, chosen so that a picture of this kind is readable without adjustment.
ColorRange standardRange(RangeOf of);

// The ranges of all pictures; a picture that the user has not changed has the standard range.
class ColorRanges {
  public:
    ColorRange of(RangeOf picture) const;
    bool changed(RangeOf picture) const;
    void set(RangeOf picture, const ColorRange& range);
    bool operator==(const ColorRanges&) const = default;

  private:
    std::array<std::optional<ColorRange>, kRangesOf> changed_;
};

// Sorted sample of a picture's values. When it would exceed `most` values, every second one is dropped, repeatedly;
// counts and quantiles are then estimates (exact() is false).
class ValueSpread {
  public:
    static constexpr std::size_t kAll = ~std::size_t{0};
    explicit ValueSpread(std::size_t most = kAll) : most_(most) {}

    void add(float value);  // NaN is ignored
    void finish();          // sorts; must be called before any query below

    bool exact() const { return stride_ == 1; }
    bool empty() const { return added_ == 0; }
    std::int64_t count() const { return added_; }
    double least() const { return least_; }  // over all values added, also those dropped from the sample
    double largest() const { return largest_; }
    double leastPositive() const { return leastPositive_; }  // smallest absolute value above 0; 0 if all are 0
    double largestMagnitude() const;
    // Value (or absolute value) that is not exceeded by this share, 0 to 1, of the values.
    double quantile(double share) const;
    double magnitudeQuantile(double share) const;
    // Number of values greater than `value`; number of values in [from, to).
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
    double low = 0;  // two-sided: smallest absolute value that a logarithmic scale distinguishes from 0
    double high = 1;
    bool logarithmic = false;
    bool twoSided = false;  // symmetric around 0, which lies in the middle
    std::optional<double> threshold;
    bool operator==(const ColorScale&) const = default;

    // Position on the colour map: 0 to 1 between the ends, below 0 or above 1 outside them.
    double place(double value) const;
    double value(double place) const;
    // Returns true if the value is not above the threshold and so has the threshold's common colour.
    bool under(double value) const { return threshold && (twoSided ? std::max(value, -value) : value) <= *threshold; }
};

// Range that RangeEnds::All stands for in a picture. least: smallest magnitude that a logarithmic scale distinguishes
// from 0; 0: the smallest positive magnitude present.
struct ScaleEnds {
    double low = 0;
    double high = 1;
    bool twoSided = false;
    double least = 0;
};
ColorScale colorScale(const ColorRange& range, const ValueSpread& spread, const ScaleEnds& ends);

}  // namespace reliefui
