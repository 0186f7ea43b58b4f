// The displayed steps are those that rendered the pixel: SIMD visits the cells that the reference logs, one by one.
#include "cone_cells.h"

#include <array>
#include <set>

#include <gtest/gtest.h>

#include "lanes.h"
#include "relief/methods/cone_walk.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261124;

struct Logged {
    Hit hit;
    std::vector<VisitedCell> cells;
    std::vector<Step> steps;  // one per cell
};

// Traces the ray with the reference and returns its cells; checks each step's record against the map entry of its cell
// in the ray's quadrant.
Logged logged(const ConeWalk& walk, const PackedCones& cones, const ViewRay& ray, double begin) {
    // Only the steps in float, which SIMD takes as well; those in double, next to corners, are left to the reference.
    LogSink sink;
    NullSink inDouble;
    Logged out;
    out.hit = walk.trace(ray, begin, sink, inDouble);
    const CellGrid& grid = walk.scene().grid;
    const std::uint32_t* const words = cones.quadrant(quadrantOf(GridRay(grid, ray)));
    for (const Step& step : sink.steps) {
        const auto* const cone = step.as<subject::Cone>();
        const bool ofCell =
            step.decision == Decision::Skip || step.decision == Decision::Test || step.decision == Decision::Hit;
        if (cone == nullptr && !ofCell) continue;
        const auto cx = static_cast<int>(step.i) - grid.x.firstName, cy = static_cast<int>(step.j) - grid.y.firstName;
        const std::uint32_t word = words[cones.index(cx, cy)];
        if (cone != nullptr) {
            EXPECT_EQ(cone->apex, cones.heightAt(coneApexDepth(word)));
            EXPECT_GT(1 - step.lambdaOut, cone->apex) << "the cone makes no claim below its apex";
        }
        EXPECT_EQ(step.value,
                  cone != nullptr ? static_cast<double>(coneSlope(word)) : cones.heightAt(coneOwnDepth(word)));
        out.cells.push_back({cx + step.periodX * grid.x.cells, cy + step.periodY * grid.y.cells, word});
        out.steps.push_back(step);
    }
    return out;
}

// Returns the finite rays, each once.
RayBlock differentRays(const RayBlock& all) {
    RayBlock rays;
    std::set<std::array<double, 4>> seen;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool other = all[i].finite() && seen.insert({all.s0[i], all.t0[i], all.a[i], all.b[i]}).second;
        if (other) rays.push(all[i]);
    }
    return rays;
}

std::string textOf(const std::vector<VisitedCell>& cells, std::size_t from) {
    std::string text;
    for (std::size_t n = from; n < std::min(from + 4, cells.size()); ++n) {
        text += " (" + std::to_string(cells[n].x) + ", " + std::to_string(cells[n].y) + ")";
    }
    return text;
}

void expectSameCells(const HeightField& field, const RayBlock& rays, std::size_t& steps) {
    Work work(1);
    MapCache cache;
    const auto cones = packedCones(field, cache, work);
    const ConeWalk walk(field, *cones);
    std::vector<Logged> reference;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        reference.push_back(logged(walk, *cones, rays[i], walk.scene().start));
        steps += reference.back().cells.size();
    }
    onEveryTarget([&] {
        HitBlock hits;
        const auto lanes = cellsInLanes(field, *cones, rays, hits, true);
        int different = 0;
        for (std::size_t i = 0; i < rays.size() && different < 3; ++i) {
            const auto& expected = reference[i].cells;
            const auto& found = lanes[i].cells;
            if (found == expected) continue;
            ++different;
            const auto at = static_cast<std::size_t>(
                std::mismatch(expected.begin(), expected.end(), found.begin(), found.end()).first - expected.begin());
            ADD_FAILURE() << describe(field) << ", ray " << i << ": " << describe(rays[i]) << ": step " << at << " of "
                          << expected.size() << " and " << found.size() << ":" << textOf(expected, at)
                          << " and in lanes" << textOf(found, at);
        }
    });
}

