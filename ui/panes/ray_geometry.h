// Where a logged ray and the texels of its steps lie in the plane of the texture: shared by every pane that draws them.
// Unwrapped texel coordinates (s, t); under repeat counted from the period that the tracer started in.
#pragma once

#include <array>
#include <vector>

#include "painting/view_map.h"
#include "relief/cell_grid.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

// Texels (s, t, h), h = height times the slab's thickness D; s and t unwrapped.
using Place3 = std::array<double, 3>;

struct RayPath {
    Point start;  // at lambda = 0
    Point run;

    RayPath() = default;
    RayPath(const relief::HeightField& field, const relief::ViewRay& ray);
    Point at(double lambda) const { return {start.x + lambda * run.x, start.y + lambda * run.y}; }
};

// What a step is about, as seen from above: texel of a pyramid, cell, voxel, quad, or the texel that holds the point.
// Sides that have no end (clamp) are infinite.
// baseLevel: what the method traced instead of the heights; its texels need not be whole texels of the field.
Box stepBox(const relief::HeightField& field, const relief::Step& step, int baseLevel = 0);

// Lambda where the ray ends: its hit, or where the last of its steps left it.
double rayEnd(const relief::Hit& hit, const std::vector<relief::Step>* steps);

// What a pyramid's level 0 covers: the cells of the field, or its texels. Under clamp the outermost cells are drawn one
// texel wide.
Box cellDomain(const relief::HeightField& field);
Box texelDomain(const relief::HeightField& field);

// A stretch or a box as seen in one period. Where nothing repeats, what lies outside is cut off. Of a stretch of very
// many periods only both ends are given.
std::vector<Segment> wrapped(const Segment& segment, const Box& domain, bool wraps);
std::vector<Box> wrapped(const Box& box, const Box& domain, bool wraps);

// The first and the last period of a picture between two places; where nothing repeats, it is number 0.
std::pair<int, int> periodsSeen(double low, double high, double start, double period, bool wraps);

// The decisions that cover the ray without overlapping: what its stretches are coloured by.
bool coversStretch(relief::Decision decision);

}  // namespace reliefui
