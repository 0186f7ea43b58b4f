#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind tracePane();

}  // namespace reliefui
