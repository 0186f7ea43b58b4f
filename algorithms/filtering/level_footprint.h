// From a pixel's Jacobian to the level of the mean pyramid on which its footprint is sampled, and the ellipse there.
//
// Source: [TEX] (the ellipse, the level by the minor axis). The covariance of texels follows Heckbert 1989, section
// 3.5, with the box average of the level subtracted and the bilinear reconstruction of level 0 added:
//
//     sigma^2 J J^T / 4^l + (1 / (4 4^l) - 1/12) I
//
// It keeps the axes' directions, so only the two semi-axes change.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include "filtering/color_levels.h"
#include "filtering/elliptical_options.h"
#include "mapping/footprint.h"

namespace relief {

// Ellipse: the weighted texels of an ellipse. Bilinear: the footprint is smaller than a texel. Shape: samples inside
// the pixel, each bilinear, because its texels are too few to represent its shape. Top: the mean of the whole picture.
enum class FootprintKind : std::uint8_t { Ellipse, Bilinear, Shape, Top };

struct LevelFootprint {
    FootprintKind kind = FootprintKind::Ellipse;
    int level = 0;
    glm::dvec2 centre{0};  // texels of the level, inside the picture under repeat
    Ellipse ellipse;       // of the circle of radius 1 pixel, texels of the level, widened if too thin
    Jacobian widened;      // a Jacobian with this ellipse and the pixel's orientation, texels of the level
    double radius = 1;     // pixels
    Jacobian seen;         // the pixel's Jacobian, texels of level 0
    double major = 1;      // semi-axes of the 1-pixel circle on level 0, texels, not widened
    double minor = 1;
};

// Limits of the major semi-axis of the 1-pixel circle on level 0, in texels. Longer ones than largestMajor are cut
// (they cover the whole picture several times); with a shorter one than bilinearMajor, level 0 is sampled bilinearly.
double largestMajor(int width, int height);
double bilinearMajor(const EllipticalSettings& settings);
// Term that accounts for the size of texels, added to the squares of the semi-axes on level l.
double texelVariance(int l, const EllipticalSettings& settings);

// Computes the footprint. j, centre: in texels of level 0. Values that are not finite, or huge, give the top of the
// pyramid.
LevelFootprint levelFootprint(const Jacobian& j, glm::dvec2 centre, const EllipticalSettings& settings,
                              const ColorLevels& levels, Address address);

}  // namespace relief
