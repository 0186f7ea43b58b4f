// Scenarios that show one ray, for the window and for relief render.
#pragma once

#include "relief/height_field.h"
#include "scenario/scenario.h"

namespace relief {

// Returns the scenario that reproduces the ray as its central pixel: the camera lies behind the ray's entry into the
// relief and looks along the ray. Rounding moves the pixel's ray by about 1e-13 of the picture.
Scenario witness(Scenario scenario, const HeightField& field, const ViewRay& ray);

}  // namespace relief
