// What is compared with the scenario's own method, filter, mapping or heights, and how the pictures are shown: a plain
// value. Names and options of the alternatives: variation.h.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "relief/describe.h"

namespace relief {

// Tiles: next to each other; Swipe: parts of one picture, with dividers; Flicker: alternating in one place; Difference:
// only the differences.
enum class CompareMode : std::uint8_t { Tiles, Swipe, Flicker, Difference };
// Measured on display colours. L1: mean of the channels' absolute differences; Flip: the differences that a viewer
// notices (flip.h).
enum class CompareMeasure : std::uint8_t { L1, Flip };
// In what the compared pictures differ; all else is taken from the scenario. Methods: with their options and maps;
// Filters: texture filters; Mappings: how coordinates are computed along rows; Heights: as read, or with fewer bits.
enum class CompareSubject : std::uint8_t { Methods, Filters, Mappings, Heights };
// Exact: the most accurate alternative of the subject (referenceVariation() in variation.h). MethodA: the scenario's
// own.
enum class CompareReference : std::uint8_t { Exact, MethodA };

inline constexpr std::size_t kMostCompared = 4;  // per subject, including the scenario's own

struct Comparison {
    CompareSubject subject = CompareSubject::Methods;
    std::vector<MethodChoice> others;  // methods B, C, D; A is the scenario's own. Also used by duels
    // The alternatives of the other subjects: names and options as in variation.h.
    std::vector<MethodChoice> filters, mappings, heights;
    CompareMode mode = CompareMode::Tiles;
    CompareMeasure measure = CompareMeasure::Flip;
    CompareReference reference = CompareReference::Exact;
    // between neighbouring pictures, in shares of the picture's width; empty: equal widths
    std::vector<double> dividers;
    double rate = 2;  // of flicker: pictures per second
    bool operator==(const Comparison&) const = default;
};

// The alternatives B, C, D of the comparison's subject.
const std::vector<MethodChoice>& othersOf(const Comparison& comparison);
std::vector<MethodChoice>& othersOf(Comparison& comparison);

inline constexpr double kSlowestFlicker = 0.2;
inline constexpr double kFastestFlicker = 20;

// The names: "methods", "filters", "mappings", "heights"; "tiles", "swipe", "flicker", "difference"; "l1", "flip";
// "exact", "A". Parsing throws InputError that lists the known names.
std::string_view compareSubjectName(CompareSubject subject);
CompareSubject parseCompareSubject(std::string_view text);
std::string_view compareModeName(CompareMode mode);
CompareMode parseCompareMode(std::string_view text);
std::string_view compareMeasureName(CompareMeasure measure);
CompareMeasure parseCompareMeasure(std::string_view text);
std::string_view compareReferenceName(CompareReference reference);
CompareReference parseCompareReference(std::string_view text);

// Throws InputError for values that are out of range, unknown, or too many.
void checkComparison(const Comparison& comparison, const std::string& subject);
// Returns the dividers in ascending order, one fewer than pictures: the given ones if their number is right, otherwise
// equally spaced ones.
std::vector<double> dividersOf(const Comparison& comparison);

}  // namespace relief
