#pragma once

#include "panes/pane.h"

namespace reliefui {

PaneKind whyPane();

}  // namespace reliefui
