#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind chartsPane();

}  // namespace reliefui
