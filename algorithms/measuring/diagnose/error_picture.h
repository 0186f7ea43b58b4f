// Pictures of a tracer's errors.
#pragma once

#include <vector>

#include "relief/height_field.h"
#include "relief/image.h"
#include "relief/ray.h"
#include "scenario/scenario.h"

namespace relief {

// Returns the colour of an error, texels: grey up to kRightTexels, then from blue over green and yellow to red, on a
// logarithmic scale up to 64 texels; magenta for an infinite error, that is another outcome.
Color errorColor(double texels);

// Returns the picture of a view of width x height pixels. pixels: that of each ray. Pixels without a ray are black.
ColorImage errorPicture(int width, int height, const std::vector<PixelChoice>& pixels,
                        const std::vector<float>& errors);
// Returns the texel at which a ray enters.
PixelChoice entryTexel(const HeightField& field, const ViewRay& ray);
// Returns the map, dark, with the largest error of the rays that enter at each texel.
ColorImage errorPicture(const HeightField& field, const RayBlock& rays, const std::vector<float>& errors);

}  // namespace relief
