#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind drawnPane();

}  // namespace reliefui
