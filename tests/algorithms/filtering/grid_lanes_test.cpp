// The SIMD arithmetic of the grid filter: detection of planes and edges between hits, and rays and footprints of sample
// points.
#include "filtering/grid_lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "grid_cases.h"

namespace relief::test {
namespace {

TEST(GridLanes, surroundingsOfAPlaneAFoldAndAStep) {
    constexpr int kWidth = 23, kHeight = 9, kEdge = 11;
    const auto cells = static_cast<std::size_t>(kWidth * kHeight);
    struct Case {
        const char* name;
        float s, lambda;  // change at the edge: of s in texels, and of lambda
        float fold;       // ratio of the steps in s beyond and before the edge
    };
    for (const Case& c : {Case{"level", 0, 0, 1}, Case{"plane", 0, 0.01F, 1}, Case{"fold", 0, 0.01F, 1.4F},
                          Case{"step", 5, 0.3F, 1}, Case{"hole", std::nanf(""), 0, 1}}) {
        std::vector<float> s(cells + kCellSlack), t(s), lambda(s);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const auto i = static_cast<std::size_t>(y * kWidth + x);
                const auto beyond = static_cast<float>(std::max(0, x - kEdge));
                s[i] = 2 * static_cast<float>(x) + (c.fold - 1) * 2 * beyond + (x > kEdge ? c.s : 0);
                t[i] = 3 * static_cast<float>(y);
                lambda[i] = 0.2F + (x > kEdge ? c.lambda * static_cast<float>(x) : 0);
            }
        }
        std::vector<std::uint16_t> first(cells + kCellSlack), again(first);
        findSurroundings({kWidth, kHeight, s.data(), t.data(), lambda.data()}, 1, first.data());
        first.resize(cells);
        const auto at = [&](int x, int y) { return unsigned{first[static_cast<std::size_t>(y * kWidth + x)]}; };
        const unsigned across = (kSmooth | kStraight) << kAcross, down = (kSmooth | kStraight) << kDown;
        const unsigned all = kAllLines * (kSmooth | kStraight) | kOnPlane | kNearAround;
        EXPECT_EQ(at(0, 4), 0U) << c.name;
        EXPECT_EQ(at(kWidth - 1, 4), 0U) << c.name;
        EXPECT_EQ(at(4, 0), 0U) << c.name;
        EXPECT_EQ(at(4, 4), all | kOnLevel) << c.name;
        const std::string name = c.name;
        if (name == "level") {
            EXPECT_EQ(at(kEdge, 4), all | kOnLevel);
        }
        if (name == "plane") {
            EXPECT_EQ(at(kEdge, 4), all);
        }
        // A bend of a sixth: smooth, but neither straight nor planar.
        if (name == "fold") {
            EXPECT_EQ(at(kEdge, 4) & across, unsigned{kSmooth << kAcross});
            EXPECT_EQ(at(kEdge, 4) & kOnPlane, 0U);
        }
        if (name == "step" || name == "hole") {
            EXPECT_EQ(at(kEdge, 4) & ~unsigned{kNearAround}, down) << c.name;
            EXPECT_EQ(at(kEdge + 1, 4) & ~unsigned{kNearAround}, name == "step" ? down : 0U) << c.name;
        }
        for (const std::int64_t target : laneTargets()) {
            const ForcedTarget forced(target);
            again.assign(cells + kCellSlack, 7);
            findSurroundings({kWidth, kHeight, s.data(), t.data(), lambda.data()}, 1, again.data());
            again.resize(cells);
            EXPECT_EQ(again, first) << c.name << ' ' << laneTargetName(target);
        }
    }
}

