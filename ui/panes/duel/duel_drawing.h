// A duel in the profile: above the slice along the ray a track for each method, on which its steps lie where they are
// along the ray; in the slice where each stands now, and where each answers. What goes wrong first is marked.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "measuring/compare/duel.h"
#include "panes/profile/profile_drawing.h"

namespace reliefui {

// What is drawn; referred to, not copied.
struct DuelSource {
    ProfileSource profile;  // without steps; its hit is the farthest of all answers
    const std::vector<relief::DuelRun>* runs = nullptr;
    const std::vector<relief::Judgement>* judgements = nullptr;
    relief::Hit exact;
    std::optional<std::size_t> first;  // the run that departs first
    double upTo = 0;                   // lambda: the ray is shown as far as this, and a little more; 0: all of it

    std::size_t count() const { return runs == nullptr ? 0 : runs->size(); }
};

// The profile's frame with room for the tracks above it, and for their names at the left.
ProfileFrame duelFrame(const DuelSource& source, const ProfileOptions& options, double width, double height);

// moment: the step at which each run stands. Steps have ids of ItemKind::Step, their run as level.
Drawing duelMarks(const DuelSource& source, const ProfileFrame& frame, const std::vector<std::size_t>& moment);
Drawing duelLegend(const DuelSource& source, double width, relief::Language language);

// Where a step is marked: where the tracer was after it, lambda.
double duelPlace(const relief::Step& step);

// The sign of a run, beside its colour.
Shape runShape(std::size_t run);

}  // namespace reliefui
