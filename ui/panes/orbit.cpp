#include "panes/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenario/scenario.h"

namespace reliefui {

namespace {

// At the poles the azimuth would turn the picture on the spot.
constexpr double kHighest = 89.0;

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

relief::Camera turned(const relief::Camera& camera, double azimuth, double elevation) {
    relief::Camera orbit = asOrbit(camera);
    orbit.azimuth = rounded(std::remainder(orbit.azimuth + azimuth, 360.0), 0.01);
    orbit.elevation = rounded(std::clamp(orbit.elevation + elevation, -kHighest, kHighest), 0.01);
    return orbit;
}

relief::Camera moved(const relief::Camera& camera, double factor) {
    relief::Camera orbit = asOrbit(camera);
    const relief::OptionDescription& range = relief::scenarioNumber("distance").description;
    orbit.distance = std::clamp(rounded(orbit.distance * factor, 1e-4), range.low, range.high);
    return orbit;
}

}  // namespace reliefui
