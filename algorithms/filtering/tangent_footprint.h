// Pixels whose footprint can be filtered on a tangent plane. Where nothing is hidden and the surface is nearly planar,
// the sum over the visible surface is plain filtering with the Jacobian of that plane: with g the slopes and r = (a, b)
// the run of the view ray,
//
//     a point U from the hit is seen at J^-1 (U + (g . U) r) = J'^-1 U,   J' = J - r (g^T J) / (1 + r . g)
//
// and its area in the pixel, 1 + r . g, is constant. Both conditions are decided for the whole footprint by
// conservative bounds of heights and slopes, with a few lookups each.
#pragma once

#include "filtering/elliptical_options.h"
#include "filtering/height_bounds.h"
#include "mapping/footprint.h"
#include "relief/ray.h"

namespace relief {

// Pixels. A surface whose projection deviates from its plane by less counts as that plane.
inline constexpr double kPlanarSpread = 0.5;

struct TangentFootprint {
    bool planar = false;  // the surface equals its tangent plane to within kPlanarSpread
    bool clear = false;   // no point of the footprint is hidden
    Jacobian jacobian;    // if planar: of the tangent plane, texels of the height map
};

// Data that all pixels of a picture share. perColor: texels of the height map per texel of the colour picture.
struct TangentTools {
    const HeightBoundsMap& bounds;
    const HeightField& field;
    const EllipticalSettings& settings;
    glm::dvec2 perColor;
};

// Tests a pixel. j: Jacobian of the plane at the hit's height, texels of the height map. For surfaces that are not
// bilinear both conditions are false.
TangentFootprint tangentFootprint(const TangentTools& tools, const Jacobian& j, glm::dvec2 hit, const ViewRay& ray,
                                  double lambda);

}  // namespace relief
