#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind formulaPane();

}  // namespace reliefui