// The same bend counts as planar and smooth if hits are close to each other, but not with smaller bounds.
TEST(GridLanes, surroundingsDependOnTheDistanceOfHitsAndOnTheBounds) {
    constexpr int kSide = 5;
    constexpr auto kMiddle = static_cast<std::size_t>(kSide * kSide / 2);
    const auto middle = [&](float texels, float fold, float bounds) {
        std::vector<float> s(kSide * kSide + kCellSlack), t(s), lambda(s);
        for (int i = 0; i < kSide * kSide; ++i) {
            const auto n = static_cast<std::size_t>(i);
            const auto across = static_cast<float>(i % kSide - 2);
            s[n] = texels * across * (across > 0 ? fold : 1);
            t[n] = texels * static_cast<float>(i / kSide);
            lambda[n] = 0.1F * across;
        }
        std::vector<std::uint16_t> found(kSide * kSide + kCellSlack);
        findSurroundings({kSide, kSide, s.data(), t.data(), lambda.data()}, bounds, found.data());
        return unsigned{found[kMiddle]};
    };
    // Ratios of the second differences to the first: 0.13, 0.375.
    EXPECT_NE(middle(2, 1.3F, 1) & kOnPlane, 0U);
    EXPECT_EQ(middle(10, 1.3F, 1) & kOnPlane, 0U);
    EXPECT_EQ(middle(2, 1.3F, boundsFor(5)) & kOnPlane, 0U);
    EXPECT_NE(middle(3, 2.2F, 1) & kSmooth, 0U);
    EXPECT_EQ(middle(10, 2.2F, 1) & kSmooth, 0U);
    EXPECT_EQ(middle(3, 2.2F, boundsFor(5)) & kSmooth, 0U);
    EXPECT_NE(middle(2, 1.3F, 1) & kNearAround, 0U);
    EXPECT_EQ(middle(10, 1.3F, 1) & kNearAround, 0U);
    EXPECT_EQ(boundsFor(2), 1.0F);
    // If the texture is magnified, only flat surroundings count as planar.
    EXPECT_NE(middle(0.7F, 1.2F, 1) & kOnPlane, 0U);
    EXPECT_EQ(middle(0.7F, 1.4F, 1) & kOnPlane, 0U);
}

// Rays and footprints of sample points against the code for single pixels.
TEST(GridLanes, raysAndFootprintsEqualThoseOfSinglePixels) {
    constexpr double kRelative = 1e-7;  // rounding to float
    for (const Address address : {Address::Repeat, Address::Border}) {
        const HeightField field = reliefOf("city", address);
        const FrameQueries queries(requestOf(field, randomPicture(64, 48, kSeed), grid()));
        const std::size_t count = queries.block.size();
        const PixelView& view = *queries.block.view[0];
        std::vector<double> x, y;
        for (std::size_t i = 0; i < count; ++i) {
            x.push_back(queries.block.x[i] + 0.5), y.push_back(queries.block.y[i] + 0.5);
        }
        for (const std::int64_t target : laneTargets()) {
            const ForcedTarget forced(target);
            RayBlock rays(count);
            raysThrough(view, x, y, rays, 0);
            PointBlock points;
            const SlopeScene slopes(field);
            const PointBlur blur{0.5, 0.125, 0.25};
            layFootprints(view, &slopes, blur, {2, 3}, {x, y, queries.block.lambda, queries.block.s, queries.block.t},
                          points);
            for (std::size_t i = 0; i < count; ++i) {
                ASSERT_EQ(rays[i], queries.block.rays[i]) << i;
                const Jacobian pixel = queries.block[i].jacobian;
                // The x component of the pixel's blurred footprint.
                const Jacobian j{blur.xx * pixel.ux + blur.xy * pixel.uy, blur.xx * pixel.vx + blur.xy * pixel.vy, 0,
                                 0};
                const auto [slopeS, slopeT] = field.slope(queries.block.s[i], queries.block.t[i]);
                const double facing = std::max(1.0, 1 + rays.a[i] * slopeS + rays.b[i] * slopeT);
                const double alongX = (slopeS * j.ux + slopeT * j.vx) / facing;
                const double size = std::abs(pixel.ux) + std::abs(pixel.vx) + std::abs(pixel.uy) + std::abs(pixel.vy) +
                                    std::abs(rays.a[i] * alongX);
                ASSERT_NEAR(points.ux[i], 2 * (j.ux - rays.a[i] * alongX), kRelative * size) << i;
                ASSERT_NEAR(points.vx[i], 3 * (j.vx - rays.b[i] * alongX), 2 * kRelative * size) << i;
                ASSERT_EQ(points.t[i], 3 * queries.block.t[i]);
            }
        }
    }
}

