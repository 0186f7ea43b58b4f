#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind comparePane();

}  // namespace reliefui
