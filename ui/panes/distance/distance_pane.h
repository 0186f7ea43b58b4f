#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind distancePane();

}  // namespace reliefui
