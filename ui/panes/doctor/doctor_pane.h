#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind doctorPane();

}  // namespace reliefui
