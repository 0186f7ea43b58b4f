// The figure of the watched values.
#pragma once

#include "panes/figure.h"
#include "panes/watch/watch_state.h"
#include "workspace/snapshot.h"

namespace reliefui {

std::shared_ptr<const Figure> watchFigure(std::shared_ptr<const Snapshot> snapshot, int step, const WatchPane& pane);

}  // namespace reliefui
