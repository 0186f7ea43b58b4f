// What a step takes as free because a map of distances or cones promises it: a sphere around a point of the ray, or a
// cone under one. Whether the surface keeps the promise is another matter: bodyRole().
#pragma once

#include <vector>

#include "painting/drawing.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

// lambda: of the point of the ray that the sphere is around, or that is over the cone's apex.
struct StepBody {
    enum class Kind : std::uint8_t { None, Sphere, Cone };
    Kind kind = Kind::None;
    double lambda = 0;
    double radius = 0;  // sphere: texels, in the metric (x, y, D z)
    double apex = 0;    // cone: height
    double slope = 0;   // cone: heights per texel of horizontal distance, away()
    double from = 0;    // cone: azimuths of (x, y) that it holds for, radians; all of them: 0 to 2 pi
    double to = 0;
    bool square = false;  // cone

    explicit operator bool() const { return kind != Kind::None; }
    // Whether the cone holds in that direction.
    bool holds(double x, double y) const;
    bool whole() const;
    // From the cone's axis to (x, y): the larger side where it is square.
    double away(double x, double y) const;
};
StepBody stepBody(const relief::Step& step);
// Role of the step's sphere or cone: Overshoot where the ray's first hit lies within it (Unset: not known).
Role bodyRole(const relief::Step& step, const relief::ViewRay& ray, const relief::Hit& exact);

// Whether the record's value is a height, which drawings can show as one; else a distance or a slope.
bool valueIsHeight(const relief::Step& step);

// Whether the record's place is a voxel; its heights (its sides: stepBox).
bool liesInVoxel(const relief::Step& step);
struct VoxelHeights {
    double low = 0;
    double high = 0;
};
VoxelHeights voxelHeights(const relief::Step& step);

}  // namespace reliefui
