// The profile of a snapshot's ray: its source, and the figure.
#pragma once

#include <optional>

#include "panes/figure.h"
#include "panes/point_state.h"
#include "panes/profile/profile_drawing.h"
#include "panes/profile/profile_state.h"
#include "workspace/snapshot.h"

namespace reliefui {

ProfileSource profileSource(const Snapshot& snapshot);
// The other choices (a guess) stay.
void takeProfile(ProfileOptions& options, const ProfilePane& pane);

// point: whose distances are shown.
std::shared_ptr<const Figure> profileFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            const ProfileOptions& options, const std::optional<QueryPoint>& point);

}  // namespace reliefui