// Under border nothing can be hit from beyond the edge, so rounding must not move a centre on the edge out of the
// polygon.
TEST(GridLanes, raysOnTheEdgeStayInsideByRounding) {
    PixelView view;
    view.width = 64, view.height = 48;
    const double least = 1e-17, beyond = 0.01;
    const std::vector<double> x = {-least, std::nextafter(64.0, 65.0), -beyond, 64 + beyond, 20};
    const std::vector<double> y = {std::nextafter(48.0, 49.0), -least, 48 + beyond, -beyond, 30};
    const std::vector<double> s = {0, 64, -beyond, 64 + beyond, 20}, t = {48, 0, 48 + beyond, -beyond, 30};
    onEveryTarget([&] {
        RayBlock rays(x.size());
        raysThrough(view, x, y, rays, 0);
        EXPECT_EQ(rays.s0, s);
        EXPECT_EQ(rays.t0, t);
    });
}

TEST(GridLanes, uniformColorsAreThoseOfFourCorners) {
    constexpr std::size_t kRow = 21, kCells = 7 * kRow, kCount = kCells - kRow - 1;
    Random random(kSeed);
    std::array<std::vector<float>, 3> channel;
    for (auto& column : channel) {
        column.assign(kCells + kCellSlack, 0.5F);
        for (float& color : column) color += static_cast<float>(random.between(0, 1.3 * kUniformColors));
        // A dark picture.
        for (std::size_t c = 0; c < 2 * kRow; ++c) column[c] = 0.05F * column[c];
        column[3 * kRow + 5] = std::numeric_limits<float>::infinity();
    }
    for (std::size_t c = 5 * kRow; c < kCells; ++c) channel[0][c] = std::numeric_limits<float>::infinity();
    std::vector<std::uint16_t> expected;
    for (std::size_t c = 0; c < kCount; ++c) {
        bool all = true;
        for (const auto& column : channel) {
            const auto [low, high] = std::minmax({column[c], column[c + 1], column[c + kRow], column[c + kRow + 1]});
            all = all && high - low <= std::min(kUniformColors, kUniformShare * high);
        }
        expected.push_back(all ? 0xFFFF : 0);
    }
    EXPECT_GT(std::count(expected.begin(), expected.end(), 0xFFFF), 5);
    EXPECT_GT(std::count(expected.begin(), expected.end(), 0), 5);
    for (const std::int64_t target : laneTargets()) {
        const ForcedTarget forced(target);
        std::vector<std::uint16_t> even(kCells + kCellSlack, 7);
        findUniform({channel[0].data(), channel[1].data(), channel[2].data()}, kRow, kCount, 1, even.data());
        even.resize(kCount);
        EXPECT_EQ(even, expected) << laneTargetName(target);
    }
}

TEST(GridLanes, centresAreSplitIntoColumns) {
    constexpr std::size_t kCells = 37, kPoints = 3;
    std::vector<PointColor> colors((kCells + kCellSlack) * kPoints);
    std::vector<std::uint16_t> queries(kCells + kCellSlack);
    for (std::size_t c = 0; c < kCells; ++c) {
        queries[c] = static_cast<std::uint16_t>(c % 3 == 0 ? 6 : 1);
        const auto value = static_cast<float>(c);
        colors[c * kPoints] = {{value, value + 0.25F, value + 0.5F, c % 5 == 0 ? 0.0F : 1.0F}};
    }
    for (const std::int64_t target : laneTargets()) {
        const ForcedTarget forced(target);
        std::array<std::vector<float>, 3> out;
        for (auto& column : out) column.resize(kCells + kCellSlack);
        splitCentres(colors.data(), kPoints, queries.data(), kCells, {out[0].data(), out[1].data(), out[2].data()});
        for (std::size_t c = 0; c < kCells; ++c) {
            for (std::size_t n = 0; n < 3; ++n) {
                const float known = colors[c * kPoints].channel[n];
                ASSERT_EQ(out[n][c], c % 3 == 0 || c % 5 == 0 ? std::numeric_limits<float>::infinity() : known) << c;
            }
        }
    }
}

