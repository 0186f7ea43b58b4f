// Packed cones against all pairs of cells.
#include "relief/maps/packed_cones.h"

#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "algorithms/every_target.h"
#include "brute_cells.h"
#include "relief/reliefs.h"

namespace relief::test {
namespace {

// Of the slope's mantissa three bits are chosen; the bits below hold the depths, whatever these are.
constexpr double kWordSteeper = 1.125 * 1.00001;
// A window extends up to a quarter beyond its ring, and further by the blocks that a seam cuts.
constexpr double kRingsSteeper = 1.25;
constexpr double kSeamSteeper = 1.5;
constexpr double kApexRounding = 1e-6;

// Low ground with a few high texels, so that a window that misses one is noticed.
Heights needles(int width, int height, std::uint64_t seed) {
    Random random(seed);
    FloatImage image(width, height);
    for (float& h : image.pixels())
        h = static_cast<float>(random.below(40) == 0 ? random.unit() : 0.02 * random.unit());
    return share(std::move(image));
}

struct Quadrant {
    int index;
    int sideX() const { return (index & 1) != 0 ? -1 : 1; }
    int sideY() const { return (index & 2) != 0 ? -1 : 1; }
};

// What the cone of a cell must satisfy, computed from every cell of the quadrant.
struct Need {
    double above = -1;  // largest height of a cell above the stored cone
    // The required slope above the stored apex. Cells that lie behind the own one, within its block of 2^l cells, are
    // taken to be as far away as that level's first ring.
    double slope = 0;
};

Need needOf(const BruteCells& cells, const PackedCones& map, int x, int y, Quadrant quadrant) {
    constexpr int kFirstRing = 8;  // in blocks
    const std::uint32_t entry = map.quadrant(static_cast<std::size_t>(quadrant.index))[map.index(x, y)];
    const double apex = map.heightAt(coneApexDepth(entry));
    const auto kappa = static_cast<double>(coneSlope(entry));
    Need need;
    const auto from = [&](int at, int size, int side) {
        return cells.wraps ? 1 - size : (side > 0 ? -at : at + 1 - size);
    };
    const auto last = [&](int at, int size, int side) {
        return cells.wraps ? 2 * size : (side > 0 ? size - 1 - at : at);
    };
    const auto wrapped = [](int at, int size) { return (at + 4 * size) % size; };
    for (int dy = from(y, cells.ny, quadrant.sideY()); dy <= last(y, cells.ny, quadrant.sideY()); ++dy) {
        const int j = wrapped(y + dy * quadrant.sideY(), cells.ny);
        for (int dx = from(x, cells.nx, quadrant.sideX()); dx <= last(x, cells.nx, quadrant.sideX()); ++dx) {
            const int i = wrapped(x + dx * quadrant.sideX(), cells.nx);
            const double rise = static_cast<double>(cells.highest(i, j)) - apex;
            int gap = std::max({dx - 1, dy - 1, 0});
            if (std::min(dx, dy) >= 0) {
                need.above = std::max(need.above, rise - kappa * gap);
            } else {
                gap = std::max(gap, kFirstRing * (1 + std::max(-dx, -dy)));
            }
            if (gap > 0) need.slope = std::max(need.slope, rise / gap);
        }
    }
    return need;
}

PackedCones built(const HeightField& field, int threads) {
    Work work(threads);
    return buildPackedCones(field, work);
}

// The nodes of a cell are adjacent; neighbouring cells of a row share them.
void expectNodes(const HeightField& field, const PackedCones& map) {
    const bool bilinear = field.surface() == Surface::Bilinear;
    const std::size_t row = static_cast<std::size_t>(map.nx) + (bilinear ? 1 : 0);
    ASSERT_EQ(map.bytes(), row * static_cast<std::size_t>(map.ny) * (4U * 4U + (bilinear ? 8U : 0U)));
    if (!bilinear) return;
    const CellGrid grid(field);
    for (int y = 0; y < map.ny; ++y) {
        for (int x = 0; x < map.nx; ++x) {
            const std::size_t at = 2 * map.index(x, y);
            const int i0 = grid.x.nodeBefore(x), i1 = grid.x.nodeAfter(x);
            const int j0 = grid.y.nodeBefore(y), j1 = grid.y.nodeAfter(y);
            ASSERT_EQ(map.nodes[at], field.heights()(i0, j0)) << x << " " << y;
            ASSERT_EQ(map.nodes[at + 1], field.heights()(i0, j1)) << x << " " << y;
            ASSERT_EQ(map.nodes[at + 2], field.heights()(i1, j0)) << x << " " << y;
            ASSERT_EQ(map.nodes[at + 3], field.heights()(i1, j1)) << x << " " << y;
        }
    }
}

// every: only each such cell is examined.
void expectLaw(const HeightField& field, int every) {
    const BruteCells cells(field);
    const PackedCones map = built(field, 2);
    ASSERT_EQ(map.nx, cells.nx);
    ASSERT_EQ(map.ny, cells.ny);
    expectNodes(field, map);
    const double loosest = kWordSteeper * (cells.wraps ? kSeamSteeper : kRingsSteeper);
    for (int q = 0; q < 4; ++q) {
        for (int n = 0; n < cells.nx * cells.ny; n += every) {
            const int x = n % cells.nx;
            const int y = n / cells.nx;
            const std::uint32_t entry = map.quadrant(static_cast<std::size_t>(q))[map.index(x, y)];
            const auto kappa = static_cast<double>(coneSlope(entry));
            ASSERT_GE(kappa, static_cast<double>(std::numeric_limits<float>::min()));
            const auto highest = static_cast<double>(cells.highest(x, y));
            const double own = map.heightAt(coneOwnDepth(entry));
            ASSERT_GE(own, highest) << x << ", " << y;
            ASSERT_LE(own, highest + map.unit * 1.000001) << x << ", " << y;
            if (map.unit > 0 && coneOwnDepth(entry) < kConeDepths) {
                ASSERT_LT(map.heightAt(coneOwnDepth(entry) + 1), highest)
                    << "a deeper one would do: " << x << ", " << y;
            }
            ASSERT_LE(coneApexDepth(entry), coneOwnDepth(entry)) << x << ", " << y;
            const Need need = needOf(cells, map, x, y, {q});
            ASSERT_LE(need.above, 0) << x << ", " << y << " quadrant " << q;
            ASSERT_LE(kappa, need.slope * loosest + kApexRounding) << x << ", " << y << " quadrant " << q;
        }
    }
}

TEST(PackedCones, StandAboveEveryCellOfTheirQuadrant) {
    const std::vector<std::pair<int, int>> sizes{{1, 1}, {1, 5}, {2, 3}, {13, 9}, {16, 16}, {33, 70}, {67, 41}};
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const auto& [width, height] : sizes) {
                const HeightField field(needles(width, height, 31), surface, address, 0.3);
                SCOPED_TRACE(describe(field));
                expectLaw(field, 1);
            }
        }
    }
}

