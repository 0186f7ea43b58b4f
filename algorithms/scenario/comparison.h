// What is looked at beside the scenario's own method, filter, mapping or heights, and how the pictures are set against
// each other: a plain value. What stands for what: variation.h.
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
// What the compared pictures differ in; all else is the scenario's. Methods with their options and maps; texture
// filters; ways of making coordinates along rows; the heights as they were read or with fewer bits.
enum class CompareSubject : std::uint8_t { Methods, Filters, Mappings, Heights };
// Exact: what errs least of the subject (referenceVariation() in variation.h). MethodA: the scenario's own.
enum class CompareReference : std::uint8_t { Exact, MethodA };

inline constexpr std::size_t kMostCompared = 4;  // of a subject, the scenario's own included

struct Comparison {
    CompareSubject subject = CompareSubject::Methods;
    std::vector<MethodChoice> others;  // methods B, C, D; A is the scenario's. A duel has the same
    // The same of the other subjects: names and options as variation.h has them.
    std::vector<MethodChoice> filters, mappings, heights;
    CompareMode mode = CompareMode::Tiles;
    CompareMeasure measure = CompareMeasure::Flip;
    CompareReference reference = CompareReference::Exact;
    std::vector<double> dividers;  // between one picture and the next, shares of the picture's width; empty: even
    double rate = 2;               // of flicker: pictures a second
    bool operator==(const Comparison&) const = default;
};

// Those of the comparison's subject: B, C, D.
const std::vector<MethodChoice>& othersOf(const Comparison& comparison);
std::vector<MethodChoice>& othersOf(Comparison& comparison);

inline constexpr double kSlowestFlicker = 0.2;
inline constexpr double kFastestFlicker = 20;

// "methods", "filters", "mappings", "heights"; "tiles", "swipe", "flicker", "difference"; "l1", "flip"; "exact", "A".
// Parsing throws InputError with what is known.
std::string_view compareSubjectName(CompareSubject subject);
CompareSubject parseCompareSubject(std::string_view text);
std::string_view compareModeName(CompareMode mode);
CompareMode parseCompareMode(std::string_view text);
std::string_view compareMeasureName(CompareMeasure measure);
CompareMeasure parseCompareMeasure(std::string_view text);
std::string_view compareReferenceName(CompareReference reference);
CompareReference parseCompareReference(std::string_view text);

// Throws InputError for what is out of range, or unknown, or too many.
void checkComparison(const Comparison& comparison, const std::string& subject);
// Ascending, one fewer than pictures: the given ones if they fit, else even ones.
std::vector<double> dividersOf(const Comparison& comparison);

}  // namespace relief
