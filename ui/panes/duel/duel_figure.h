// A moment of the duel as a figure.
#pragma once

#include "panes/duel/duel_data.h"
#include "panes/figure.h"

namespace reliefui {

// upTo: as DuelSource::upTo.
std::shared_ptr<const Figure> duelFigure(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const Duel> duel,
                                         const ProfileOptions& options, std::size_t moment, double upTo);
// Computed now, at the scenario's step; from near where that is the one of the first divergence. May take seconds.
std::shared_ptr<const Figure> computedDuel(std::shared_ptr<const Snapshot> snapshot);

}  // namespace reliefui