// Sizes larger than a tile in each direction, several levels of blocks, seams that cut blocks.
TEST(PackedCones, StandAboveEveryCellFarOff) {
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            for (const auto& [width, height] : std::vector<std::pair<int, int>>{{301, 67}, {70, 141}, {512, 3}}) {
                SCOPED_TRACE(std::to_string(width));
                for (const char* relief : {"hills", "spikes", "city"}) {
                    const HeightField field(share(makeRelief(relief, width, height, 3)), surface, address, 0.3);
                    SCOPED_TRACE(describe(field) + " " + relief);
                    expectLaw(field, 97);
                }
                // A single needle: each window must contain it.
                FloatImage one(width, height, 0.0F);
                one(width / 3, height / 2) = 1.0F;
                const HeightField field(share(std::move(one)), surface, address, 0.3);
                SCOPED_TRACE(describe(field) + " one needle");
                expectLaw(field, 13);
            }
        }
    }
}

// Walls whose cone an entry can store exactly, varied by a few roundings: slopes are rounded up from the exact value
// that the wall requires, not from a rounded one.
TEST(PackedCones, AreSteepEnoughWhereEntriesHoldSlopesExactly) {
    constexpr std::uint32_t kDepths = 0xFFFFF;  // depth bits of level ground and of its apex
    Random random(51);
    for (int n = 0; n < 400; ++n) {
        const int gap = 1 + random.below(12);
        const auto highest = static_cast<float>(random.between(0.5, 1));
        const auto about = static_cast<float>(random.between(0.001, 0.9 * static_cast<double>(highest)) / gap);
        const float slope = std::bit_cast<float>(std::bit_cast<std::uint32_t>(about) | kDepths);
        float wall = slope * static_cast<float>(gap);
        for (int k = 0; k < 4; ++k) wall = std::nextafter(wall, 0.0F);
        for (int k = 0; k < 9; ++k, wall = std::nextafter(wall, 1.0F)) {
            FloatImage image(gap + 3, 1, 0.0F);
            image(0, 0) = highest, image(gap + 2, 0) = std::min(wall, highest);
            const HeightField field(share(std::move(image)), Surface::Columns, Address::Clamp, 0.3);
            const PackedCones map = built(field, 1);
            const Need need = needOf(BruteCells(field), map, 1, 0, {0});
            ASSERT_LE(need.above, 0) << "gap " << gap << " wall " << wall << " highest " << highest;
        }
    }
}

