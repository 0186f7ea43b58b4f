#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind shaderPane();

}  // namespace reliefui
