// Cone maps against all pairs of cells, and the surface against the cones.
#include "relief/maps/cone_map.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "algorithms/every_target.h"
#include "brute_cells.h"
#include "relief/maps/cone_builders.h"
#include "relief/maps/distance_map.h"
#include "relief/reliefs.h"

namespace relief::test {
namespace {

// Slopes are stored as floats, rounded up.
constexpr double kFloatRounding = 1e-6;

const std::vector<std::pair<int, int>>& sizes() {
    static const std::vector<std::pair<int, int>> all{{13, 9}, {16, 16}, {1, 5}, {3, 3}};
    return all;
}

ConeMap built(ConeKind kind, int sectors, const HeightField& field) {
    Work work(2);
    ConeParameters parameters;
    parameters.sectors = sectors;
    return buildConeMap(kind, parameters, field, work);
}

// Every third texel is high, so that walls and level ground alternate.
Heights walls(int width, int height, std::uint64_t seed) {
    Random random(seed);
    FloatImage image(width, height);
    for (float& h : image.pixels()) {
        const double height01 = random.unit();
        h = static_cast<float>(random.below(3) == 0 ? height01 : 0.1 * height01);
    }
    return share(std::move(image));
}

// Conservative slopes for one sector, with the given relative slack.
UnfilledVector<float> slopesWithin(double slack, const HeightField& field) {
    Work work(2);
    const CellGrid grid(field);
    UnfilledVector<float> apex;
    UnfilledVector<float> slopes(static_cast<std::size_t>(grid.x.cells) * static_cast<std::size_t>(grid.y.cells));
    conservativeCones(field, 1, slack, apex, slopes, work);
    return slopes;
}

void expectTheSteepest(const HeightField& field) {
    constexpr double kSlack = 0.01;  // of the maps that are stored
    double widest = 0;
    const BruteCells cells(field);
    const ConeMap map = built(ConeKind::Conservative, 1, field);
    ASSERT_EQ(map.nx(), cells.nx);
    const UnfilledVector<float> exact = slopesWithin(0, field);
    const UnfilledVector<float> loose = slopesWithin(0.2, field);
    const double reach =
        cells.wraps ? std::max(1.0, 0.5 * std::min(cells.nx, cells.ny)) : std::hypot(cells.nx, cells.ny);
    for (int y = 0; y < cells.ny; ++y) {
        for (int x = 0; x < cells.nx; ++x) {
            double apex = 0;
            double top = 0;
            cells.each([&](int i, int j, double high) {
                top = std::max(top, high);
                if (std::abs(i - x) <= 1 && std::abs(j - y) <= 1) apex = std::max(apex, high);
            });
            double kappa = (top - apex) / reach;
            cells.each([&](int i, int j, double high) {
                const double gap = std::hypot(std::max(std::abs(i - x) - 1, 0), std::max(std::abs(j - y) - 1, 0));
                if (gap > 0 && gap < reach) kappa = std::max(kappa, (high - apex) / gap);
            });
            ASSERT_EQ(map.apex(x, y, 0), static_cast<float>(apex)) << x << ", " << y;
            const auto within = [&](double slope, double slack) {
                ASSERT_GE(slope, kappa) << x << ", " << y << ", slack " << slack;
                ASSERT_LE(slope, kappa * (1 + slack) * (1 + kFloatRounding)) << x << ", " << y << ", slack " << slack;
            };
            const std::size_t n =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(cells.nx) + static_cast<std::size_t>(x);
            within(static_cast<double>(map.slopes(x, y, 0)), kSlack);
            if (kappa > 0) widest = std::max(widest, static_cast<double>(map.slopes(x, y, 0)) / kappa);
            within(static_cast<double>(exact[n]), 0);
            within(static_cast<double>(loose[n]), 0.2);
        }
    }
    if (widest > 0) {
        EXPECT_GT(widest, 1 + 0.9 * kSlack) << "the slack, which shortens the build, is not taken";
    }
}

TEST(ConservativeCones, AreTheSteepestOverAllOtherCells) {
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const auto& [width, height] : sizes()) {
                const HeightField field(walls(width, height, 21), surface, address, 0.3);
                SCOPED_TRACE(describe(field));
                expectTheSteepest(field);
            }
            // Covers long slopes and distant tree nodes.
            for (const char* relief : {"hills", "fractal", "bricks"}) {
                const bool half = address == Address::Repeat;  // only half a period is searched
                const HeightField field(share(makeRelief(relief, half ? 62 : 67, half ? 60 : 41, 3)), surface, address,
                                        0.3);
                SCOPED_TRACE(describe(field));
                expectTheSteepest(field);
            }
        }
    }
}

// High, nearly level ground: height differences are so small that rounding of heights is a significant part of them.
TEST(ConservativeCones, AreTheSteepestOnGroundAllButLevel) {
    for (const char* relief : {"hills", "fractal", "spikes"}) {
        for (const float share : {1e-3F, 1e-4F, 1e-5F}) {
            for (const std::uint64_t seed : {5U, 6U, 7U}) {
                FloatImage image = makeRelief(relief, 200, 5, seed);
                for (float& h : image.pixels()) h = 0.9F + share * h;
                const HeightField field(test::share(std::move(image)), Surface::Columns, Address::Clamp, 0.3);
                SCOPED_TRACE(std::string(relief) + " " + std::to_string(share));
                expectTheSteepest(field);
            }
        }
    }
}

