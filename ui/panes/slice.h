// The relief cut along a view ray: the surface and the maxima of a pyramid's texels as functions of the descent lambda.
// Heights and cell borders come from the core; nothing is traced here.
//
// If the picture repeats, the ray continues from period to period; with border there is nothing outside the picture.
// Rays that cross more than kSliceCells cells are sampled instead of traversed.
#pragma once

#include <vector>

#include "painting/drawing.h"
#include "relief/methods/pyramid_walk.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

inline constexpr double kSliceCells = 60000;

// The visible part: lambda in [from, to], shown `columns` pixels wide; a height of 1 is `rows` pixels.
struct SliceRange {
    double from = 0;
    double to = 1;
    double columns = 1000;
    double rows = 300;
};

// x: lambda, ascending; y: height. A bilinear surface is quadratic in each cell and approximated to a quarter of a
// pixel; columns have vertical walls. thinned: contains only the lowest and highest height per pixel.
struct SurfaceLine {
    std::vector<Point> points;
    bool thinned = false;
};
SurfaceLine surfaceAlong(const relief::PyramidWalk& walk, const relief::ViewRay& ray, const SliceRange& range);

// A texel of a level that the ray crosses, in the form of a step, with its whole lambda interval, not only the part
// inside the range; value: its maximum. joined: represents several texels narrower than two pixels.
struct Plateau {
    relief::Step texel;
    bool joined = false;
};
// Returns an empty list if the ray crosses more than kSliceCells of them.
std::vector<Plateau> plateausAlong(const relief::PyramidWalk& walk, const relief::ViewRay& ray, int level,
                                   const SliceRange& range);

// Lambda at which the ray leaves the picture; 1 if it does not, 0 if it enters outside.
double lambdaInside(const relief::PyramidWalk& walk, const relief::ViewRay& ray);

// Height of the surface at lambda.
double surfaceAt(const relief::HeightField& field, const relief::ViewRay& ray, double lambda);

}  // namespace reliefui
