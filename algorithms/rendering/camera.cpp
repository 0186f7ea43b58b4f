#include "rendering/pinhole.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "relief/errors.h"

namespace relief {

namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

[[noreturn]] void refuse(MessageValue what, double value, Message range) {
    throw InputError("--camera",
                     Message(MessageId::OutOfRange, {std::move(what), {"value", value}, {"range", std::move(range)}}));
}

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Right and forward are computed without dividing by the horizontal part of the view direction, and up follows from
// them; straight down is therefore no special case.
void placeInOrbit(const Camera& camera, PinholeCamera& pinhole) {
    if (!(camera.elevation >= -90 && camera.elevation <= 90)) {
        refuse({"what", "elevation"}, camera.elevation,
               Message(MessageId::RangeOfUnit, {{"low", -90}, {"high", 90}, {"unit", MessageId::UnitDegrees}}));
    }
    if (!std::isfinite(camera.azimuth))
        refuse({"what", "azimuth"}, camera.azimuth, Message(MessageId::RangeFiniteDegrees));
    if (!(camera.distance > 0 && camera.distance < 1e6))
        refuse({"what", "distance"}, camera.distance, Message(MessageId::RangeDistance));
    if (!finite(camera.target)) refuse({"what", "target"}, camera.target.x, Message(MessageId::RangeFinite));
    const double elevation = camera.elevation * kRadians;
    const double azimuth = camera.azimuth * kRadians;
    const glm::dvec3 outward{std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                             std::cos(elevation) * std::cos(azimuth)};
    pinhole.eye = camera.target + camera.distance * outward;
    pinhole.forward = -outward;
    pinhole.right = {std::cos(azimuth), 0, -std::sin(azimuth)};
    pinhole.up = glm::cross(pinhole.right, pinhole.forward);
}

void placeFreely(const Camera& camera, PinholeCamera& pinhole) {
    const glm::dvec3 view = camera.target - camera.eye;
    const double length = glm::length(view);
    if (!finite(camera.eye) || !finite(camera.target) || !std::isfinite(length) || length < 1e-9) {
        refuse({"what", MessageId::WordEyeDistance}, length, Message(MessageId::RangeEyeDistance));
    }
    pinhole.eye = camera.eye;
    pinhole.forward = view / length;
    const glm::dvec3 side = glm::cross(pinhole.forward, glm::dvec3{0, 1, 0});
    // Straight up or down: oriented as an orbit of azimuth 0.
    pinhole.right = glm::length(side) < 1e-12 ? glm::dvec3{1, 0, 0} : glm::normalize(side);
    pinhole.up = glm::cross(pinhole.right, pinhole.forward);
}

}  // namespace

PinholeCamera pinholeCamera(const Camera& camera, int width, int height) {
    if (!(camera.fov > 0 && camera.fov < 180)) refuse({"what", "fov"}, camera.fov, Message(MessageId::RangeFov));
    PinholeCamera pinhole;
    if (camera.kind == Camera::Kind::Orbit) {
        placeInOrbit(camera, pinhole);
    } else {
        placeFreely(camera, pinhole);
    }
    const double focal = 0.5 * height / std::tan(0.5 * camera.fov * kRadians);
    pinhole.focal = {focal, focal};
    pinhole.principal = {0.5 * width, 0.5 * height};
    return pinhole;
}

}  // namespace relief