TEST(ConservativeCones, HoldNoPointOfTheSurface) {
    constexpr int kPoints = 40000;
    constexpr double kNearly = 0.05;  // as a share of the slab, for this number of points
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const auto& [side, sectors] :
                 std::vector<std::pair<int, int>>{{10, 1}, {10, 4}, {10, 8}, {80, 1}, {80, 4}, {80, 8}}) {
                const HeightField field(walls(side + 3, side, 22), surface, address, 0.3);
                const BruteCells cells(field);
                SCOPED_TRACE(describe(field) + ", sectors " + std::to_string(sectors));
                const ConeMap map = built(ConeKind::Conservative, sectors, field);
                Random random(5);
                double tightest = 1;
                for (int n = 0; n < kPoints; ++n) {
                    const int x = random.below(cells.nx);
                    const int y = random.below(cells.ny);
                    // A point anywhere in the cell, and one up to two periods away.
                    const double s = x + random.unit() - cells.shift;
                    const double t = y + random.unit() - cells.shift;
                    const double angle = 2 * std::numbers::pi * random.unit();
                    const double way = 2.6 * side * random.unit() * random.unit();
                    const double a = std::cos(angle) * way;
                    const double b = std::sin(angle) * way;
                    if (!cells.holds(s, t) || !cells.holds(s + a, t + b)) continue;
                    const double kappa = static_cast<double>(map.slopes(x, y, azimuthSector(a, b, sectors)));
                    const double room = static_cast<double>(map.apex(x, y, 0)) + kappa * way - field.at(s + a, t + b);
                    ASSERT_GE(room, -1e-12) << s << "," << t << " to " << a << "," << b;
                    tightest = std::min(tightest, room);
                }
                // The cones are no smaller than necessary: some touch the surface.
                EXPECT_LT(tightest, kNearly);
            }
        }
    }
}

TEST(ConservativeCones, SectorsAreNoSteeperThanTheWhole) {
    const HeightField field(walls(32, 32, 23), Surface::Bilinear, Address::Repeat, 0.3);
    const ConeMap whole = built(ConeKind::Conservative, 1, field);
    const ConeMap parts = built(ConeKind::Conservative, 8, field);
    double sum = 0;
    double sumWhole = 0;
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
            float steepest = 0;
            for (int k = 0; k < 8; ++k) {
                steepest = std::max(steepest, parts.slopes(x, y, k));
                sum += static_cast<double>(parts.slopes(x, y, k)) / 8;
            }
            // Each slope within its slack of the same exact value.
            ASSERT_NEAR(steepest, whole.slopes(x, y, 0), kConeSlack * 1.001 * static_cast<double>(steepest))
                << x << ", " << y;
            sumWhole += static_cast<double>(whole.slopes(x, y, 0));
        }
    }
    EXPECT_LT(sum, 0.95 * sumWhole);
}

TEST(ConservativeCones, AreTheSameForAnyTargetAndThreads) {
    for (const Address address : allAddresses()) {
        const HeightField field(share(makeRelief("hills", 150, 70, 4)), Surface::Bilinear, address, 0.3);
        ConeParameters parameters;
        parameters.sectors = 4;
        Work one(1);
        const ConeMap expected = buildConeMap(ConeKind::Conservative, parameters, field, one);
        SCOPED_TRACE(describe(field));
        onEveryTarget([&] {
            Work work(3);
            const ConeMap map = buildConeMap(ConeKind::Conservative, parameters, field, work);
            EXPECT_TRUE(map.apex.codes() == expected.apex.codes());
            EXPECT_TRUE(map.slopes.codes() == expected.slopes.codes());
        });
    }
}

TEST(DummersCones, AreTheSteepestOverAllTexelCentres) {
    for (const Address address : allAddresses()) {
        for (const auto& [width, height] : sizes()) {
            const HeightField field(walls(width, height, 24), Surface::Bilinear, address, 0.3);
            SCOPED_TRACE(describe(field));
            const ConeMap map = built(ConeKind::Dummer, 1, field);
            const int around = address == Address::Repeat ? 1 : 0;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    const double own = static_cast<double>(field.texel(x, y));
                    double kappa = 0;
                    for (int j = -around * height; j < height * (1 + around); ++j) {
                        for (int i = -around * width; i < width * (1 + around); ++i) {
                            if (i == x && j == y) continue;
                            const double way = std::hypot(i - x, j - y);
                            if (way >= std::hypot(width, height)) continue;
                            kappa = std::max(kappa, (static_cast<double>(field.texel(i, j)) - own) / way);
                        }
                    }
                    ASSERT_NEAR(map.slopes(x, y, 0), kappa, kFloatRounding * (1 + kappa)) << x << ", " << y;
                }
            }
        }
    }
}

