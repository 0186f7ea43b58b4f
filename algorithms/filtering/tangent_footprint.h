// Where nothing hides anything under a pixel and the surface is nearly a plane, the sum over the visible surface is
// plain filtering with the Jacobian of that plane: with g the slopes, r = (a, b) the run of the view ray,
//
//     a point U from the hit is seen at J^-1 (U + (g . U) r) = J'^-1 U,   J' = J - r (g^T J) / (1 + r . g)
//
// and its area in the pixel, 1 + r . g, is the same everywhere. Both conditions are decided for the whole footprint by
// bounds of heights and slopes, conservative, a few lookups each.
#pragma once

#include "filtering/elliptical_options.h"
#include "filtering/height_bounds.h"
#include "mapping/footprint.h"
#include "relief/ray.h"

namespace relief {

// Pixels: a surface that leaves its plane by less, as it is seen, counts as that plane.
inline constexpr double kPlanarSpread = 0.5;

struct TangentFootprint {
    bool planar = false;  // the surface is its tangent plane, to kPlanarSpread
    bool clear = false;   // no point of the footprint is hidden
    Jacobian jacobian;    // planar: of the tangent plane, texels of the height map
};

// What all pixels of a picture share. perColor: texels of the height map per texel of the colour picture.
struct TangentTools {
    const HeightBoundsMap& bounds;
    const HeightField& field;
    const EllipticalSettings& settings;
    glm::dvec2 perColor;
};

// j: of the plane at the hit's height, texels of the height map. Bilinear surfaces; others are neither.
TangentFootprint tangentFootprint(const TangentTools& tools, const Jacobian& j, glm::dvec2 hit, const ViewRay& ray,
                                  double lambda);

}  // namespace relief
