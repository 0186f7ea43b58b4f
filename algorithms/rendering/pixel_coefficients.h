// The coefficients of the screen-to-texture mapping at single pixels of a view.
#pragma once

#include <optional>

#include "mapping/rows/coefficients.h"
#include "rendering/frame.h"

namespace relief {

// Returns the coefficients of the nearest polygon's top plane at the pixel, in texels of the height map; std::nullopt
// if no polygon covers the pixel. Throws InputError for pixels outside the picture.
std::optional<PixelCoefficients> pixelCoefficients(const FrameRequest& request, int x, int y);

}  // namespace relief
