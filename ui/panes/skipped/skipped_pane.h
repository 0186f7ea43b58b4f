#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind skippedPane();

}  // namespace reliefui
