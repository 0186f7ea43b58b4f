#include "mapping/footprint.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "mapping_cases.h"

namespace relief {
namespace {

using test::Random;
using test::randomView;
using test::View;

constexpr std::uint64_t kSeed = 20181;
constexpr int kCases = 2000;

// Relative to the magnitude of the values: sums and products of a few rounded terms of a Jacobian with condition up to
// 1e3, squared once.
constexpr double kRounding = 1e-9;
// Error of central differences over kStep pixels, relative to the largest derivative: their second-order term and the
// cancellation in u, at pixels where q changes by less than a hundredth per pixel.
constexpr double kStep = 1.0 / 64;
constexpr double kDifference = 1e-4;

Jacobian randomJacobian(Random& random) {
    const double size = std::exp2(random.real(-8.0, 8.0));
    const double turn = random.real(0.0, 2 * std::numbers::pi);
    const double thin = std::exp2(random.real(-7.0, 0.0));
    const double spin = random.real(0.0, 2 * std::numbers::pi);
    const double flip = random.whole(0, 1) == 1 ? -1 : 1;
    const double c = std::cos(turn), s = std::sin(turn), cp = std::cos(spin), sp = std::sin(spin);
    // Rotation, scaling, rotation: the semi-axes are size and size * thin.
    return {size * (c * cp - s * thin * sp * flip), size * (s * cp + c * thin * sp * flip),
            size * (-c * sp - s * thin * cp * flip), size * (-s * sp + c * thin * cp * flip)};
}

TEST(Footprint, TheEllipseIsTheImageOfTheCircle) {
    Random random(kSeed);
    for (int n = 0; n < kCases; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const Jacobian j = randomJacobian(random);
        const Ellipse e = ellipseOf(j);
        const double radius = random.real(0.1, 4.0);
        const HalfExtents<double> extents = e.halfExtents(radius);
        const SemiAxes<double> axes = e.semiAxes();
        double farthest = 0, nearest = 1e300, alongMajor = 0, mostU = 0, mostV = 0;
        constexpr int kPoints = 720;
        for (int k = 0; k < kPoints; ++k) {
            const double angle = 2 * std::numbers::pi * k / kPoints;
            const double x = radius * std::cos(angle), y = radius * std::sin(angle);
            const double du = j.ux * x + j.uy * y, dv = j.vx * x + j.vy * y;
            EXPECT_NEAR(e.form(du, dv) / e.f, radius * radius, kRounding * radius * radius * 1e4);
            const double distance = std::hypot(du, dv);
            if (distance > farthest) alongMajor = std::abs(du * axes.majorU + dv * axes.majorV) / distance;
            farthest = std::max(farthest, distance);
            nearest = std::min(nearest, distance);
            mostU = std::max(mostU, std::abs(du));
            mostV = std::max(mostV, std::abs(dv));
        }
        // 720 points are half a degree apart: the extremes are found up to 1 - cos(a quarter of a degree) of the longer
        // axis.
        const double slack = 1e-5 * axes.major * radius;
        EXPECT_NEAR(farthest, axes.major * radius, slack);
        EXPECT_GE(nearest, axes.minor * radius * (1 - kRounding) - kRounding * slack);
        EXPECT_NEAR(mostU, extents.u, slack);
        EXPECT_NEAR(mostV, extents.v, slack);
        EXPECT_NEAR(axes.major * axes.minor, std::abs(j.determinant()), kRounding * axes.major * axes.major);
        if (axes.minor < 0.9 * axes.major) {
            EXPECT_GT(alongMajor, 0.999);
        }
    }
}

TEST(Footprint, SemiAxesStayGoodWhereEigenvaluesWouldCancel) {
    // Axis ratios down to 1e-7: computing the smaller eigenvalue of J J^T by subtraction loses all digits, sqrt(F) /
    // major does not.
    for (const double thin : {1e-3, 1e-5, 1e-7}) {
        const double c = std::cos(0.7), s = std::sin(0.7);
        const Jacobian j{c * 300, s * 300, -s * 300 * thin, c * 300 * thin};
        const SemiAxes<double> axes = ellipseOf(j).semiAxes();
        EXPECT_NEAR(axes.major, 300, 300 * kRounding);
        EXPECT_NEAR(axes.minor, 300 * thin, 300 * thin * kRounding);
        EXPECT_NEAR(axes.majorU * c + axes.majorV * s, 1, kRounding);
    }
}

TEST(Footprint, SpansHoldExactlyTheTexelsOfTheForm) {
    Random random(kSeed + 1);
    std::int64_t texels = 0;
    for (int n = 0; n < kCases; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed + 1) + ", case " + std::to_string(n));
        Jacobian j = randomJacobian(random);
        const double shrink = std::min(1.0, 40.0 / ellipseOf(j).semiAxes().major);
        j = {j.ux * shrink, j.vx * shrink, j.uy * shrink, j.vy * shrink};
        // borders through texel centres
        if (n % 5 == 0) j = {double(random.whole(1, 8)), 0, 0, double(random.whole(1, 8))};
        const Ellipse e = clampedEllipse(ellipseOf(j), 1e-3, 1e4);
        const double radius = n % 5 == 0 ? 1.0 : random.real(0.3, 2.0);
        const double u0 = n % 5 == 0 ? 100.5 : random.real(-50.0, 4000.0);
        const double v0 = n % 5 == 0 ? 100.5 : random.real(-50.0, 4000.0);
        const HalfExtents<double> box = e.halfExtents(radius);
        const auto first = static_cast<std::int64_t>(std::floor(u0 - box.u)) - 3;
        const auto last = static_cast<std::int64_t>(std::ceil(u0 + box.u)) + 3;
        const auto top = static_cast<std::int64_t>(std::floor(v0 - box.v)) - 2;
        const auto bottom = static_cast<std::int64_t>(std::ceil(v0 + box.v)) + 2;
        for (std::int64_t row = top; row <= bottom; ++row) {
            const double dv = static_cast<double>(row) + 0.5 - v0;
            const TexelSpan span = e.texelSpan(u0, dv, radius);
            for (std::int64_t i = first; i <= last; ++i) {
                const bool in = e.contains(static_cast<double>(i) + 0.5 - u0, dv, radius);
                ASSERT_EQ(in, i >= span.begin && i < span.end) << "texel " << i << ", " << row;
                texels += in ? 1 : 0;
            }
            const Span<double> real = e.rowSpan(dv, radius);
            if (span.empty()) continue;
            // the end of a span at a tangent is the square root of a rounding error
            const double slack = 1e-6 * (1 + box.u);
            EXPECT_LE(real.begin - slack, static_cast<double>(span.begin) + 0.5 - u0);
            EXPECT_GE(real.end + slack, static_cast<double>(span.end) - 0.5 - u0);
        }
    }
    EXPECT_GT(texels, 100000);
}

