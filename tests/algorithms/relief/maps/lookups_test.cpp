// Constant-time queries of the map builders: the minimum of a range, the sectors that a rectangle intersects.
#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "relief/maps/azimuth_sectors.h"
#include "relief/maps/distance_map.h"
#include "relief/maps/range_minimum.h"

namespace relief::test {
namespace {

TEST(RangeMinimum, IsTheLeastOfEveryStretch) {
    for (const int width : {1, 2, 7, 8, 13, 16}) {
        const Heights lines = randomHeights(width, 3, 5);
        for (const bool wraps : {false, true}) {
            const RangeMinimum minimum(*lines, wraps);
            for (int line = 0; line < 3; ++line) {
                for (int first = 0; first < width; ++first) {
                    float least = 2;
                    for (int last = first; last < (wraps ? first + 2 * width : width); ++last) {
                        least = std::min(least, (*lines)(last % width, line));
                        ASSERT_EQ(minimum.least(line, first, last), least) << width << ": " << first << " to " << last;
                    }
                }
            }
        }
    }
}

TEST(AzimuthSectors, OfARectangleAreThoseOfItsPoints) {
    constexpr int kPoints = 200;  // on each side
    // A sector that the rectangle only touches may be included; one further away than this, in texels, may not.
    constexpr double kTouch = 1e-6;
    Random random(11);
    for (const int count : {1, 3, 4, 6, 8, 16, 32}) {
        const AzimuthSectors sectors(count);
        for (int n = 0; n < 400; ++n) {
            const double x0 = random.below(16) - 10;
            const double y0 = random.below(16) - 10;
            const double x1 = x0 + 1 + random.below(9);
            const double y1 = y0 + 1 + random.below(9);
            const SectorSet set = sectors.meeting(x0, x1, y0, y1);
            const bool around = x0 <= 0 && x1 >= 0 && y0 <= 0 && y1 >= 0;
            SectorSet met = around ? sectors.all() : 0;
            SectorSet near = met;
            const auto see = [&](double x, double y) {
                met |= SectorSet{1} << azimuthSector(x, y, count);
                for (const double dx : {-kTouch, kTouch}) {
                    for (const double dy : {-kTouch, kTouch}) {
                        near |= SectorSet{1} << azimuthSector(x + dx, y + dy, count);
                    }
                }
            };
            for (int p = 0; p <= kPoints; ++p) {
                const double x = x0 + (x1 - x0) * p / kPoints;
                const double y = y0 + (y1 - y0) * p / kPoints;
                for (const double side : {y0, y1}) see(x, side);
                for (const double side : {x0, x1}) see(side, y);
            }
            ASSERT_EQ(met & ~set, 0U) << count << ": " << x0 << ".." << x1 << " x " << y0 << ".." << y1;
            if (count > 2) {
                ASSERT_EQ(set & ~near, 0U) << count << ": " << x0 << ".." << x1 << " x " << y0 << ".." << y1;
            }
        }
    }
}

// Maps rely on this: a direction that points left, by however little, is in no sector of directions that point right.
TEST(AzimuthSectors, ASectorOfAQuadrantHoldsNoDirectionOfTheNext) {
    constexpr double kTiny = 1e-30;
    for (const int count : {4, 8, 32}) {
        const int quarter = count / 4;
        const auto quadrant = [&](double x, double y) { return azimuthSector(x, y, count) / quarter; };
        EXPECT_EQ(quadrant(kTiny, 1), 0);
        EXPECT_EQ(quadrant(1, kTiny), 0);
        EXPECT_EQ(quadrant(-kTiny, 1), 1);
        EXPECT_EQ(quadrant(-1, kTiny), 1);
        EXPECT_EQ(quadrant(-1, -kTiny), 2);
        EXPECT_EQ(quadrant(-kTiny, -1), 2);
        EXPECT_EQ(quadrant(kTiny, -1), 3);
        EXPECT_EQ(quadrant(1, -kTiny), 3);
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / count;
            EXPECT_EQ(azimuthSector(std::cos(angle), std::sin(angle), count), k);
        }
    }
}

}  // namespace
}  // namespace relief::test