TEST(PackedCones, OfAFlatReliefAreOpen) {
    for (const Surface surface : allSurfaces()) {
        const PackedCones map = built(HeightField(constantHeights(9, 5, 0.25F), surface), 1);
        EXPECT_EQ(map.unit, 0);
        EXPECT_EQ(map.heightAt(0), 0.25);
        for (int y = 0; y < map.ny; ++y) {
            for (int x = 0; x < map.nx; ++x) {
                for (std::size_t quadrant = 0; quadrant < 4; ++quadrant) {
                    const std::uint32_t entry = map.quadrant(quadrant)[map.index(x, y)];
                    ASSERT_EQ(entry & 0xFFFFF, 0U);
                    ASSERT_GE(coneSlope(entry), std::numeric_limits<float>::min());
                    ASSERT_LE(coneSlope(entry), kApexRounding);
                }
            }
        }
    }
}

TEST(PackedCones, AreTheSameForAnyTargetAndThreads) {
    const HeightField field(needles(201, 93, 33), Surface::Bilinear, Address::Repeat, 0.2);
    const PackedCones reference = built(field, 1);
    EXPECT_EQ(built(field, 2).entries, reference.entries);
    onEveryTarget([&] { EXPECT_EQ(built(field, 2).entries, reference.entries); });
}

TEST(PackedCones, AreKeptOnceForAllReliefDepths) {
    MapCache cache;
    Work work(2);
    const Heights heights = needles(20, 20, 34);
    const auto map = packedCones(HeightField(heights, Surface::Bilinear, Address::Repeat, 0.1), cache, work);
    EXPECT_EQ(packedCones(HeightField(heights, Surface::Bilinear, Address::Repeat, 0.7), cache, work), map);
    const auto clamped = packedCones(HeightField(heights, Surface::Bilinear, Address::Clamp, 0.1), cache, work);
    EXPECT_NE(clamped, map);
    EXPECT_EQ(packedCones(HeightField(heights, Surface::Bilinear, Address::Border, 0.1), cache, work), clamped);
}

TEST(PackedCones, ReportProgressStopAndRefuse) {
    const HeightField field(needles(400, 300, 35), Surface::Bilinear, Address::Repeat, 0.1);
    // The second consists of whole tiles.
    for (const HeightField& whole : {field, HeightField(needles(256, 64, 35), Surface::Columns)}) {
        double reported = 0;
        Work reporting(2, {}, [&](std::string_view, double fraction) { reported = std::max(reported, fraction); });
        buildPackedCones(whole, reporting);
        EXPECT_EQ(reported, 1) << describe(whole);
    }
    std::stop_source source;
    source.request_stop();
    Work stopped(2, source.get_token());
    EXPECT_THROW(buildPackedCones(field, stopped), Cancelled);
    MapCache small(1000);
    Work work(1);
    EXPECT_THROW(packedCones(field, small, work), InputError);
}

}  // namespace
}  // namespace relief::test
