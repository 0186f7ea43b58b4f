// From a pixel's Jacobian to the level of the mean pyramid on which its footprint is read, and the ellipse there.
//
// Source: [TEX] (the ellipse, the level by the minor axis); the covariance of texels: Heckbert 1989 section 3.5, with
// the level's box average taken off and level 0's bilinear reconstruction put on:
//
//     sigma^2 J J^T / 4^l + (1 / (4 4^l) - 1/12) I
//
// which keeps the axes' directions, so only the two semi-axes change.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include "filtering/color_levels.h"
#include "filtering/elliptical_options.h"
#include "mapping/footprint.h"

namespace relief {

// Ellipse: the weighted texels of an ellipse. Bilinear: the footprint is smaller than a texel. Shape: places of the
// pixel, each read bilinearly (its texels are too few to carry the shape). Top: the mean of the whole picture.
enum class FootprintKind : std::uint8_t { Ellipse, Bilinear, Shape, Top };

struct LevelFootprint {
    FootprintKind kind = FootprintKind::Ellipse;
    int level = 0;
    glm::dvec2 centre{0};  // texels of the level, within the picture under repeat
    Ellipse ellipse;       // of the circle of radius 1 pixel, texels of the level, widened where too thin
    Jacobian widened;      // a Jacobian with this ellipse and the pixel's orientation, texels of the level
    double radius = 1;     // pixels
    Jacobian seen;         // what it is made of, texels of level 0
    double major = 1;      // semi-axes of the 1-pixel circle on level 0, texels, as seen
    double minor = 1;
};

// Semi-axes of the 1-pixel circle on level 0, texels: longer than the first are cut (they see the whole picture, again
// and again); where the major one is below the second, level 0 is read bilinearly.
double largestMajor(int width, int height);
double bilinearMajor(const EllipticalSettings& settings);
// What the size of texels adds to the squares of the semi-axes on level l.
double texelVariance(int l, const EllipticalSettings& settings);

// j, centre: in texels of level 0; not finite, or huge: the top of the pyramid.
LevelFootprint levelFootprint(const Jacobian& j, glm::dvec2 centre, const EllipticalSettings& settings,
                              const ColorLevels& levels, Address address);

}  // namespace relief
