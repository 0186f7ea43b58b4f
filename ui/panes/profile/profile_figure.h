// Input of a snapshot's profile, and its figure.
#pragma once

#include <optional>

#include "painting/annotation.h"
#include "panes/figure.h"
#include "panes/point_state.h"
#include "panes/profile/profile_drawing.h"
#include "panes/profile/profile_state.h"
#include "workspace/snapshot.h"

namespace reliefui {

ProfileSource profileSource(const Snapshot& snapshot);
// Takes over the pane's choices; the others (a guess) stay.
void takeProfile(ProfileOptions& options, const ProfilePane& pane);

// point: its distances are shown.
std::shared_ptr<const Figure> profileFigure(std::shared_ptr<const Snapshot> snapshot, int step,
                                            const ProfileOptions& options, const std::optional<QueryPoint>& point,
                                            const std::vector<Annotation>& notes);

// Where the data of the profile's annotations lie on its drawing.
AnnotationFrame profileAnnotations(const ProfileFrame& frame);

}  // namespace reliefui
