// Explains the answers of a tracer by the way in which it searches along the ray, for one model of its conventions.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "measuring/diagnose/chords.h"
#include "measuring/diagnose/surface_match.h"
#include "relief/tracer.h"

namespace relief {

// What a ray shows. Right: the model predicts its answer, or the answers differ only because the ray barely touches the
// surface. Else the fault of the search that explains the answer; nothing: none does.
// sharp: the answer is predicted to the rounding of float.
struct RayVerdict {
    bool explained = false;
    std::optional<Fault> cause{};
    bool sharp = false;
};

// An explanation of all answers: the model, with its search, and the verdict on each ray. layers: of StairSteps and
// MissedSpike, the number of layers; 0 if it is not known. loose: found by the kind of the errors alone, not by
// predicting them.
struct Explanation {
    TracerModel model;
    std::vector<RayVerdict> rays;
    std::vector<ModelFault> searchFaults;
    bool loose = false;
};

// Largest error of a right answer, texels, and what barely touching means: the ray is nowhere deeper in the surface,
// heights.
inline constexpr double kRightTexels = 1.0 / 32;
inline constexpr double kTouchDepth = 2e-4;

// Returns true if an answer differs from the first hit only because the ray barely touches the surface that it passed,
// or leaves it nearly parallel. chords: solidChords() of the ray; run: by which errors are measured, texels.
bool barelyTouches(const HeightField& field, const ViewRay& ray, const std::vector<Chord>& chords, const Hit& answer,
                   double run);

// Returns the number of equal layers at which the answers lie, and by how much they lie behind them, lambda: the
// answers of a search without refinement. layers: 0 if they lie at none.
struct Lattice {
    int layers = 0;
    double phase = 0;
};
Lattice latticeOf(const AnsweredRays& given);

// counts: steps of each ray, empty if they were not recorded. kinds: of each ray, the fault that its recorded steps
// show; empty if there are none.
struct SearchEvidence {
    std::vector<std::uint32_t> counts;
    std::vector<std::optional<Fault>> kinds;
};

// Returns the possible explanations for the model's conventions; the first is that of an exact search. byShape: also
// the one by the kind of the errors, which takes longer. Throws Cancelled.
std::vector<Explanation> explanations(const AnsweredRays& given, const SearchEvidence& evidence,
                                      const TracerModel& model, bool byShape, ModelFields& fields, Work& work);

}  // namespace relief
