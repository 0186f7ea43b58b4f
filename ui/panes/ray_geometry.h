// Positions of a logged ray and of its steps' texels in the texture plane, for all panes that draw them. Texel
// coordinates (s, t) are unwrapped; if the picture repeats, they are relative to the period in which the tracer
// started.
#pragma once

#include <array>
#include <vector>

#include "painting/view_map.h"
#include "relief/cell_grid.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

// (s, t, h) in texels, h = height times the slab's thickness D; s and t are unwrapped.
using Place3 = std::array<double, 3>;

struct RayPath {
    Point start;  // at lambda = 0
    Point run;

    RayPath() = default;
    RayPath(const relief::HeightField& field, const relief::ViewRay& ray);
    Point at(double lambda) const { return {start.x + lambda * run.x, start.y + lambda * run.y}; }
};

// Horizontal extent of what a step examines: texel of a pyramid, cell, voxel, quad, or the texel that contains the
// point. Unbounded sides (clamp) are infinite. baseLevel: level that the method traced instead of the heights; its
// texels need not coincide with whole texels of the field.
Box stepBox(const relief::HeightField& field, const relief::Step& step, int baseLevel = 0);

// Lambda at the end of the ray: its hit, or the end of its last step.
double rayEnd(const relief::Hit& hit, const std::vector<relief::Step>* steps);

// Extent of a pyramid's level 0: the cells of the field, or its texels. With clamp, the outermost cells are drawn one
// texel wide.
Box cellDomain(const relief::HeightField& field);
Box texelDomain(const relief::HeightField& field);

// Splits a segment or a box into its pieces within one period. If nothing repeats, the part outside is cut off. For a
// segment of very many periods, only the pieces near both ends are returned.
std::vector<Segment> wrapped(const Segment& segment, const Box& domain, bool wraps);
std::vector<Box> wrapped(const Box& box, const Box& domain, bool wraps);

// Indices of the first and last period between two places; {0, 0} if nothing repeats.
std::pair<int, int> periodsSeen(double low, double high, double start, double period, bool wraps);

// Returns true for decisions whose intervals cover the ray without overlap; the ray is coloured by these.
bool coversStretch(relief::Decision decision);

}  // namespace reliefui
