// What a scenario keeps of the panes' choices, as the panes and their figures take it, and back.
#pragma once

#include "scenario/pane_states.h"
#include "views/figure.h"

namespace reliefui {

PyramidOptions pyramidOptions(const relief::PyramidPane& pane);
DistanceOptions distanceOptions(const relief::DistancePane& pane);
relief::DistancePane distancePane(const DistanceOptions& options);
RowsOptions rowsOptions(const relief::RowsPane& pane);
relief::RowsPane rowsPane(const RowsOptions& options);
// The other choices (a guess) stay.
void takeProfile(ProfileOptions& options, const relief::ProfilePane& pane);

// A figure is drawn as its pane is looked at.
void takePanes(FigureRequest& request, const relief::PaneStates& panes);

}  // namespace reliefui
