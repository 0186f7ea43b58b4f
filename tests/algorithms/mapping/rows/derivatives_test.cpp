#include "mapping/rows/derivatives.h"

#include <string>

#include <gtest/gtest.h>

#include "algorithms/mapping/mapping_cases.h"
#include "mapping/rows/counting_scalar.h"
#include "row_cases.h"

namespace relief {
namespace {

using test::Random;
using test::randomView;
using test::View;

__extension__ typedef __int128 Exact;

constexpr std::uint64_t kSeed = 20184;
constexpr int kCases = 1000;
// Largest absolute value of integer coefficients and coordinates: the products below stay under 2^60, so that every
// double is exact.
constexpr int kLargest = 400;

struct IntegerMap {
    Homography map;
    Exact a, b, c, d, e, f, g, h, i;
};
IntegerMap randomIntegers(Random& random) {
    const auto one = [&] { return random.whole(-kLargest, kLargest); };
    const int a = one(), b = one(), c = one(), d = one(), e = one(), f = one(), g = one(), h = one(), i = one();
    return {{double(a), double(b), double(c), double(d), double(e), double(f), double(g), double(h), double(i)},
            a,
            b,
            c,
            d,
            e,
            f,
            g,
            h,
            i};
}

TEST(Derivatives, AreTheExactRationals) {
    Random random(kSeed);
    int compared = 0;
    for (int n = 0; n < kCases; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const IntegerMap m = randomIntegers(random);
        const int x = random.whole(-kLargest, kLargest), y = random.whole(-kLargest, kLargest);
        const Exact q = m.g * x + m.h * y + m.i;
        if (q == 0) continue;
        ++compared;
        // By the quotient rule, without the coefficients a, b, c, d.
        const Exact wu = m.a * x + m.b * y + m.c, wv = m.d * x + m.e * y + m.f;
        const Exact ux = m.a * q - m.g * wu, vx = m.d * q - m.g * wv;
        const Exact uy = m.b * q - m.h * wu, vy = m.e * q - m.h * wv;
        const auto terms = derivativeTerms<Exact>(m.map, [](double value) { return static_cast<Exact>(value); });
        EXPECT_TRUE(terms.a(y) == ux && terms.b(y) == vx && terms.c(x) == uy && terms.d(x) == vy);
        EXPECT_TRUE(terms.q(x, y) == q);
        EXPECT_TRUE(ux * vy - uy * vx == terms.det * q) << "a d - b c = det q";
        // A' C' - B'^2 / 4 = (det q)^2 = F' q^4: in the scaled form the factor is easily forgotten.
        const Exact ca = vx * vx + vy * vy, cb = ux * vx + uy * vy, cc = ux * ux + uy * uy;
        const long double scaled = static_cast<long double>(ca) * static_cast<long double>(cc) -
                                   static_cast<long double>(cb) * static_cast<long double>(cb);
        const auto dq = static_cast<long double>(terms.det * q);
        const auto size = static_cast<long double>(ca) * static_cast<long double>(cc);
        EXPECT_NEAR(static_cast<double>((scaled - dq * dq) / size), 0, 1e-17);

        const auto exact = [&](Exact k) {
            return static_cast<double>(static_cast<long double>(k) / static_cast<long double>(q * q));
        };
        const Jacobian direct = directDerivatives(derivativeTerms<double>(m.map), double(x), double(y));
        const Jacobian plain = jacobianAt(m.map, x, y);
        // The integers are exact, so only the quotient is rounded.
        EXPECT_DOUBLE_EQ(direct.ux, exact(ux));
        EXPECT_DOUBLE_EQ(direct.vx, exact(vx));
        EXPECT_DOUBLE_EQ(direct.uy, exact(uy));
        EXPECT_DOUBLE_EQ(direct.vy, exact(vy));
        EXPECT_TRUE(plain.ux == direct.ux && plain.vx == direct.vx && plain.uy == direct.uy && plain.vy == direct.vy);
    }
    EXPECT_GT(compared, kCases * 9 / 10);
}

template <typename T>
struct Rows {
    explicit Rows(std::int64_t count)
        : a(static_cast<std::size_t>(count)), b(a), c(a), f(a), row{a.data(), b.data(), c.data(), f.data()} {}
    std::vector<T> a, b, c, f;
    EllipseRow<T> row;
};

template <typename T>
void expectNear(const EllipseOf<T>& e, const Ellipse& truth, double relative) {
    const double size = std::max(truth.a, truth.c);
    EXPECT_NEAR(e.a, truth.a, relative * size);
    EXPECT_NEAR(e.b, truth.b, relative * size);
    EXPECT_NEAR(e.c, truth.c, relative * size);
    // F as det^2 / q^6 has no cancellation; as (u_x v_y - u_y v_x)^2 it loses the digits that cancel in thin
    // footprints.
    EXPECT_NEAR(std::sqrt(static_cast<double>(e.f)), std::sqrt(truth.f), relative * size);
}

template <typename T>
void expectEqualEllipses(double relative) {
    Random random(kSeed + 1);
    int compared = 0;
    for (int n = 0; n < kCases; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed + 1) + ", case " + std::to_string(n));
        const View view = randomView(random);
        const Homography map = fromCameraAndPlane(view.camera, view.plane);
        const std::int64_t first = random.whole(0, 1500), y = random.whole(0, 900), count = random.whole(1, 200);
        const double at = static_cast<double>(y) + 0.5;
        double smallest = 1e300, largest = 0;
        for (const std::int64_t x : {first, first + count - 1}) {
            const double q = map.denominator(static_cast<double>(x) + 0.5, at);
            smallest = std::min(smallest, q), largest = std::max(largest, q);
        }
        const double terms =
            std::abs(map.qx) * static_cast<double>(first + count) + std::abs(map.qy) * at + std::abs(map.q1);
        // Close to the horizon the digits of q cancel; rows are cut there.
        if (smallest < 0.05 * terms) continue;
        ++compared;
        const auto forms = derivativeTerms<T>(map);
        Rows<T> direct(count), iterative(count), cached(count);
        directEllipses(forms, first, T(at), count, direct.row);
        iterativeEllipses(forms, first, T(at), count, 16, iterative.row);
        const EllipseCaches<T> caches(forms, {first, first + count}, {y - 1, y + 2});
        const EllipseCaches<T> folded(forms, {first, first + count}, {y, y + 1}, true);
        caches.ellipses(first, y, count, cached.row);
        for (std::int64_t i = 0; i < count; ++i) {
            const double x = static_cast<double>(first + i) + 0.5;
            const Ellipse truth = ellipseOf(jacobianAt(map, x, at));
            expectNear(direct.row.at(i), truth, relative);
            expectNear(iterative.row.at(i), truth, relative);
            const ScaledEllipse<T> scaled = caches.at(first + i, y);
            expectNear(scaled.unscaled(), truth, relative);
            EXPECT_EQ(scaled.a, cached.row.at(i).a);
            EXPECT_EQ(scaled.f, cached.row.at(i).f);
            const HalfExtents<double> extents = truth.halfExtents(1.5);
            EXPECT_NEAR(scaled.halfExtents(T(1.5)).u, extents.u, relative * std::max(extents.u, extents.v));
            EXPECT_NEAR(scaled.halfExtents(T(1.5)).v, extents.v, relative * std::max(extents.u, extents.v));
            // r^2 of a point on the circle of radius 1.
            const Jacobian j = jacobianAt(map, x, at);
            const double angle = random.real(0.0, 6.28);
            const double du = j.ux * std::cos(angle) + j.uy * std::sin(angle);
            const double dv = j.vx * std::cos(angle) + j.vy * std::sin(angle);
            const double thin = std::max(truth.a, truth.c) / std::sqrt(truth.f);
            EXPECT_NEAR(folded.radiusForm(first + i, y).at(T(du), T(dv)), 1, relative * thin * thin * 8);
        }
    }
    EXPECT_GT(compared, kCases / 4);
}

