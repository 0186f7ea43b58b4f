// Explains the answers of a tracer by the way in which it searches along the ray, for one model of its conventions.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "measuring/diagnose/chords.h"
#include "measuring/diagnose/lattice.h"
#include "measuring/diagnose/tracer_model.h"
#include "relief/tracer.h"

namespace relief {

// What a ray shows. Right: the model predicts its answer, or the answers differ only because the ray barely touches the
// surface. Otherwise the fault of the search that explains the answer; std::nullopt if none does. sharp: the answer is
// predicted to the rounding of float.
struct RayVerdict {
    bool explained = false;
    std::optional<Fault> cause{};
    bool sharp = false;
};

// An explanation of all answers: the model, with its search, and the verdict on each ray. searchFaults: their values
// are the number of layers; 0 if it is not known. loose: found by the kind of the errors alone, not by predicting them.
struct Explanation {
    TracerModel model;
    std::vector<RayVerdict> rays;
    std::vector<ModelFault> searchFaults;
    bool loose = false;
};

// counts: steps of each ray, empty if they were not recorded. kinds: of each ray, the fault that its recorded steps
// show; empty if there are none. lattice: latticeOf() the rays.
struct SearchEvidence {
    Lattice lattice;
    std::vector<std::uint32_t> counts;
    std::vector<std::optional<Fault>> kinds;
};

// Returns the possible explanations for the model's conventions; the first is that of an exact search. byShape: also
// the one by the kind of the errors, which takes longer. Throws Cancelled.
std::vector<Explanation> explanations(const AnsweredRays& given, const SearchEvidence& evidence,
                                      const TracerModel& model, bool byShape, ModelFields& fields, Work& work);
// Returns the explanation by the model with its search, which predicts the answers.
Explanation explanationBy(const AnsweredRays& given, const SearchEvidence& evidence, const TracerModel& model,
                          ModelFields& fields, Work& work);

}  // namespace relief
