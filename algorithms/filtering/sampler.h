// Colour of the texture at a point of it: nearest and bilinear.
#pragma once

#include "relief/addressing.h"
#include "relief/image.h"

namespace relief {

// Linear colour at (s, t) in texels of `image`, unwrapped; texel (i, j) centred at (i + 1/2, j + 1/2).
Color sampleNearest(const ColorImage& image, double s, double t, Address address);
Color sampleBilinear(const ColorImage& image, double s, double t, Address address);

}  // namespace relief