TEST(Footprint, PixelFromTexelIsTheInverse) {
    Random random(kSeed + 2);
    for (int n = 0; n < kCases; ++n) {
        const Jacobian j = randomJacobian(random);
        const PixelFromTexel back = pixelFromTexel(j);
        const double x = random.real(-2.0, 2.0), y = random.real(-2.0, 2.0);
        const double du = j.ux * x + j.uy * y, dv = j.vx * x + j.vy * y;
        EXPECT_NEAR(back.dx(du, dv), x, kRounding);
        EXPECT_NEAR(back.dy(du, dv), y, kRounding);
        const Ellipse e = ellipseOf(j);
        EXPECT_NEAR(e.form(du, dv) / e.f, x * x + y * y, 1e-6);
    }
    const PixelFromTexel flat = pixelFromTexel(Jacobian{2, 1, 4, 2});
    EXPECT_EQ(flat.dx(1, 1), 0);
    EXPECT_EQ(flat.dy(-3, 5), 0);
}

TEST(Footprint, DerivativesAreThoseOfTheMap) {
    Random random(kSeed + 3);
    int compared = 0;
    for (int n = 0; n < kCases; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed + 3) + ", case " + std::to_string(n));
        const View view = randomView(random);
        const Homography map = fromCameraAndPlane(view.camera, view.plane);
        const double x = random.real(0.0, 2000.0), y = random.real(0.0, 1000.0);
        const double q = map.denominator(x, y);
        if (q <= 0 || (std::abs(map.qx) + std::abs(map.qy)) > 0.01 * q) continue;
        const Jacobian j = jacobianAt(map, x, y);
        const TexelPoint left = map.at(x - kStep, y), right = map.at(x + kStep, y);
        const TexelPoint top = map.at(x, y - kStep), bottom = map.at(x, y + kStep);
        const double size = std::max({std::abs(j.ux), std::abs(j.uy), std::abs(j.vx), std::abs(j.vy)});
        EXPECT_NEAR((right.s - left.s) / (2 * kStep), j.ux, kDifference * size);
        EXPECT_NEAR((right.t - left.t) / (2 * kStep), j.vx, kDifference * size);
        EXPECT_NEAR((bottom.s - top.s) / (2 * kStep), j.uy, kDifference * size);
        EXPECT_NEAR((bottom.t - top.t) / (2 * kStep), j.vy, kDifference * size);
        EXPECT_NEAR(j.determinant(), map.determinant() / (q * q * q), kDifference * size * size);
        ++compared;
    }
    EXPECT_GT(compared, kCases / 4);
}

