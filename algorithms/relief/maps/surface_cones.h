// Cones for the shaders of engines, which read one cone per texel and step from the surface below the ray, not from a
// cell: cone step mapping (Dummer 2006) made safe for the interpolated surface, as Ban et al. 2024 require.
#pragma once

#include "relief/height_field.h"
#include "relief/work.h"

namespace relief {

// Returns for each texel a slope (heights per texel) such that a cone of that slope or a steeper one, on
// any surface point whose height is interpolated from this texel among others, holds no part of the surface. A shader
// may therefore fetch the nearest slope, or interpolate the four around the point in any monotonic coding.
//
// field: bilinear surface (asserted); columns have walls, above which every cone of this kind holds surface.
// Bound: a cell's slope is the larger of the surface's steepest slope in the 3 x 3 cells around it and, over all cells
// q farther away, of (highest height of q - lowest of the cell) / distance, or the steepest slope within the square
// that holds both if that is less (the surface along the line between two points rises no steeper). A texel has the
// steepest of its four cells. Cost: a branch and bound over the pyramid of cells, as for the other cones; in parallel,
// with progress. Throws Cancelled.
FloatImage surfaceCones(const HeightField& field, Work& work);

}  // namespace relief
