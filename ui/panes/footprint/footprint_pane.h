#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind footprintPane();

}  // namespace reliefui