template <typename T>
void expectUsable(const EllipseOf<T>& e, T smallest, T largest) {
    const T radius = T(1.5);
    const SemiAxes<T> axes = e.semiAxes();
    const T slack = T(1e3) * std::numeric_limits<T>::epsilon();
    ASSERT_TRUE(std::isfinite(e.a) && std::isfinite(e.b) && std::isfinite(e.c) && std::isfinite(e.f));
    EXPECT_GE(axes.minor, smallest * (1 - slack));
    EXPECT_LE(axes.major, largest * (1 + slack));
    EXPECT_GE(axes.major, axes.minor * (1 - slack));
    EXPECT_NEAR(axes.majorU * axes.majorU + axes.majorV * axes.majorV, 1, slack);
    EXPECT_TRUE(std::isfinite(e.halfExtents(radius).u) && std::isfinite(e.halfExtents(radius).v));
    const Span<T> span = e.rowSpan(T(0), radius);
    EXPECT_FALSE(span.empty());
    EXPECT_TRUE(std::isfinite(span.begin) && std::isfinite(span.end));
    EXPECT_GT(e.f, 0);
}

template <typename T>
void expectAllClamped() {
    const T inf = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const T big = T(1e9), tiny = std::numeric_limits<T>::denorm_min(), max = std::numeric_limits<T>::max();
    const T values[] = {T(0), T(1), T(-3), tiny, -big, big, max, inf, -inf, nan};
    for (const T ux : values) {
        for (const T vx : values) {
            for (const T uy : values) {
                for (const T vy : values) {
                    SCOPED_TRACE("J = " + std::to_string(ux) + " " + std::to_string(vx) + " " + std::to_string(uy) +
                                 " " + std::to_string(vy));
                    const JacobianOf<T> j{ux, vx, uy, vy};
                    expectUsable(clampedEllipse(ellipseOf(j), T(0.5), T(4096)), T(0.5), T(4096));
                    const PixelFromTexelOf<T> back = pixelFromTexel(j);
                    EXPECT_TRUE(std::isfinite(back.dx(T(2), T(3))) && std::isfinite(back.dy(T(2), T(3))));
                }
            }
        }
    }
}

TEST(Footprint, VanishingAndInfiniteOnesAreClamped) {
    expectAllClamped<float>();
    expectAllClamped<double>();
}

TEST(Footprint, HorizonAndEdgeOnPolygonsStayFinite) {
    // A floor seen at ever lower angles, with rows from the foreground through the horizon and above it.
    for (const double height : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
        View view;
        view.camera.focal = {500, 500};
        view.camera.principal = {400, 300};
        view.plane.perS = {0.01, 0, 0};
        view.plane.perT = {0, 0, 0.01};
        view.plane.origin = {0, -height, 0};
        const Homography map = fromCameraAndPlane(view.camera, view.plane);
        for (double y = 290; y <= 310; y += 0.5) {
            for (const double x : {0.5, 400.0, 799.5}) {
                SCOPED_TRACE("eye " + std::to_string(height) + " over the floor, pixel " + std::to_string(x) + ", " +
                             std::to_string(y));
                expectUsable(clampedEllipse(ellipseOf(jacobianAt(map, x, y)), 0.4, 1e5), 0.4, 1e5);
            }
        }
    }
}

TEST(Footprint, ClampingKeepsWhatIsInRange) {
    Random random(kSeed + 4);
    for (int n = 0; n < kCases; ++n) {
        const Ellipse e = ellipseOf(randomJacobian(random));
        const SemiAxes<double> before = e.semiAxes();
        const Ellipse same = clampedEllipse(e, before.minor * 0.9, before.major * 1.1);
        EXPECT_EQ(same.a, e.a);
        EXPECT_EQ(same.b, e.b);
        EXPECT_EQ(same.c, e.c);
        EXPECT_NEAR(same.f, e.f, kRounding * e.f);
        if (before.minor > 0.5 * before.major) continue;
        // The minor axis is raised to the geometric mean of both; the other axis and the directions are unchanged.
        const double raised = std::sqrt(before.minor * before.major);
        const SemiAxes<double> after = clampedEllipse(e, raised, before.major * 1.1).semiAxes();
        EXPECT_NEAR(after.major, before.major, kRounding * before.major);
        EXPECT_NEAR(after.minor, raised, 1e-6 * raised);
        EXPECT_NEAR(std::abs(after.majorU * before.majorU + after.majorV * before.majorV), 1, 1e-6);
        const SemiAxes<double> cut = clampedEllipse(e, before.minor * 0.9, raised).semiAxes();
        EXPECT_NEAR(cut.major, raised, 1e-6 * raised);
        EXPECT_NEAR(cut.minor, before.minor, 1e-6 * before.minor);
    }
}

}  // namespace
}  // namespace relief
