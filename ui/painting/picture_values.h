// Pictures as cells of a drawing.
#pragma once

#include <memory>

#include "relief/image.h"

namespace reliefui {

// Returns the colours as a screen shows them, encoded as ColorMap::Picture has them.
std::shared_ptr<const relief::FloatImage> pictureValues(const relief::ColorImage& picture);

}  // namespace reliefui
