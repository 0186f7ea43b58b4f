// Corrected relaxed cones: Ban, Valasek, Balint, Vad, Robust Cone Step Mapping (EGSR 2024).
#pragma once

#include "relief/height_field.h"
#include "relief/work.h"

namespace relief {

// Returns for each texel a slope (heights per texel): the steepest towards a falling edge, a texel at
// which the surface falls in one of the cells behind it as seen from the apex (a ray that touches it there may leave
// the surface again), within `radius` texels on each axis; then the steepest of 3 x 3 texels, for shaders that
// interpolate. Texels, not points between them, are compared, as published: not proven. In parallel, with progress;
// O(texels radius^2) at worst. Throws Cancelled.
FloatImage robustRelaxedCones(const HeightField& field, int radius, Work& work);

}  // namespace relief
