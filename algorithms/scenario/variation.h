// The alternatives of a comparison, by name and options: another method, filter, mapping or quantisation of the heights
// in place of the scenario's own. Also proposes alternatives that differ from those already compared.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace relief {

// Names for Heights: as read from the picture; quantised: rounded to multiples of 1 / (2^bits - 1).
inline constexpr const char* kAsRead = "as-read";
inline constexpr const char* kQuantised = "quantised";
inline constexpr const char* kBits = "bits";
// Options for the filter `supersample`: FilterChoice::samples and pixelModel.
inline constexpr const char* kSamples = "samples";
inline constexpr const char* kPixelModel = "pixel-model";

// Returns the scenario's own choice, tile A. For Heights always kAsRead.
MethodChoice ownVariation(const Scenario& scenario, CompareSubject subject);
// Returns A and then the others, for the comparison's subject.
std::vector<MethodChoice> comparedOf(const Scenario& scenario);
// Returns the scenario with this choice in place of its own. Heights are not part of a scenario, which is then returned
// unchanged; see variedHeights().
Scenario varied(Scenario scenario, CompareSubject subject, const MethodChoice& choice);
// Returns the quantised heights, or for kAsRead the given pointer. Throws InputError.
std::shared_ptr<const FloatImage> variedHeights(const std::shared_ptr<const FloatImage>& heights,
                                                const MethodChoice& choice);

// Returns the names that a tile can have.
std::vector<std::string> variationNames(CompareSubject subject);
// Returns name, help, source, options and their defaults, from which forms of controls are made. Throws InputError for
// unknown names.
MethodDescription describedVariation(CompareSubject subject, const MethodChoice& choice);
// Throws InputError(where, ...) for unknown names and options, and values out of range.
void checkVariation(CompareSubject subject, const MethodChoice& choice, const std::string& where);
// Returns "layers:layers=8": the name, and the options that differ from their defaults. Choices with equal texts are
// equal.
std::string variationText(CompareSubject subject, const MethodChoice& choice);
bool sameVariation(CompareSubject subject, const MethodChoice& a, const MethodChoice& b);

// Returns the most accurate alternative, relative to which the pictures are measured: the method exact; supersample,
// with at least kTruthSamples along each side of a pixel and no fewer than any compared alternative; direct; as-read.
inline constexpr int kTruthSamples = 8;
MethodChoice referenceVariation(const Scenario& scenario);

// Returns the next proposal that is not compared yet and supports the surface; std::nullopt if there is none.
std::optional<MethodChoice> nextVariation(const Scenario& scenario);
// Returns the alternative of this name that differs in one option from those already compared; std::nullopt if there is
// none.
std::optional<MethodChoice> variedOption(const Scenario& scenario, const std::string& name);
// Resolves a conflict after a manual change: if A took the name and options of another tile, that tile gets A's former
// choice.
Scenario keptApart(const Scenario& before, Scenario after);

// Returns the methods to compare with the scenario's on its rays: the compared ones that differ from it, find hits and
// support the surface. If there are none: `exact`, or an approximate method if the scenario's own method is exact.
std::vector<MethodChoice> rivalsOf(const Scenario& scenario);
// Returns the first of them that can disagree with the scenario's method, which excludes two exact methods.
MethodChoice rivalOf(const Scenario& scenario);

}  // namespace relief
