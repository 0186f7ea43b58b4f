// Input that defines no homography is refused with a message, and nothing else is refused.
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "mapping/homography.h"
#include "mapping_cases.h"

namespace relief {
namespace {

using test::Corners;
using test::failureOf;
using test::inside;
using test::kSquare;
using test::Random;
using test::randomView;
using test::View;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

MessageId cornersFailure(const Corners& screen, const Corners& texture) {
    return failureOf([&] { fromCorners(screen, texture); });
}

TEST(HomographyFaults, DegenerateCornersAreRefused) {
    const glm::dvec2 a(0, 0);
    const glm::dvec2 b(10, 0);
    const glm::dvec2 c(10, 10);
    const glm::dvec2 d(0, 10);
    const Corners good{a, b, c, d};
    EXPECT_EQ(cornersFailure(good, kSquare), MessageId::Count);
    EXPECT_EQ(cornersFailure({d, c, b, a}, kSquare), MessageId::Count);
    for (const Corners& line :
         {Corners{a, {5, 0}, b, d}, Corners{a, b, {10, 5}, c}, Corners{glm::dvec2(5, 5), b, c, d}}) {
        EXPECT_EQ(cornersFailure(line, kSquare), MessageId::MappingCornersOnLine);
        EXPECT_EQ(cornersFailure(kSquare, line), MessageId::MappingCornersOnLine);
    }
    for (const Corners& repeated : {Corners{a, a, c, d}, Corners{a, b, a, d}, Corners{a, a, a, a}}) {
        EXPECT_EQ(cornersFailure(repeated, kSquare), MessageId::MappingCornersOnLine);
    }
    for (const Corners& bad : {Corners{a, c, b, d}, Corners{a, b, d, c}, Corners{a, b, {2, 2}, d}}) {
        EXPECT_EQ(cornersFailure(bad, kSquare), MessageId::MappingNotConvex);
        EXPECT_EQ(cornersFailure(kSquare, bad), MessageId::MappingNotConvex);
    }
    for (const double wrong : {kNaN, kInfinity, -kInfinity}) {
        for (std::size_t k = 0; k < 4; ++k) {
            Corners bad = good;
            bad[k].y = wrong;
            EXPECT_EQ(cornersFailure(bad, kSquare), MessageId::MappingCornerNotFinite);
            EXPECT_EQ(cornersFailure(kSquare, bad), MessageId::MappingCornerNotFinite);
        }
    }
    const double huge = 1e200;
    EXPECT_NE(cornersFailure({a, {huge, 0}, {huge, huge}, {0, huge}}, kSquare), MessageId::Count);
}

// Nearly collinear corners, inexact by rounding, far away and rotated, are refused; corners that are slightly less
// collinear are not.
TEST(HomographyFaults, NearlyCollinearCorners) {
    constexpr std::uint64_t kSeed = 71;
    Random random(kSeed);
    for (int n = 0; n < 1000; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const glm::dvec2 start = random.point(-3000, 3000);
        const glm::dvec2 along = random.point(-1000, 1000);
        const glm::dvec2 across(-along.y, along.x);
        const double where = random.real(0.1, 0.9);
        EXPECT_EQ(cornersFailure({start, start + where * along, start + along, start + 0.5 * across}, kSquare),
                  MessageId::MappingCornersOnLine);
        const Corners thin{start, start + where * along - 1e-6 * across, start + along, start + 0.5 * across};
        const Homography map = fromCorners(thin, kSquare);
        const glm::dvec2 middle = inside(thin, 0.5, 0.5);
        const TexelPoint p = map.at(middle.x, middle.y);
        EXPECT_TRUE(std::isfinite(p.s) && std::isfinite(p.t) && p.q > 0.0);
    }
}

TEST(HomographyFaults, BadCamerasAndPlanesAreRefused) {
    const PinholeCamera camera = test::lookAlong({0, 0, 5}, {0, 0, -1}, 0.0);
    const TexturedPlane plane;
    const auto failure = [](const PinholeCamera& c, const TexturedPlane& p) {
        return failureOf([&] { fromCameraAndPlane(c, p); });
    };
    EXPECT_EQ(failure(camera, plane), MessageId::Count);
    PinholeCamera inPlane = camera;
    inPlane.eye = {7, 3, 0};
    EXPECT_EQ(failure(inPlane, plane), MessageId::MappingEdgeOn);
    PinholeCamera badEye = camera;
    badEye.eye.y = kNaN;
    EXPECT_EQ(failure(badEye, plane), MessageId::MappingCameraInvalid);
    for (const double focal : {0.0, -3.0, kNaN, kInfinity}) {
        for (const glm::dvec2& lengths : {glm::dvec2(focal, 500), glm::dvec2(500, focal)}) {
            PinholeCamera bad = camera;
            bad.focal = lengths;
            EXPECT_EQ(failure(bad, plane), MessageId::MappingCameraInvalid);
        }
    }
    PinholeCamera flat = camera;
    flat.up = flat.right;
    EXPECT_EQ(failure(flat, plane), MessageId::MappingCameraInvalid);
    TexturedPlane parallel = plane;
    parallel.perT = -2.0 * parallel.perS;
    EXPECT_EQ(failure(camera, parallel), MessageId::MappingPlaneInvalid);
    TexturedPlane zero = plane;
    zero.perS = {0, 0, 0};
    EXPECT_EQ(failure(camera, zero), MessageId::MappingPlaneInvalid);
    TexturedPlane endless = plane;
    endless.origin.x = kInfinity;
    EXPECT_EQ(failure(camera, endless), MessageId::MappingPlaneInvalid);
}

// The eye lies in a rotated plane, as exactly as double can represent it.
TEST(HomographyFaults, EdgeOnUpToRounding) {
    constexpr std::uint64_t kSeed = 81;
    Random random(kSeed);
    for (int n = 0; n < 1000; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        View view = randomView(random);
        view.camera.eye = view.plane.at(view.width * random.real(-3, 3), view.height * random.real(-3, 3));
        EXPECT_EQ(failureOf([&] { fromCameraAndPlane(view.camera, view.plane); }), MessageId::MappingEdgeOn);
        // From 0.01 degrees above the plane it is visible.
        const double size = glm::length(view.plane.perS) * view.width;
        view.camera.eye += 1.7e-4 * size * glm::normalize(view.plane.frontNormal());
        EXPECT_EQ(failureOf([&] { fromCameraAndPlane(view.camera, view.plane); }), MessageId::Count);
    }
}

}  // namespace
}  // namespace relief