// Relative to the ellipse's size: about ten roundings of q (amplified at most 20 times by cancellation in q, to the
// fourth power), and 16 steps of the iterative form.
TEST(Derivatives, DirectIterativeAndCachedGiveOneEllipseInDouble) {
    expectEqualEllipses<double>(4 * 20 * 32 * 0x1p-53);
}
TEST(Derivatives, DirectIterativeAndCachedGiveOneEllipseInFloat) {
    expectEqualEllipses<float>(4 * 20 * 32 * 0x1p-24);
}

// --- counts

constexpr std::int64_t kPixels = 480;

template <typename Run>
OperationCounts perPixel(const Run& run) {
    OperationCounts counts;
    const Homography map = test::rowOfRatio(2000, 0.3, 512, 10, 60, false);
    const auto terms = derivativeTerms<Counted>(map, [&](double value) { return Counted(value, &counts); });
    const auto total = [&](std::int64_t count) {
        counts = {};
        run(terms, count, counts);
        return counts;
    };
    const OperationCounts one = total(kPixels), two = total(2 * kPixels);
    EXPECT_EQ((two.mul - one.mul) % kPixels, 0);
    return {(two.mul - one.mul) / kPixels, (two.add - one.add) / kPixels, (two.div - one.div) / kPixels};
}

