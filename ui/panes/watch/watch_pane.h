#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind watchPane();

}  // namespace reliefui
