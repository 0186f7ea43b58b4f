// Iso-lines lie where the value is.
#include "painting/iso_lines.h"

#include <gtest/gtest.h>

#include <cmath>

namespace reliefui {
namespace {

relief::FloatImage sampled(int width, int height, float (*value)(int, int)) {
    relief::FloatImage samples(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) samples(x, y) = value(x, y);
    }
    return samples;
}

TEST(IsoLines, LieWhereAPlaneHasTheValue) {
    constexpr double kRounding = 1e-12;
    const relief::FloatImage plane = sampled(7, 5, [](int x, int y) { return static_cast<float>(x + 3 * y); });
    const std::vector<IsoLine> lines = isoLines(plane, {2.25, 8.5});
    ASSERT_EQ(lines.size(), 2U);
    for (const IsoLine& line : lines) {
        EXPECT_FALSE(line.closed);
        EXPECT_GE(line.points.size(), 4U);
        for (const Point& p : line.points) {
            const double x = p.x - 0.5, y = p.y - 0.5;
            EXPECT_NEAR(x + 3 * y, line.value, kRounding);
            // Each point lies on an edge between two samples.
            EXPECT_TRUE(x == std::floor(x) || y == std::floor(y));
        }
    }
}

TEST(IsoLines, CloseRoundAPeakAndStopBesideWhatIsNotANumber) {
    constexpr auto kCone = [](int x, int y) { return static_cast<float>(-std::hypot(x - 4, y - 4)); };
    relief::FloatImage cone = sampled(9, 9, kCone);
    const std::vector<IsoLine> ring = isoLines(cone, {-2.5});
    ASSERT_EQ(ring.size(), 1U);
    EXPECT_TRUE(ring.front().closed);
    for (const Point& p : ring.front().points) EXPECT_NEAR(std::hypot(p.x - 4.5, p.y - 4.5), 2.5, 0.1);
    cone(4, 2) = std::nanf("");
    const std::vector<IsoLine> open = isoLines(cone, {-2.5});
    ASSERT_EQ(open.size(), 1U);
    EXPECT_FALSE(open.front().closed);
    EXPECT_LT(open.front().points.size(), ring.front().points.size());
}

// The mean of the four samples decides which corners a line separates from the others.
TEST(IsoLines, AtASaddleTheMeanDecides) {
    for (const float middle : {0.4F, 0.6F}) {
        relief::FloatImage saddle(2, 2);
        saddle(0, 0) = saddle(1, 1) = 1;
        saddle(1, 0) = saddle(0, 1) = 2 * middle - 1;
        const std::vector<IsoLine> lines = isoLines(saddle, {0.5});
        ASSERT_EQ(lines.size(), 2U);
        const bool highTogether = middle > 0.5F;
        for (const IsoLine& line : lines) {
            ASSERT_EQ(line.points.size(), 2U);
            // The corner nearest to both ends, relative to the middle of the square, is the one that the line cuts off.
            const double x = line.points[0].x + line.points[1].x - 2, y = line.points[0].y + line.points[1].y - 2;
            EXPECT_EQ(x * y < 0, highTogether);
        }
    }
}

}  // namespace
}  // namespace reliefui
