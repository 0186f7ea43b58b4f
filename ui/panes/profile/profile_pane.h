#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind profilePane();

}  // namespace reliefui