// Positions and footprints of interpolated points, where requested, against a computation one by one.
TEST(GridLanes, pointsFollowFromCentres) {
    constexpr std::size_t kRow = 9, kCells = 6 * kRow, kFirst = kRow + 1, kLast = kCells - kRow - 1;
    Random random(kSeed);
    std::vector<double> s(kCells + kCellSlack), t(s);
    for (std::size_t c = 0; c < kCells; ++c) s[c] = random.between(-1, 1), t[c] = random.between(-1, 1);
    std::vector<std::uint16_t> queries(kCells + kCellSlack), follows(queries);
    for (std::size_t c = kFirst; c < kLast; ++c) {
        queries[c] = static_cast<std::uint16_t>(random.between(0, 8));
        follows[c] = static_cast<std::uint16_t>(random.between(0, 8));
    }
    const std::array<double, 4> shares{0.5, 0.125, 0.25, 0.0625};
    const PointBlur blur{0.5, 0.125, 0.25};
    for (const std::size_t point : {std::size_t{0}, std::size_t{2}}) {
        const std::size_t square = point == 0 ? 0 : kRow + 1;
        const FollowJob job{s.data(), t.data(), kRow,   kFirst, kLast, queries.data(), follows.data(),
                            point,    3,        square, shares, blur,  {2, 3}};
        // The value of a column at cell c, and its differences across and down.
        const auto expected = [&](const std::vector<double>& column, std::size_t c) -> std::array<double, 3> {
            const double* x = column.data() + c;
            if (point == 0) return {x[0], (x[1] - x[-1]) / 2, (x[kRow] - *(x - kRow)) / 2};
            x -= square;
            const double p = x[0], q = x[1], r = x[kRow], w = x[kRow + 1];
            return {shares[0] * p + shares[1] * q + (shares[2] * r + shares[3] * w),
                    (shares[0] + shares[1]) * (q - p) + (shares[2] + shares[3]) * (w - r),
                    (shares[0] + shares[2]) * (r - p) + (shares[1] + shares[3]) * (w - q)};
        };
        for (const std::int64_t target : laneTargets()) {
            const ForcedTarget forced(target);
            PointBlock points;
            points.resize(1);
            std::vector<std::uint32_t> slots;
            followPoints(job, points, slots);
            std::size_t n = 1;
            for (std::size_t c = kFirst; c < kLast; ++c) {
                if ((queries[c] & follows[c] & (1U << point)) == 0) continue;
                ASSERT_LT(n, points.size());
                const auto [atS, acrossS, downS] = expected(s, c);
                const auto [atT, acrossT, downT] = expected(t, c);
                ASSERT_EQ(slots[n], c * 3 + point) << laneTargetName(target);
                ASSERT_EQ(points.s[n], 2 * atS);
                ASSERT_EQ(points.t[n], 3 * atT);
                constexpr double kRounding = 1e-6;
                ASSERT_NEAR(points.ux[n], 2 * (blur.xx * acrossS + blur.xy * downS), kRounding);
                ASSERT_NEAR(points.uy[n], 2 * (blur.xy * acrossS + blur.yy * downS), kRounding);
                ASSERT_NEAR(points.vx[n], 3 * (blur.xx * acrossT + blur.xy * downT), kRounding);
                ASSERT_NEAR(points.vy[n], 3 * (blur.xy * acrossT + blur.yy * downT), kRounding);
                ++n;
            }
            EXPECT_EQ(n, points.size()) << laneTargetName(target);
            EXPECT_GT(n, 5U);
        }
    }
}

}  // namespace
}  // namespace relief::test