TEST(ConeCells, simdVisitsThoseThatTheReferenceLogs) {
    constexpr std::size_t kRays = 400;
    std::size_t steps = 0;
    onAwkwardMaps(kSeed, kRays, [&](const HeightField& field, const RayBlock& rays) {
        expectSameCells(field, differentRays(rays), steps);
    });
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 50000U);
}

// Rays of a view from above: neighbours have similar starts, so that packets form.
RayBlock viewRays(const HeightField& field, double flat) {
    RayBlock rays;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double s = 0.3 + 0.61 * x, t = 0.2 + 0.53 * y;
            rays.push({s, t, flat * (1 + 0.01 * x) * field.slabTexels(), flat * (0.4 + 0.02 * y) * field.slabTexels()});
        }
    }
    return rays;
}

// The end of a jump may differ by this share of its length, plus this many cells: the reciprocal is approximate, and
// sums are fused.
constexpr double kJumpShare = 3 * static_cast<double>(kReciprocalError);
constexpr double kJumpRounding = 0x1p-17;
// Largest share of steps before which a jump ended so near to a border that the cells differ.
constexpr double kMostDifferent = 0.001;

// Returns true if the jump of a step ends next to a border of cells.
bool endsAtABorder(const CellGrid& grid, const ViewRay& ray, const Step& step) {
    const GridRay exact(grid, ray);
    const double way = step.lambdaAfter - step.lambdaOut;
    for (const RayAxis& axis : {exact.x, exact.y}) {
        const double place = axis.start + step.lambdaAfter * axis.run;
        const double unsure = std::abs(axis.run) * (way * kJumpShare) + (std::abs(axis.run) + 1) * kJumpRounding;
        if (std::abs(place - std::round(place)) <= unsure) return true;
    }
    return false;
}

TEST(ConeCells, shippedSimdDiffersOnlyWhereJumpsEndAtABorder) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    std::size_t steps = 0, different = 0, led = 0, rays = 0;
    for (const char* name : {"spikes", "bricks", "fractal"}) {
        for (const Surface surface : allSurfaces()) {
            for (const double flat : {0.7, 6.0}) {
                const HeightField field(share(makeRelief(name, 96, 96, kSeed)), surface, Address::Repeat, 0.2);
                Work work(1);
                MapCache cache;
                const auto cones = packedCones(field, cache, work);
                const ConeWalk walk(field, *cones);
                const RayBlock block = viewRays(field, flat);
                onEveryTarget([&] {
                    HitBlock hits;
                    const auto lanes = cellsInLanes(field, *cones, block, hits, false);
                    for (std::size_t i = 0; i < block.size(); ++i) {
                        ++rays;
                        led += lanes[i].begin > walk.scene().start ? 1 : 0;
                        const Logged reference = logged(walk, *cones, block[i], lanes[i].begin);
                        ASSERT_TRUE(sameBits(reference.hit, hits[i])) << i;
                        const auto& expected = reference.cells;
                        const auto& found = lanes[i].cells;
                        steps += expected.size();
                        const auto at = static_cast<std::size_t>(
                            std::mismatch(expected.begin(), expected.end(), found.begin(), found.end()).first -
                            expected.begin());
                        if (at == expected.size() && at == found.size()) continue;
                        ++different;
                        ASSERT_GT(at, 0U) << "ray " << i << " begins in another cell";
                        EXPECT_TRUE(endsAtABorder(walk.scene().grid, block[i], reference.steps[at - 1]))
                            << describe(field) << ", ray " << i << ": " << describe(block[i]) << ": step " << at << ":"
                            << textOf(expected, at) << " and in lanes" << textOf(found, at);
                    }
                });
            }
        }
    }
    std::printf("%zu steps of %zu rays, %zu led by packets; %zu rays differ\n", steps, rays, led, different);
    EXPECT_GT(led, rays / 20) << "no packets";
    EXPECT_LT(static_cast<double>(different), kMostDifferent * static_cast<double>(steps));
}

}  // namespace
}  // namespace relief::test
