// Which methods are looked at beside the scenario's own, and how they are set against each other: a plain value.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "relief/describe.h"

namespace relief {

// Beside each other; parts of one picture, with dividers; one after the other in one place; differences only.
enum class CompareMode : std::uint8_t { Tiles, Swipe, Flicker, Difference };
// Of colours as a screen shows them: mean of the channels' absolute differences, or what a viewer notices (flip.h).
enum class CompareMeasure : std::uint8_t { L1, Flip };
// Exact: the same frame by `exact`. MethodA: the scenario's own method.
enum class CompareReference : std::uint8_t { Exact, MethodA };

inline constexpr std::size_t kMostCompared = 4;  // the scenario's own included

struct Comparison {
    std::vector<MethodChoice> others;  // B, C, D; A is the scenario's method
    CompareMode mode = CompareMode::Tiles;
    CompareMeasure measure = CompareMeasure::Flip;
    CompareReference reference = CompareReference::Exact;
    std::vector<double> dividers;  // between one method and the next, shares of the picture's width; empty: even
    double rate = 2;               // of flicker: pictures a second
    bool operator==(const Comparison&) const = default;
};

inline constexpr double kSlowestFlicker = 0.2;
inline constexpr double kFastestFlicker = 20;

// "tiles", "swipe", "flicker", "difference"; "l1", "flip"; "exact", "A". Parsing throws InputError with what is known.
std::string_view compareModeName(CompareMode mode);
CompareMode parseCompareMode(std::string_view text);
std::string_view compareMeasureName(CompareMeasure measure);
CompareMeasure parseCompareMeasure(std::string_view text);
std::string_view compareReferenceName(CompareReference reference);
CompareReference parseCompareReference(std::string_view text);

// Throws InputError for what is out of range, or unknown, or too many.
void checkComparison(const Comparison& comparison, const std::string& subject);
// Ascending, one fewer than methods: the given ones if they fit, else even ones.
std::vector<double> dividersOf(const Comparison& comparison);

}  // namespace relief
