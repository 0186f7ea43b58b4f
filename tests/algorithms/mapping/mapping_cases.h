// Seeded cameras and planes for the tests of algorithms/mapping.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "mapping/clipping.h"
#include "mapping/homography.h"
#include "relief/errors.h"

namespace relief::test {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
    glm::dvec2 point(double low, double high) {
        const double x = real(low, high);
        return {x, real(low, high)};
    }
    glm::dvec3 direction() {
        const double z = real(-1.0, 1.0);
        const double angle = real(0.0, 2.0 * std::numbers::pi);
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

  private:
    std::mt19937_64 engine_;
};

// Returns a right-handed camera frame with direction `forward`, rotated about it by roll.
inline PinholeCamera lookAlong(const glm::dvec3& eye, const glm::dvec3& forward, double roll) {
    PinholeCamera camera;
    camera.eye = eye;
    camera.forward = glm::normalize(forward);
    const glm::dvec3 helper = std::abs(camera.forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 side = glm::normalize(glm::cross(camera.forward, helper));
    const glm::dvec3 top = glm::cross(side, camera.forward);
    camera.right = std::cos(roll) * side + std::sin(roll) * top;
    camera.up = glm::cross(camera.right, camera.forward);
    return camera;
}

// A picture of W x H texels on a plane, and a camera that sees it.
struct View {
    PinholeCamera camera;
    TexturedPlane plane;
    double width = 1.0;   // texels
    double height = 1.0;  // texels

    std::array<glm::dvec2, 4> texelCorners() const {
        return {glm::dvec2(0, 0), glm::dvec2(width, 0), glm::dvec2(width, height), glm::dvec2(0, height)};
    }
    // Returns the pixel positions of the picture's corners, all of which must be in front of the eye.
    std::array<glm::dvec2, 4> screenCorners() const {
        std::array<glm::dvec2, 4> corners{};
        const auto texels = texelCorners();
        for (std::size_t k = 0; k < 4; ++k) {
            const glm::dvec3 p = camera.project(plane.at(texels[k].x, texels[k].y));
            corners[k] = {p.x / p.z, p.y / p.z};
        }
        return corners;
    }
};

// Returns a parallelogram of any size, shape and position, and a camera at any position on either side, directed
// approximately at it.
inline View randomView(Random& random) {
    View view;
    view.width = std::floor(std::exp2(random.real(0.0, 13.0)));
    view.height = std::floor(std::exp2(random.real(0.0, 13.0)));
    const double size = std::exp2(random.real(-6.0, 6.0));
    const glm::dvec3 a = random.direction();
    glm::dvec3 b = random.direction();
    while (glm::length(glm::cross(a, b)) < 0.3) b = random.direction();
    view.plane.perS = a * (size / view.width);
    view.plane.perT = b * (size * random.real(0.3, 1.0) / view.height);
    view.plane.origin = size * random.real(0.0, 3.0) * random.direction();
    const glm::dvec3 eye = view.plane.origin + size * random.real(0.2, 5.0) * random.direction();
    const glm::dvec3 target = view.plane.at(view.width * random.real(-0.2, 1.2), view.height * random.real(-0.2, 1.2));
    view.camera = lookAlong(eye, target - eye, random.real(0.0, 6.28));
    view.camera.focal = {random.real(300.0, 2000.0), random.real(300.0, 2000.0)};
    view.camera.principal = {random.real(100.0, 2000.0), random.real(100.0, 1000.0)};
    return view;
}

using Corners = std::array<glm::dvec2, 4>;

inline const Corners kSquare{glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)};

// Returns a strictly convex quad whose corners lie on an ellipse at well separated angles, in either orientation.
inline Corners randomConvexQuad(Random& random, double size, const glm::dvec2& centre) {
    const double turn = random.real(0.0, 2.0 * std::numbers::pi);
    const bool mirrored = random.whole(0, 1) == 1;
    const double flat = random.real(0.2, 1.0);
    Corners corners{};
    for (std::size_t k = 0; k < 4; ++k) {
        const double angle =
            turn + (static_cast<double>(k) + random.real(-0.35, 0.35)) * 0.5 * std::numbers::pi * (mirrored ? -1 : 1);
        corners[k] = centre + size * glm::dvec2(std::cos(angle), flat * std::sin(angle));
    }
    return corners;
}

inline glm::dvec2 inside(const Corners& c, double a, double b) {
    return (1 - b) * ((1 - a) * c[0] + a * c[1]) + b * ((1 - a) * c[3] + a * c[2]);
}

inline double areaOf(const Corners& c) {
    const glm::dvec2 d1 = c[2] - c[0];
    const glm::dvec2 d2 = c[3] - c[1];
    return 0.5 * (d1.x * d2.y - d1.y * d2.x);
}

// Returns the message of the error that `call` throws; Count if it throws none.
inline MessageId failureOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const InputError& error) {
        for (const Language language : {Language::English, Language::Ukrainian}) {
            const std::string text = error.text(language);
            EXPECT_EQ(text.find('\n'), std::string::npos) << text;
            EXPECT_EQ(text.find('{'), std::string::npos) << text;
        }
        return error.message().id;
    }
    return MessageId::Count;
}

// Intersects the view ray through (x, y) with the plane directly, without the nine coefficients. depth: along forward;
// not positive if the intersection is behind the eye.
struct DirectHit {
    double s = 0.0;
    double t = 0.0;
    double depth = 0.0;
};

inline DirectHit directHit(const View& view, double x, double y) {
    const glm::dvec3 ray = view.camera.rayThrough(x, y);
    const glm::dvec3 normal = glm::cross(view.plane.perS, view.plane.perT);
    const double depth = glm::dot(normal, view.plane.origin - view.camera.eye) / glm::dot(normal, ray);
    const glm::dvec3 offset = view.camera.eye + depth * ray - view.plane.origin;
    const double area = glm::dot(normal, normal);
    return {glm::dot(glm::cross(offset, view.plane.perT), normal) / area,
            glm::dot(glm::cross(view.plane.perS, offset), normal) / area, depth};
}

}  // namespace relief::test
