#include <array>
#include <cmath>

#include "measuring/verify/stress_cases.h"

namespace relief {

namespace {

constexpr double kNarrowest = 1;  // degrees, limit of scenarios
constexpr double kWidest = 170;
constexpr double kCubeHalf = 0.5;  // world units

double logarithmic(Random& random, double low, double high) {
    return low * std::pow(high / low, random.unit());
}
double eitherSign(Random& random, double value) {
    return random.below(2) == 0 ? value : -value;
}
double fieldOfView(Random& random) {
    constexpr std::array<double, 3> kFields{40, 10, 100};
    return kFields[static_cast<std::size_t>(random.below(3))];
}
Camera orbit(double elevation, double azimuth, double distance, double fov) {
    Camera camera;
    camera.elevation = elevation;
    camera.azimuth = azimuth;
    camera.distance = distance;
    camera.fov = fov;
    return camera;
}
Camera freeCamera(const glm::dvec3& eye, const glm::dvec3& target, double fov) {
    Camera camera;
    camera.kind = Camera::Kind::Free;
    camera.eye = eye;
    camera.target = target;
    camera.fov = fov;
    return camera;
}

// Returns a point at distance `above` from the plane of the scene's first polygon, at (along, across) within it.
glm::dvec3 overPolygon(SceneKind scene, double above, double along, double across) {
    if (scene == SceneKind::Floor) return {along, above, across};
    return {along, across, (scene == SceneKind::Cube ? kCubeHalf : 0.0) + above};
}

Camera ordinary(SceneKind, Random& random) {
    const double elevation = random.between(5, 85);
    const double azimuth = random.between(-180, 180);
    const double distance = random.between(0.5, 4);
    return orbit(elevation, azimuth, distance, random.between(20, 90));
}

// The polygon is seen edge-on.
Camera inPlane(SceneKind scene, Random& random) {
    constexpr std::array<double, 5> kBeside{0, 1e-300, 1e-17, 1e-15, 1e-9};
    const double above = eitherSign(random, kBeside[static_cast<std::size_t>(random.below(5))]);
    const double along = random.between(-2, 2);
    const glm::dvec3 eye = overPolygon(scene, above, along, random.between(-2, 2));
    const glm::dvec3 target = overPolygon(scene, 0, 0, random.between(-0.1, 0.1));
    return freeCamera(eye, target, fieldOfView(random));
}

Camera grazing(SceneKind scene, Random& random) {
    const double above = logarithmic(random, 1e-6, 0.05);
    const double along = random.between(-2, 2);
    const glm::dvec3 eye = overPolygon(scene, above, along, random.between(-2, 2));
    const glm::dvec3 target = overPolygon(scene, 0, 0, random.between(-0.1, 0.1));
    return freeCamera(eye, target, fieldOfView(random));
}

// A camera close above the polygon and close to its target.
Camera near(SceneKind scene, Random& random) {
    const double along = random.between(-0.4, 0.4);
    const double across = random.between(-0.4, 0.4);
    const double distance = logarithmic(random, 1e-9, 1e-2);
    const glm::dvec3 eye = overPolygon(scene, distance, along, across);
    const double shift = distance * random.between(-1, 1);
    return freeCamera(eye, overPolygon(scene, 0, along + shift, across), fieldOfView(random));
}

Camera far(SceneKind scene, Random& random) {
    const double distance = logarithmic(random, 1e2, 1e9);
    const glm::dvec3 eye = overPolygon(scene, distance, distance * random.between(-2, 2), distance);
    return freeCamera(eye, {0, 0, 0}, random.below(2) == 0 ? kNarrowest : fieldOfView(random));
}

Camera straight(SceneKind, Random& random) {
    const double elevation = eitherSign(random, 90);
    const double azimuth = 90 * random.below(4);
    const double distance = random.between(0.2, 3);
    return orbit(elevation, azimuth, distance, fieldOfView(random));
}

Camera lens(SceneKind, Random& random) {
    const double elevation = random.between(1, 89);
    const double fov = random.below(2) == 0 ? kNarrowest : kWidest;
    const double azimuth = random.between(-180, 180);
    return orbit(elevation, azimuth, logarithmic(random, 0.05, 100), fov);
}

Camera onTarget(SceneKind scene, Random& random) {
    const double above = random.between(0, 1);
    const double along = random.between(-1, 1);
    const glm::dvec3 eye = overPolygon(scene, above, along, random.between(-1, 1));
    return freeCamera(eye, eye, fieldOfView(random));
}

}  // namespace

const std::vector<StressCameraFamily>& stressCameraFamilies() {
    static const std::vector<StressCameraFamily> families{
        {"ordinary", ordinary}, {"in-plane", inPlane},  {"grazing", grazing}, {"near", near},
        {"far", far},           {"straight", straight}, {"lens", lens},       {"on-target", onTarget, true},
    };
    return families;
}

}  // namespace relief
