#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind resultPane();

}  // namespace reliefui
