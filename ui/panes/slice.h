// The relief cut along a view ray: the surface and the maxima of a pyramid's texels as graphs over the descent lambda.
// Heights and borders are the core's own; nothing is traced here.
//
// Under repeat the ray runs on from period to period; under border there is nothing outside the picture. Longer
// stretches than kSliceCells cells are looked at in places instead of everywhere.
#pragma once

#include <vector>

#include "painting/drawing.h"
#include "relief/methods/pyramid_walk.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

inline constexpr double kSliceCells = 60000;

// What is looked at: lambda in [from, to], shown `columns` pixels wide; a height of 1 is `rows` pixels.
struct SliceRange {
    double from = 0;
    double to = 1;
    double columns = 1000;
    double rows = 300;
};

// x: lambda, ascending; y: height. A bilinear surface is quadratic in each cell, drawn to a quarter of a pixel; columns
// have walls. thinned: of each pixel only the lowest and the highest height.
struct SurfaceLine {
    std::vector<Point> points;
    bool thinned = false;
};
SurfaceLine surfaceAlong(const relief::PyramidWalk& walk, const relief::ViewRay& ray, const SliceRange& range);

// A texel of a level that the ray crosses, as a step would name it, over its whole stay, not only what of it is in the
// range; value: its maximum. joined: stands for several that are narrower than two pixels.
struct Plateau {
    relief::Step texel;
    bool joined = false;
};
// Empty if the ray crosses more than kSliceCells of them.
std::vector<Plateau> plateausAlong(const relief::PyramidWalk& walk, const relief::ViewRay& ray, int level,
                                   const SliceRange& range);

// Lambda at which the ray leaves the picture; 1 if it does not, 0 if it enters outside.
double lambdaInside(const relief::PyramidWalk& walk, const relief::ViewRay& ray);

// Height of the surface at lambda.
double surfaceAt(const relief::HeightField& field, const relief::ViewRay& ray, double lambda);

}  // namespace reliefui
