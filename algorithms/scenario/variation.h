// What a comparison sets beside the scenario: another method, filter, mapping or map of heights in the place of its
// own, by name and options. And which of them is worth being set against another one: never a thing against itself.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace relief {

// Of Heights: as the picture has them; rounded to whole units of 2^bits - 1.
inline constexpr const char* kAsRead = "as-read";
inline constexpr const char* kQuantised = "quantised";
inline constexpr const char* kBits = "bits";
// Of the filter `supersample`: FilterChoice::samples and pixelModel.
inline constexpr const char* kSamples = "samples";
inline constexpr const char* kPixelModel = "pixel-model";

// The scenario's own: tile A. Heights: kAsRead, whatever they are.
MethodChoice ownVariation(const Scenario& scenario, CompareSubject subject);
// A first, then the others, of the comparison's subject.
std::vector<MethodChoice> comparedOf(const Scenario& scenario);
// The scenario with this in the place of its own. Heights are no part of a scenario: it stays, variedHeights() has
// them.
Scenario varied(Scenario scenario, CompareSubject subject, const MethodChoice& choice);
// The heights themselves where they are as read. Throws InputError.
std::shared_ptr<const FloatImage> variedHeights(const std::shared_ptr<const FloatImage>& heights,
                                                const MethodChoice& choice);

// Names that a tile can have.
std::vector<std::string> variationNames(CompareSubject subject);
// Name, help, source, options and their defaults: what a form of controls is made from. Throws InputError for unknown
// names.
MethodDescription describedVariation(CompareSubject subject, const MethodChoice& choice);
// Throws InputError(where, ...) for unknown names and options, and values out of range.
void checkVariation(CompareSubject subject, const MethodChoice& choice, const std::string& where);
// "layers:layers=8": the name, and the options that differ from their defaults. Equal texts: the same thing.
std::string variationText(CompareSubject subject, const MethodChoice& choice);
bool sameVariation(CompareSubject subject, const MethodChoice& a, const MethodChoice& b);

// What errs least, against which the pictures are measured: the method exact; supersample, with at least kTruthSamples
// along each side of a pixel and no fewer than any that is compared; direct; as-read.
inline constexpr int kTruthSamples = 8;
MethodChoice referenceVariation(const Scenario& scenario);

// The next one that is worth being set beside those that are there: not there yet, and it knows the surface. Nothing
// where all are there.
std::optional<MethodChoice> nextVariation(const Scenario& scenario);
// The same name, with one option other than it stands in those that are there; nothing where there is no such option.
std::optional<MethodChoice> variedOption(const Scenario& scenario, const std::string& name);
// After a change by hand: where A took the name and options of another tile, that tile takes what A was before.
Scenario keptApart(const Scenario& before, Scenario after);

// Methods to be set against the scenario's on its rays: those compared that are not the same, find hits and know the
// surface. Where there is none: `exact`; where the scenario's own promises the exact hit, one that errs.
std::vector<MethodChoice> rivalsOf(const Scenario& scenario);
// The first of them that disagrees somewhere: not both promise the exact hit.
MethodChoice rivalOf(const Scenario& scenario);

}  // namespace relief
