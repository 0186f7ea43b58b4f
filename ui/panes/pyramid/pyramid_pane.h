#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind pyramidPane();

}  // namespace reliefui
