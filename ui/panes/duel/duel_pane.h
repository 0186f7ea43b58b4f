#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind duelPane();

}  // namespace reliefui
