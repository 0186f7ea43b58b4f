// The region that a step treats as empty, or as entered at most once, because of a distance or cone map: a sphere
// around a point of the ray, or a cone below one. bodyRole() tells whether the relief violates this guarantee.
#pragma once

#include <vector>

#include "painting/drawing.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

// lambda: ray parameter of the sphere's centre, or of the point above the cone's apex.
struct StepBody {
    enum class Kind : std::uint8_t { None, Sphere, Cone };
    Kind kind = Kind::None;
    double lambda = 0;
    double radius = 0;  // sphere: in texels, in the metric (x, y, D z)
    double apex = 0;    // cone: height of the apex
    double slope = 0;   // cone: height per texel of horizontal distance, see away()
    double from = 0;    // cone: range of azimuths of (x, y) in which it is valid, in radians; 0 to 2 pi for all
    double to = 0;
    bool square = false;   // cone
    bool relaxed = false;  // cone: not empty, but entered at most once
    bool refined = false;  // sphere: not empty, but without the first hit of any ray that reaches its centre

    explicit operator bool() const { return kind != Kind::None; }
    // Returns true if the cone is valid in that direction.
    bool holds(double x, double y) const;
    bool whole() const;
    // Horizontal distance of (x, y) from the cone's axis; the maximum norm if the cone is square.
    double away(double x, double y) const;
};
StepBody stepBody(const relief::Step& step);
// Role of the step's sphere or cone: Overshoot if the ray's first hit lies inside it. `exact` is Unset if the hit is
// not known.
Role bodyRole(const relief::Step& step, const relief::ViewRay& ray, const relief::Hit& exact);

// Returns true if the step's value is a height, which drawings can show as such; otherwise it is a distance or a slope.
bool valueIsHeight(const relief::Step& step);

// Returns true if the step's cell is a voxel. voxelHeights() gives its vertical extent, stepBox() its sides.
bool liesInVoxel(const relief::Step& step);
struct VoxelHeights {
    double low = 0;
    double high = 0;
};
VoxelHeights voxelHeights(const relief::Step& step);

}  // namespace reliefui
