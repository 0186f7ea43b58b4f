#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind rowsPane();

}  // namespace reliefui
