// The numbers behind the picture, of pixels of a view.
#pragma once

#include <optional>

#include "mapping/rows/coefficients.h"
#include "rendering/frame.h"

namespace relief {

// Of the nearest polygon's top plane at the pixel, texels of the height map; nothing where no polygon is seen. Throws
// InputError outside the picture.
std::optional<PixelCoefficients> pixelCoefficients(const FrameRequest& request, int x, int y);

}  // namespace relief
