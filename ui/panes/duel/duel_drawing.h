// A duel in the profile: above the slice along the ray a track for each method, with its steps at their positions along
// the ray; in the slice the current position and the answer of each method. The first fault of each is marked.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "measuring/compare/duel.h"
#include "panes/profile/profile_drawing.h"

namespace reliefui {

// Input of the drawing; holds references, not copies.
struct DuelSource {
    ProfileSource profile;  // without steps; its hit is the farthest of all answers
    const std::vector<relief::DuelRun>* runs = nullptr;
    const std::vector<relief::Judgement>* judgements = nullptr;
    relief::Hit exact;
    std::optional<std::size_t> first;  // index of the run that departs first
    double upTo = 0;                   // lambda up to which, with a margin, the ray is shown; 0: the whole ray

    std::size_t count() const { return runs == nullptr ? 0 : runs->size(); }
};

// The profile's frame with room for the tracks above it and for their names at the left.
ProfileFrame duelFrame(const DuelSource& source, const ProfileOptions& options, double width, double height);

// moment: index of each run's current step. Steps have ids of ItemKind::Step with the run as level.
Drawing duelMarks(const DuelSource& source, const ProfileFrame& frame, const std::vector<std::size_t>& moment);
Drawing duelLegend(const DuelSource& source, double width, relief::Language language);

// Lambda at which a step is marked: the tracer's position after it.
double duelPlace(const relief::Step& step);

// Marker shape of a run, in addition to its colour.
Shape runShape(std::size_t run);

}  // namespace reliefui