TEST(DerivativeCounts, AreThoseOfTheTable) {
    using Terms = DerivativeTerms<Counted>;
    const Counted y(0.5);
    EXPECT_EQ(perPixel([&](const Terms& terms, std::int64_t count, OperationCounts&) {
                  for (std::int64_t n = 0; n < count; ++n) directDerivatives(terms, centreOf<Counted>(n), y);
              }),
              (OperationCounts{7, 6, 4}));
    EXPECT_EQ(perPixel([&](const Terms& terms, std::int64_t count, OperationCounts&) {
                  iterativeDerivatives(terms, 0, y, count, 0, [](std::int64_t, const JacobianOf<Counted>&) {});
              }),
              (OperationCounts{1, 3, 4}));
    EXPECT_EQ(perPixel([&](const Terms& terms, std::int64_t count, OperationCounts&) {
                  Rows<Counted> rows(count);
                  directEllipses(terms, 0, y, count, rows.row);
              }),
              (OperationCounts{17, 10, 4}));
    EXPECT_EQ(perPixel([&](const Terms& terms, std::int64_t count, OperationCounts&) {
                  Rows<Counted> rows(count);
                  iterativeEllipses(terms, 0, y, count, 0, rows.row);
              }),
              (OperationCounts{11, 7, 4}));
    EXPECT_EQ(perPixel([&](const Terms& terms, std::int64_t count, OperationCounts& counts) {
                  const EllipseCaches<Counted> caches(terms, {0, count}, {0, 1});
                  counts = {};
                  Rows<Counted> rows(count);
                  caches.ellipses(0, 0, count, rows.row);
              }),
              (OperationCounts{1, 4, 1}));
    EXPECT_EQ(perPixel([&](const Terms& terms, std::int64_t count, OperationCounts& counts) {
                  const EllipseCaches<Counted> caches(terms, {0, count}, {0, 1}, true);
                  counts = {};
                  for (std::int64_t n = 0; n < count; ++n) caches.radiusForm(n, 0);
              }),
              (OperationCounts{4, 4, 0}));
}

TEST(Derivatives, EdgeOnMapsAreNotDividedBy) {
    Homography flat;  // det = 0: v does not depend on the pixel
    flat.ty = 0;
    const EllipseCaches<float> caches(derivativeTerms<float>(flat), {0, 4}, {0, 4}, true);
    EXPECT_EQ(caches.radiusForm(2, 3).at(5, 7), 0);
    const Ellipse e = clampedEllipse(ellipseOf(jacobianAt(flat, 1, 1)), 0.5, 100.0);
    EXPECT_NEAR(e.semiAxes().minor, 0.5, 1e-12);
}

}  // namespace
}  // namespace relief
