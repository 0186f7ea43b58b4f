#include "mapping/homography.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "mapping_cases.h"

namespace relief {
namespace {

using test::areaOf;
using test::Corners;
using test::directHit;
using test::failureOf;
using test::inside;
using test::kSquare;
using test::Random;
using test::randomConvexQuad;
using test::randomView;
using test::View;

TEST(Homography, TakesCornersToCorners) {
    constexpr std::uint64_t kSeed = 101;
    Random random(kSeed);
    for (int n = 0; n < 2000; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const double size = std::exp2(random.real(0.0, 12.0));
        const Corners screen = randomConvexQuad(random, std::exp2(random.real(0.0, 11.0)), random.point(-500, 2500));
        const Corners texture = randomConvexQuad(random, size, random.point(-3.0 * size, 3.0 * size));
        const Homography map = fromCorners(screen, texture);
        for (std::size_t k = 0; k < 4; ++k) {
            const TexelPoint p = map.at(screen[k].x, screen[k].y);
            EXPECT_NEAR(p.s, texture[k].x, 1e-10 * size);
            EXPECT_NEAR(p.t, texture[k].y, 1e-10 * size);
            EXPECT_GT(p.q, 0.0);
        }
        // The same orientation on the screen and in the picture means that the front is seen.
        EXPECT_EQ(map.determinant() > 0.0, (areaOf(screen) > 0.0) == (areaOf(texture) > 0.0));
    }
}

// Heckbert's example, computed by hand: a square whose upper edge appears half as long. Straight lines through the
// corners must meet in the right points: the diagonals cross at (1/2, 1/2) of the picture, at a third of the height
// below the upper edge.
TEST(Homography, TrapeziumByHand) {
    const Corners screen{glm::dvec2(1, 0), glm::dvec2(3, 0), glm::dvec2(4, 3), glm::dvec2(0, 3)};
    const Homography map = fromCorners(screen, kSquare);
    const TexelPoint centre = map.at(2.0, 1.0);
    EXPECT_NEAR(centre.s, 0.5, 1e-15);
    EXPECT_NEAR(centre.t, 0.5, 1e-15);
    EXPECT_NEAR(map.at(2.0, 0.0).q / map.at(2.0, 3.0).q, 0.5, 1e-15);  // the upper edge is twice as far
    EXPECT_NEAR(map.denominator(2.0, -3.0), 0.0, 1e-15);               // the sides meet on the horizon
}

TEST(Homography, CameraAndCornersAgree) {
    constexpr std::uint64_t kSeed = 20260;
    constexpr int kCases = 10000;
    constexpr double kLeastPixels = 4.0;  // width of the picture on the screen, in pixels; below it the
                                          // rounding of the corners (2e-13 pixels) is no longer far below the bound
    Random random(kSeed);
    int done = 0;
    double worst = 0.0;
    for (int n = 0; done < kCases; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        ASSERT_LT(n, 100 * kCases);
        const View view = randomView(random);
        bool usable = true;
        for (const glm::dvec2& texel : view.texelCorners()) {
            const glm::dvec3 p = view.camera.project(view.plane.at(texel.x, texel.y));
            usable = usable && p.z > 0.05 * glm::length(view.plane.perS) * view.width &&
                     std::hypot(p.x, p.y) < 10000.0 * p.z;
        }
        if (!usable) continue;
        const Corners screen = view.screenCorners();
        double longest = 0.0;
        for (std::size_t k = 0; k < 4; ++k) longest = std::max(longest, glm::distance(screen[k], screen[(k + 1) % 4]));
        if (std::abs(areaOf(screen)) < kLeastPixels * longest) continue;
        ++done;
        const Homography fromView = fromCameraAndPlane(view.camera, view.plane);
        const Homography fromQuad = fromCorners(screen, view.texelCorners());
        for (int k = 0; k < 25; ++k) {
            const glm::dvec2 pixel = inside(screen, 0.25 * (k % 5), 0.25 * (k / 5));
            const TexelPoint a = fromView.at(pixel.x, pixel.y);
            const TexelPoint b = fromQuad.at(pixel.x, pixel.y);
            ASSERT_GT(a.q, 0.0);
            ASSERT_GT(b.q, 0.0);
            // The error is the distance of the two results, in s relative to the picture's width and in t to its
            // height.
            const double error = std::max(std::abs(a.s - b.s) / view.width, std::abs(a.t - b.t) / view.height);
            worst = std::max(worst, error);
            ASSERT_LE(error, 1e-12);
        }
        EXPECT_EQ(fromView.determinant() > 0.0, fromQuad.determinant() > 0.0);
    }
    RecordProperty("worst", numberText(worst));
}

TEST(Homography, CameraAgreesWithTheRayItselfOnBothSidesOfTheHorizon) {
    constexpr std::uint64_t kSeed = 31;
    Random random(kSeed);
    int behind = 0;
    for (int n = 0; n < 3000; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const View view = randomView(random);
        const Homography map = fromCameraAndPlane(view.camera, view.plane);
        for (int k = 0; k < 20; ++k) {
            const glm::dvec2 pixel = random.point(-1000.0, 3000.0);
            const TexelPoint p = map.at(pixel.x, pixel.y);
            const test::DirectHit hit = directHit(view, pixel.x, pixel.y);
            ASSERT_EQ(p.q > 0.0, hit.depth > 0.0);
            behind += p.q > 0.0 ? 0 : 1;
            const double nearest = std::hypot(1.0, p.s / view.width, p.t / view.height);
            if (nearest > 1e3) continue;  // near the horizon both computations lose digits
            ASSERT_NEAR(p.s / view.width, hit.s / view.width, 1e-8 * nearest);
            ASSERT_NEAR(p.t / view.height, hit.t / view.height, 1e-8 * nearest);
        }
    }
    EXPECT_GT(behind, 1000);
}

TEST(Homography, DenominatorIsAConstantOverTheDepth) {
    constexpr std::uint64_t kSeed = 32;
    Random random(kSeed);
    for (int n = 0; n < 200; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const View view = randomView(random);
        const Homography map = fromCameraAndPlane(view.camera, view.plane);
        const glm::dvec3 a = view.camera.project(view.plane.at(0.3 * view.width, 0.2 * view.height));
        const glm::dvec3 b = view.camera.project(view.plane.at(0.6 * view.width, 0.9 * view.height));
        const double first = map.denominator(a.x / a.z, a.y / a.z) * a.z;
        const double second = map.denominator(b.x / b.z, b.y / b.z) * b.z;
        EXPECT_NEAR(first / second, 1.0, 1e-7);
    }
}

TEST(Homography, InverseAndAdjugate) {
    constexpr std::uint64_t kSeed = 41;
    Random random(kSeed);
    for (int n = 0; n < 1000; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const double pixels = std::exp2(random.real(2.0, 11.0));
        const double texels = std::exp2(random.real(2.0, 11.0));
        const Corners screen = randomConvexQuad(random, pixels, random.point(0, 2000));
        const Corners texture = randomConvexQuad(random, texels, random.point(-2000, 2000));
        // As the header states: digits are lost twice with the distance in units of the polygon's size.
        const double farOff = (1.0 + 2000.0 / pixels) * (1.0 + 2000.0 / texels);
        const double bound = 1e-15 * pixels * farOff * farOff;
        const Homography map = fromCorners(screen, texture);
        const Homography back = map.inverse();
        for (int k = 0; k < 9; ++k) {
            const glm::dvec2 pixel = inside(screen, 0.5 * (k % 3), 0.5 * (k / 3));
            const TexelPoint texel = map.at(pixel.x, pixel.y);
            const TexelPoint again = back.at(texel.s, texel.t);
            EXPECT_NEAR(again.s, pixel.x, bound);
            EXPECT_NEAR(again.t, pixel.y, bound);
            EXPECT_GT(again.q, 0.0);
        }
        // M adj(M) = det I, tested on the first row; det (adj M) = det^2.
        const Homography adjugate = map.adjugate();
        const double det = map.determinant();
        EXPECT_NEAR((map.sx * adjugate.sx + map.sy * adjugate.tx + map.s1 * adjugate.qx) / det, 1.0, 1e-6);
        EXPECT_NEAR(adjugate.determinant() / (det * det), 1.0, 1e-5);
    }
    EXPECT_EQ(failureOf([] { (Homography{1, 2, 3, 2, 4, 6, 0, 0, 1}).inverse(); }), MessageId::MappingSingular);
    EXPECT_EQ(failureOf([] { (Homography{0, 0, 0, 0, 0, 0, 0, 0, 0}).inverse(); }), MessageId::MappingSingular);
    EXPECT_EQ(failureOf([] {
                  (Homography{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 1, 0, 0, 0, 1}).inverse();
              }),
              MessageId::MappingSingular);
    EXPECT_EQ(failureOf([] { (Homography{1, 0, 0, 0, 1, 0, 0, 0, 0}).normalised(); }), MessageId::MappingSingular);
}

// det / q^3 is the determinant of the Jacobian; compared with central differences.
TEST(Homography, DeterminantIsTheJacobian) {
    constexpr std::uint64_t kSeed = 42;
    Random random(kSeed);
    for (int n = 0; n < 300; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const Corners screen = randomConvexQuad(random, 400.0, random.point(300, 700));
        const Homography map = fromCorners(screen, randomConvexQuad(random, 512.0, {256, 256}));
        const glm::dvec2 p = inside(screen, 0.4, 0.6);
        const double step = 0.01;
        const TexelPoint right = map.at(p.x + step, p.y);
        const TexelPoint left = map.at(p.x - step, p.y);
        const TexelPoint below = map.at(p.x, p.y + step);
        const TexelPoint above = map.at(p.x, p.y - step);
        const double jacobian =
            ((right.s - left.s) * (below.t - above.t) - (below.s - above.s) * (right.t - left.t)) / (4 * step * step);
        const double q = map.denominator(p.x, p.y);
        EXPECT_NEAR(map.determinant() / (q * q * q) / jacobian, 1.0, 1e-5);
    }
}

// The header's guarantees about magnitudes; evaluation in float neither overflows nor underflows.
TEST(Homography, ScaledForFloat) {
    constexpr std::uint64_t kSeed = 51;
    Random random(kSeed);
    for (int n = 0; n < 2000; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        View view = randomView(random);
        const double unit = std::exp2(random.whole(-60, 60));  // the scene may have any unit from metres to light years
        view.plane.origin *= unit;
        view.plane.perS *= unit;
        view.plane.perT *= unit;
        view.camera.eye *= unit;
        const Homography map = fromCameraAndPlane(view.camera, view.plane);
        const double size = std::max({1024.0 * std::abs(map.qx), 1024.0 * std::abs(map.qy), std::abs(map.q1)});
        EXPECT_GE(size, 1.0);
        EXPECT_LT(size, 2.0);
        const auto c = map.coefficients<float>();
        for (const float value : c) ASSERT_TRUE(std::isfinite(value));
        for (const float x : {0.5F, 65535.5F}) {
            for (const float y : {0.5F, 65535.5F}) {
                const float q = (c[6] * x + c[7] * y) + c[8];
                ASSERT_LT(std::abs(q), 260.0F);
                const float minorX = (c[0] * c[7] - c[1] * c[6]) * y + (c[0] * c[8] - c[2] * c[6]);
                const float minorY = (c[3] * c[7] - c[4] * c[6]) * y + (c[3] * c[8] - c[5] * c[6]);
                ASSERT_TRUE(std::isfinite(minorX * minorX + minorY * minorY));
            }
        }
        const auto det = static_cast<float>(map.determinant());
        ASSERT_TRUE(std::isfinite(det * det));
    }
}

TEST(Homography, ScalingChangesNoBit) {
    const Homography map{3.1, 0.2, 17.0, -0.3, 2.9, 4.0, 1e-4, 3e-4, 0.7};
    const double factor = std::exp2(-37);
    const Homography small{map.sx * factor, map.sy * factor, map.s1 * factor, map.tx * factor, map.ty * factor,
                           map.t1 * factor, map.qx * factor, map.qy * factor, map.q1 * factor};
    const TexelPoint a = map.normalised().at(123.5, 456.5);
    const TexelPoint b = small.normalised().at(123.5, 456.5);
    const TexelPoint c = map.at(123.5, 456.5);
    EXPECT_EQ(a.s, b.s);
    EXPECT_EQ(a.t, b.t);
    EXPECT_EQ(a.q, b.q);
    EXPECT_EQ(a.s, c.s);
    EXPECT_EQ(a.t, c.t);
}

// s = 1e6 under repeat, polygons a million pixels away, and both: as accurate as the rounding of the coordinates
// permits.
TEST(Homography, FarOffCoordinates) {
    constexpr std::uint64_t kSeed = 61;
    Random random(kSeed);
    for (int n = 0; n < 500; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const glm::dvec2 screenAt = n % 2 == 0 ? glm::dvec2(500, 500) : random.point(-1e6, 1e6);
        const glm::dvec2 textureAt = n % 3 == 0 ? glm::dvec2(0, 0) : random.point(-1e6, 1e6);
        const Corners screen = randomConvexQuad(random, 300.0, screenAt);
        const Corners texture = randomConvexQuad(random, 512.0, textureAt);
        const Homography map = fromCorners(screen, texture);
        for (std::size_t k = 0; k < 4; ++k) {
            const TexelPoint p = map.at(screen[k].x, screen[k].y);
            EXPECT_NEAR(p.s, texture[k].x, 1e-4);
            EXPECT_NEAR(p.t, texture[k].y, 1e-4);
        }
    }
}

}  // namespace
}  // namespace relief
