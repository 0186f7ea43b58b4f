// What the duel pane shows: several methods, and somebody else's tracer, on the ray that is looked at.
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
    std::optional<std::size_t> first;  // the run that departs first

    // The moment at which it does; nothing if all answer as exact does.
    std::optional<std::size_t> firstMoment() const;
    DuelSource source() const;
    // How much of the ray shows that moment from near: lambda of the farthest of what matters at it; 0: all of it.
    double closeUp() const;
    // Whether at this moment all stand within it.
    bool within(double lambda, std::size_t moment) const;
};

// The methods that are set against the scenario's own: those compared; where there are none, and no other tracer
// either, one that is worth it.
std::vector<relief::MethodChoice> duelRivals(const relief::Scenario& scenario);

// Builds the maps that the methods need: may take seconds. Throws Cancelled, InputError.
std::shared_ptr<const Duel> makeDuel(std::shared_ptr<const Snapshot> snapshot,
                                     const std::vector<relief::MethodChoice>& rivals, relief::Work& work);

}  // namespace reliefui
