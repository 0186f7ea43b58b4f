// The grid filter's SIMD work on the pixels and cells of a tile, against the same one by one.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "algorithms/every_target.h"
#include "filtering/grid_lanes.h"
#include "filtering/grid_stages.h"
#include "grid_cases.h"

namespace relief::test {
namespace {

constexpr int kAcross = 6, kDown = 5;
constexpr double kLargest = 100;

// Pixels of one tile, row by row.
FilterBlock tileBlock(std::size_t count, const PixelView* view, Random& random) {
    FilterBlock block;
    block.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto n = static_cast<int>(i);
        block.place(i, {random.between(0, 9), random.between(0, 9)}, randomJacobian(random, 3));
        block.view[i] = view, block.exact[i] = 1;
        block.x[i] = 64 + n % 50, block.y[i] = 32 + n / 50;
    }
    return block;
}

TEST(GridTiles, aScanFindsTheRectangleAndEveryPixelThatDiffers) {
    Random random(kSeed);
    const PixelView view, other;
    for (const std::size_t count : {1U, 5U, 16U, 17U, 31U, 100U}) {
        const FilterBlock block = tileBlock(count, &view, random);
        onEveryTarget([&] {
            const auto scan = [&](const FilterBlock& of) { return scanTile(of, 0, count, kAcross, kDown, kLargest); };
            const TileScan all = scan(block);
            EXPECT_TRUE(all.same && all.usable);
            EXPECT_EQ(all.x0, 64);
            EXPECT_EQ(all.x1, 63 + std::min(static_cast<int>(count), 50));
            EXPECT_EQ(all.y0, 32);
            EXPECT_EQ(all.y1, 32 + (static_cast<int>(count) - 1) / 50);
            for (std::size_t i = 1; i < count; ++i) {
                FilterBlock changed = block;
                changed.view[i] = &other;
                EXPECT_FALSE(scan(changed).same) << i;
                changed = block, changed.x[i] = 128;
                EXPECT_FALSE(scan(changed).same) << i;
                changed = block, changed.y[i] = 31;
                EXPECT_FALSE(scan(changed).same) << i;
                changed = block, changed.exact[i] = 0;
                EXPECT_FALSE(scan(changed).usable) << i;
                for (const double side : {kLargest, std::nan("")}) {
                    changed = block, changed.vy[i] = side;
                    EXPECT_FALSE(scan(changed).usable) << i;
                }
                EXPECT_TRUE(scan(changed).same) << i;
            }
        });
    }
}

TEST(GridTiles, copiedHitsAreThePolygonsOwn) {
    constexpr std::size_t kHits = 200;
    Random random(kSeed);
    HitBlock hits;
    hits.resize(kHits);
    std::vector<std::uint8_t> polygon(kHits);
    for (std::size_t i = 0; i < kHits; ++i) {
        const bool odd = i >= 100 && random.between(0, 1) < 0.3, missed = i >= 100 && random.between(0, 1) < 0.3;
        polygon[i] = odd ? 4 : 3;
        hits.set(i, {missed ? Outcome::Miss : Outcome::Hit, random.between(0, 1), random.between(0, 1),
                     0.25 * random.between(0, 1)});
    }
    const PictureHits picture{20, 10, polygon.data(), nullptr, &hits};
    onEveryTarget([&] {
        for (const auto& [from, count] : {std::pair<std::size_t, std::size_t>{0, 100}, {7, 3}, {90, 21}, {100, 100}}) {
            std::vector<double> s(count + kCellSlack), t(s), lambda(s);
            std::vector<float> pictureS(count + kCellSlack), pictureT(pictureS), floatLambda(pictureS);
            std::vector<std::uint8_t> known(count + 1, 9);
            const bool all = copyHits(picture, from, count, 3, {2, 3},
                                      {s.data(), t.data(), lambda.data(), pictureS.data(), pictureT.data(),
                                       floatLambda.data(), known.data()});
            EXPECT_EQ(known[count], 9);
            EXPECT_EQ(all, from + count <= 100);
            for (std::size_t n = 0; n < count; ++n) {
                const std::size_t i = from + n;
                ASSERT_EQ(known[n], polygon[i] == 3 ? 1 : 0) << i;
                if (polygon[i] != 3 || hits.outcome[i] != Outcome::Hit) {
                    ASSERT_TRUE(std::isnan(s[n]) && std::isnan(pictureS[n])) << i;
                    continue;
                }
                ASSERT_EQ(s[n], hits.s[i]);
                ASSERT_EQ(t[n], hits.t[i]);
                ASSERT_EQ(lambda[n], hits.lambda[i]);
                ASSERT_EQ(pictureS[n], static_cast<float>(2 * hits.s[i]));
                ASSERT_EQ(pictureT[n], static_cast<float>(3 * hits.t[i]));
                ASSERT_EQ(floatLambda[n], static_cast<float>(hits.lambda[i]));
            }
        }
    });
}

TEST(GridTiles, pixelsAreSplitByTheirSurroundings) {
    constexpr std::size_t kRow = 40, kCells = 3 * kRow, kCell = kRow + 3, kPixels = 29, kFirst = 11;
    Random random(kSeed);
    const FilterBlock block = tileBlock(kFirst + kPixels, nullptr, random);
    std::vector<double> s(kCells + kCellSlack), t(s);
    std::vector<std::uint16_t> around(kCells + kCellSlack);
    for (std::size_t c = 0; c < kCells; ++c) {
        s[c] = random.between(-1, 1), t[c] = random.between(-1, 1);
        around[c] = static_cast<std::uint16_t>(std::array{0, +kOnPlane, kOnPlane | kOnLevel, 255}[c % 7 % 4]);
    }
    onEveryTarget([&] {
        SplitColumns split;
        split.refill(kPixels);
        splitRun({&block, s.data(), t.data(), kRow, around.data(), {2, 3}}, kFirst, kPixels, kCell, split);
        std::size_t planes = 0, edges = 0;
        for (std::size_t n = 0; n < kPixels; ++n) {
            const std::size_t i = kFirst + n, c = kCell + n;
            if ((around[c] & kOnPlane) == 0) {
                ASSERT_EQ(split.edges[edges++], i);
                continue;
            }
            ASSERT_EQ(split.planeOf[planes], i);
            const FilterQuery query = split.planes[planes++];
            const auto half = [&](const std::vector<double>& of, std::size_t way) {
                return 0.5 * (of[c + way] - of[c - way]);
            };
            const Jacobian own{block.ux[i], block.vx[i], block.uy[i], block.vy[i]};
            const Jacobian seen{half(s, 1), half(t, 1), half(s, kRow), half(t, kRow)};
            const Jacobian& j = (around[c] & kOnLevel) != 0 ? own : seen;
            ASSERT_EQ(query.place, glm::dvec2(2 * block.s[i], 3 * block.t[i]));
            ASSERT_EQ(query.jacobian.ux, 2 * j.ux);
            ASSERT_EQ(query.jacobian.vx, 3 * j.vx);
            ASSERT_EQ(query.jacobian.uy, 2 * j.uy);
            ASSERT_EQ(query.jacobian.vy, 3 * j.vy);
        }
        EXPECT_EQ(split.planeCount, planes);
        EXPECT_EQ(split.edgeCount, edges);
        EXPECT_GT(planes, 5U);
        EXPECT_GT(edges, 5U);
    });
}

std::vector<std::uint16_t> randomBits(std::size_t count, Random& random) {
    std::vector<std::uint16_t> bits(count + kCellSlack);
    for (std::size_t c = 0; c < count; ++c) bits[c] = static_cast<std::uint16_t>(random.between(0, 8));
    return bits;
}

TEST(GridTiles, placesAreOfPointsThatAreNeededAndNotInterpolated) {
    constexpr std::size_t kRow = 37, kPoint = 2;
    Random random(kSeed);
    const auto needed = randomBits(2 * kRow, random), interpolated = randomBits(2 * kRow, random);
    onEveryTarget([&] {
        std::vector<double> x(kRow + kPointSlack), y(x);
        std::vector<std::uint32_t> slots(kRow + kPointSlack);
        const PlacesJob job{needed.data(), interpolated.data(), kPoint, 3, kRow, 5 * kRow, 10.5, 1.0 / 3, 7.25};
        const std::size_t count = listPlaces(job, x.data(), y.data(), slots.data());
        std::size_t n = 0;
        for (std::size_t c = 0; c < kRow; ++c) {
            if ((needed[c] & ~interpolated[c] & (1U << kPoint)) == 0) continue;
            ASSERT_EQ(x[n], static_cast<double>(c) + 10.5 + 1.0 / 3);
            ASSERT_EQ(y[n], 7.25);
            ASSERT_EQ(slots[n++], (5 * kRow + c) * 3 + kPoint);
        }
        EXPECT_EQ(count, n);
        EXPECT_GT(n, 5U);
    });
}

// One cell's line crosses an edge: no point of the squares with that line is interpolated, and every other point is.
TEST(GridTiles, pointsAreInterpolatedUnlessALineOfTheirSquareCrossesAnEdge) {
    grid::TileCells cells;
    cells.width = 9, cells.height = 8;
    const PointLattice lattice = PointLattice::of(5);
    const FilterBlock block;
    const std::size_t edge = cells.at(4, 3);
    for (unsigned line = 0; (kAllLines >> line) != 0; ++line) {
        grid::BitColumn around(cells.count() + kCellSlack, kAllLines * kSmooth);
        around[edge] = static_cast<std::uint16_t>(around[edge] & ~(unsigned{kSmooth} << line));
        onEveryTarget([&] {
            grid::BitColumn mask;
            grid::PointPlan plan;
            grid::planCells({lattice, block, {}, cells, around}, mask, plan);
            for (std::size_t k = 1; k < lattice.places.size(); ++k) {
                for (std::size_t c = cells.inner(); c < cells.count() - cells.inner(); ++c) {
                    const std::size_t first = c - static_cast<std::size_t>(lattice.squareOf(k, cells.width));
                    const bool falling = edge == first || edge == first + cells.row() + 1;
                    const bool rising = edge == first + 1 || edge == first + cells.row();
                    const bool crossed = (falling && line != kRising) || (rising && line != kFalling);
                    ASSERT_EQ((plan.interpolated[c] >> k & 1) != 0, !crossed) << line << ' ' << k << ' ' << c;
                }
            }
        });
    }
}

TEST(GridTiles, meansReplacePointsOfUniformSquares) {
    constexpr std::size_t kRow = 12, kCells = 7 * kRow, kFirst = kRow + 1, kLast = kCells - kFirst, kPoint = 1;
    Random random(kSeed);
    const auto needed = randomBits(kCells, random);
    std::vector<std::uint16_t> uniform(kCells + kCellSlack);
    for (std::size_t c = 0; c < kCells; ++c) uniform[c] = random.between(0, 1) < 0.5 ? 0xFFFF : 0;
    std::vector<PointColor> colors((kCells + kCellSlack) * 3);
    for (PointColor& color : colors) {
        for (float& channel : color.channel) channel = static_cast<float>(random.between(0, 1));
    }
    const MeanJob job{kRow, kRow, 3, kPoint, {0.5F, 0.125F, 0.25F, 0.0625F}};
    onEveryTarget([&] {
        auto left = needed;
        auto found = colors;
        meanUniform(job, kFirst, kLast, uniform.data(), left.data(), found.data());
        int means = 0;
        for (std::size_t c = 0; c < kCells; ++c) {
            const bool mean = c >= kFirst && c < kLast && (needed[c] & uniform[c - kRow] & (1U << kPoint)) != 0;
            means += mean ? 1 : 0;
            ASSERT_EQ(left[c], mean ? needed[c] & ~(1U << kPoint) : needed[c]) << c;
            const PointColor* at = colors.data() + (c - (mean ? kRow : 0)) * 3;
            for (std::size_t n = 0; n < 4; ++n) {
                const auto of = [&](std::size_t cell, std::size_t k) { return job.share[k] * at[3 * cell].channel[n]; };
                const float expected =
                    mean ? (of(0, 0) + of(1, 1)) + (of(kRow, 2) + of(kRow + 1, 3)) : colors[c * 3 + kPoint].channel[n];
                ASSERT_EQ(found[c * 3 + kPoint].channel[n], expected) << c;
                ASSERT_EQ(found[c * 3].channel[n], colors[c * 3].channel[n]) << c;
            }
        }
        EXPECT_GT(means, 5);
    });
}

}  // namespace
}  // namespace relief::test
