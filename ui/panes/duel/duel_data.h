// Data of the duel pane: several methods, and another program's tracer, on the ray that is shown.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "panes/duel/duel_drawing.h"
#include "workspace/snapshot.h"

namespace reliefui {

struct Duel {
    std::shared_ptr<const Snapshot> snapshot;
    std::vector<relief::DuelRun> runs;  // the scenario's method first
    std::vector<relief::Judgement> judgements;
    relief::LockStep steps;
    relief::Hit exact;
    // Index of the run whose departure from the exact answer is shown: own(), or the first to depart if own() does not.
    std::optional<std::size_t> first;

    // Index of the run whose steps all panes show: the scenario's method, or another program's tracer.
    std::size_t own() const { return snapshot->trace.fromFile ? runs.size() - 1 : 0; }
    // The moment of this departure; std::nullopt if all runs agree with the exact answer.
    std::optional<std::size_t> firstMoment() const;
    DuelSource source() const;
    // The part of the ray needed to show that moment enlarged: lambda of the farthest relevant point; 0: the whole ray.
    double closeUp() const;
    // Returns true if all runs are within this lambda at this moment.
    bool within(double lambda, std::size_t moment) const;
};

// The methods that compete with the scenario's own: the compared ones or, if there are none and no other tracer either,
// one chosen by default.
std::vector<relief::MethodChoice> duelRivals(const relief::Scenario& scenario);

// Builds the maps that the methods need, which may take seconds. Throws Cancelled, InputError.
std::shared_ptr<const Duel> makeDuel(std::shared_ptr<const Snapshot> snapshot,
                                     const std::vector<relief::MethodChoice>& rivals, relief::Work& work);

}  // namespace reliefui
