#include "panes/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenario/scenario.h"

namespace reliefui {

namespace {

// Largest elevation in degrees: at the poles, a change of azimuth would rotate the picture in place.
constexpr double kHighest = 89.0;
// Largest angle, in degrees, from the middle of the visible side of a plane.
constexpr double kPlane = 90.0;

double rounded(double value, double unit) {
    return std::round(value / unit) * unit;
}

}  // namespace

relief::Camera asOrbit(const relief::Camera& camera) {
    if (camera.kind == relief::Camera::Kind::Orbit) return camera;
    relief::Camera orbit = camera;
    const glm::dvec3 outward = camera.eye - camera.target;
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    orbit.kind = relief::Camera::Kind::Orbit;
    orbit.distance = glm::length(outward);
    orbit.azimuth = std::atan2(outward.x, outward.z) * kDegrees;
    orbit.elevation = std::asin(std::clamp(outward.y / orbit.distance, -1.0, 1.0)) * kDegrees;
    return orbit;
}

relief::Camera turned(const relief::Camera& camera, double azimuth, double elevation, relief::SceneKind scene) {
    relief::Camera orbit = asOrbit(camera);
    const bool wall = scene == relief::SceneKind::Wall && std::abs(orbit.azimuth) < kPlane;
    const bool floor = scene == relief::SceneKind::Floor && orbit.elevation > 0;
    const double around = orbit.azimuth + azimuth;
    orbit.azimuth = wall ? std::clamp(around, -kHighest, kHighest) : std::remainder(around, 360.0);
    orbit.azimuth = rounded(orbit.azimuth, 0.01);
    const double lowest = floor ? std::min(kPlane - kHighest, orbit.elevation) : -kHighest;
    orbit.elevation = rounded(std::clamp(orbit.elevation + elevation, lowest, kHighest), 0.01);
    return orbit;
}

relief::Camera moved(const relief::Camera& camera, double factor) {
    relief::Camera orbit = asOrbit(camera);
    const relief::OptionDescription& range = relief::scenarioNumber("distance").description;
    orbit.distance = std::clamp(rounded(orbit.distance * factor, 1e-4), range.low, range.high);
    return orbit;
}

}  // namespace reliefui