UnfilledVector<float> relaxedSlopes(const HeightField& field, int directions, int radius, int threads) {
    Work work(threads);
    UnfilledVector<float> slopes(field.heights().size());
    relaxedCones(field, directions, radius, slopes, work);
    return slopes;
}

// Compares every texel with the reference, bit by bit, on every instruction set. Returns the smallest slope above 0.
float expectTheReference(const HeightField& field, int directions, int radius) {
    SCOPED_TRACE(describe(field) + ", " + std::to_string(directions) + " azimuths, radius " + std::to_string(radius));
    UnfilledVector<float> expected;
    float least = 1;
    for (int y = 0; y < field.height(); ++y) {
        for (int x = 0; x < field.width(); ++x) {
            const int reach = std::min(radius, std::max(field.width(), field.height()));
            expected.push_back(static_cast<float>(relaxedSlope(field, directions, reach, x, y)));
            if (expected.back() > 0) least = std::min(least, expected.back());
        }
    }
    onEveryTarget([&] {
        EXPECT_EQ(relaxedSlopes(field, directions, radius, 1), expected);
        EXPECT_EQ(relaxedSlopes(field, directions, radius, 3), expected);
    });
    return least;
}

// Narrow maps wrap several times within the radius; long ones have columns at which rounding moves a sample to the
// neighbouring texel.
TEST(RelaxedCones, AreTheReferenceToTheBit) {
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const auto& [width, height] :
                 std::vector<std::pair<int, int>>{{13, 9}, {16, 16}, {1, 5}, {3, 3}, {1, 1}, {19, 35}, {150, 2}}) {
                const HeightField field(walls(width, height, 21), surface, address, 0.3);
                expectTheReference(field, 16, 64);
                expectTheReference(field, 7, 5);
            }
            for (const char* relief : {"hills", "fractal", "bricks", "spikes"}) {
                expectTheReference(HeightField(share(makeRelief(relief, 41, 30, 3)), surface, address, 0.3), 16, 64);
            }
        }
    }
}

TEST(RelaxedCones, AreTheReferenceOnLevelGround) {
    for (const Address address : allAddresses()) {
        for (const float height : {0.93F, 0.3F, 1.0F, 0.0F}) {
            expectTheReference(HeightField(constantHeights(21, 18, height), Surface::Bilinear, address, 0.3), 16, 64);
        }
        FloatImage image = makeRelief("hills", 40, 20, 5);
        for (float& h : image.pixels()) h = 0.9F + 1e-6F * h;
        expectTheReference(HeightField(share(std::move(image)), Surface::Bilinear, address, 0.3), 16, 64);
    }
}

// The apex is the greatest float below the height at which a ray over a wall leaves it.
TEST(RelaxedCones, AreTheReferenceWhereRoundingDecides) {
    float least = 1;
    for (int n = 0; n < 20; ++n) {
        const float top = 0.142858F + 1e-7F * static_cast<float>(n);
        const double exit = 1 + (static_cast<double>(top) - 1) / 6 * 7;
        FloatImage image(30, 1, 0.0F);
        image(10, 0) = std::nextafter(static_cast<float>(exit), 0.0F);
        image(15, 0) = image(16, 0) = top;
        const HeightField field(share(std::move(image)), Surface::Columns, Address::Clamp, 0.3);
        least = std::min(least, expectTheReference(field, 4, 64));
    }
    EXPECT_LT(least, 1e-12F);
}

// In the vertical plane of a row: a wall 5 texels away of height 0.5, 3 texels thick, hides the floor behind it from
// above, so that a ray over the first texel of its top leaves the wall at its far edge.
TEST(RelaxedCones, EndWhereARayLeavesAWall) {
    FloatImage image(64, 1, 0.0F);
    for (int x = 15; x < 18; ++x) image(x, 0) = 0.5F;
    const HeightField field(share(std::move(image)), Surface::Columns, Address::Clamp, 0.3);
    // The highest such ray enters at the last texel of the top, at a distance of 7, and is outside at 8.
    EXPECT_FLOAT_EQ(relaxedSlopes(field, 4, 64, 1)[10], static_cast<float>((1 - 0.5 / 7 * 8) / 8));
}

// A ray that touches the top of a spike is on the surface there, whatever the rounding of its height: the spike bounds
// the cones of all texels in its row, also where it is higher than the middle of the slab.
TEST(RelaxedCones, EndBehindEverySpike) {
    for (const Surface surface : allSurfaces()) {
        for (int n = 1; n <= 40; ++n) {
            const float top = 0.025F * static_cast<float>(n);
            FloatImage image(96, 1, 0.0F);
            image(48, 0) = top;
            const HeightField field(share(std::move(image)), surface, Address::Clamp, 0.3);
            const UnfilledVector<float> slopes = relaxedSlopes(field, 4, 64, 1);
            for (int away = 2; away <= 40; ++away) {
                const double height = 1 + (static_cast<double>(top) - 1) / away * (away + 1);
                const double needed = height / (away + 1);
                for (const int x : {48 - away, 48 + away}) {
                    EXPECT_GE(slopes[static_cast<std::size_t>(x)], needed * (1 - 1e-6)) << top << " " << x;
                }
            }
        }
    }
}

}  // namespace
}  // namespace relief::test
