// The camera: a pinhole, placed around the scene (elevation, azimuth, distance) or freely (eye, target).
//
// World frame: right-handed, y up, one unit = the width of the picture on its polygon; the scene is centred at the
// origin. Screen: x to the right, y downwards, pixel (i, j) has its centre at (i + 1/2, j + 1/2).
#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

// A camera; angles in degrees. Orbit: elevation above the horizontal plane through the target, -90 to 90; azimuth turns
// to the right around the vertical axis, 0 in front (on +z); distance from the target, world units, > 0. Free: eye and
// target in world units, which must differ. fov: vertical field of view, in (0, 180).
struct Camera {
    enum class Kind : std::uint8_t { Orbit, Free };
    Kind kind = Kind::Orbit;
    double elevation = 35;
    double azimuth = 20;
    double distance = 1.5;
    glm::dvec3 eye{0, 1, 1};
    glm::dvec3 target{0, 0, 0};
    double fov = 40;
    bool operator==(const Camera&) const = default;
};

// Returns the view ray of pixel (x, y) of a width x height picture of the relief on the floor; std::nullopt if the
// pixel does not see the floor polygon. Throws InputError if the camera is degenerate or the pixel is outside the
// picture.
std::optional<ViewRay> floorRay(const HeightField& field, const Camera& camera, int width, int height, int x, int y);

}  // namespace relief
