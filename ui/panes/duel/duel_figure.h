// A moment of the duel as a figure.
#pragma once

#include "panes/duel/duel_data.h"
#include "panes/figure.h"

namespace reliefui {

// upTo: as DuelSource::upTo.
std::shared_ptr<const Figure> duelFigure(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const Duel> duel,
                                         const ProfileOptions& options, std::size_t moment, double upTo);
// Computes the duel at the scenario's step, which may take seconds. If this is the step of the first divergence, the
// figure shows it enlarged.
std::shared_ptr<const Figure> computedDuel(std::shared_ptr<const Snapshot> snapshot);

}  // namespace reliefui
