// Why a pixel has its colour, as text or JSON: relief trace --why.
#pragma once

#include <string>

#include "rendering/pixel_history.h"

namespace relief::app {

// Returns the histories of several pixels as a JSON array.
std::string historiesJson(const std::vector<PixelHistory>& histories, const FrameRequest& request);

}  // namespace relief::app
