// What a scenario keeps of the panes' choices, as the panes and their figures take it, and back.
#pragma once

#include "views/figure.h"
#include "workspace/pane_states.h"

namespace reliefui {

PyramidOptions pyramidOptions(const PyramidPane& pane);
DistanceOptions distanceOptions(const DistancePane& pane);
DistancePane distancePane(const DistanceOptions& options);
RowsOptions rowsOptions(const RowsPane& pane);
RowsPane rowsPane(const RowsOptions& options);
// The other choices (a guess) stay.
void takeProfile(ProfileOptions& options, const ProfilePane& pane);

// A figure is drawn as its pane is looked at.
void takePanes(FigureRequest& request, const PaneStates& panes);

}  // namespace reliefui
