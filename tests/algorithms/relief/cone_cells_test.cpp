// What is shown is what drew the pixel: lanes look at the cells that the reference logs, one by one.
#include "algorithms/relief/cone_cells.h"

#include <gtest/gtest.h>

#include "lanes.h"
#include "relief/cone_walk.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261124;

// The steps that lanes take as well; those in double, next to corners, are no business of theirs.
struct FloatSteps {
    std::vector<Step> steps;
    bool off = false;

    template <class Make>
    void step(const Make& make) {
        if (!off) steps.push_back(make());
    }
    void read(std::uint32_t) {}
    void inDouble(bool now) { off = now; }
};

struct Logged {
    Hit hit;
    std::vector<LookedAt> cells;
    std::vector<Step> steps;  // of these cells
};

// The word of a step, as far as its record tells: that of its cell in the ray's quadrant.
Logged logged(const ConeWalk& walk, const PackedCones& cones, const ViewRay& ray, double begin) {
    FloatSteps sink;
    Logged out;
    out.hit = walk.trace(ray, begin, sink);
    const CellGrid& grid = walk.scene().grid;
    const std::uint32_t* const words = cones.quadrant(quadrantOf(GridRay(grid, ray)));
    for (const Step& step : sink.steps) {
        const auto* const cone = step.as<subject::Cone>();
        if (cone == nullptr) continue;
        const auto cx = static_cast<int>(step.i) - grid.x.firstName, cy = static_cast<int>(step.j) - grid.y.firstName;
        const std::uint32_t word = words[cones.index(cx, cy)];
        EXPECT_EQ(cone->apex, cones.heightAt(coneApexDepth(word)));
        if (step.decision == Decision::Advance) {
            EXPECT_EQ(step.value, static_cast<double>(coneSlope(word)));
        }
        out.cells.push_back({cx + step.periodX * grid.x.cells, cy + step.periodY * grid.y.cells, word});
        out.steps.push_back(step);
    }
    return out;
}

RayBlock finiteRays(const RayBlock& all) {
    RayBlock rays;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].finite()) rays.push(all[i]);
    }
    return rays;
}

std::string textOf(const std::vector<LookedAt>& cells, std::size_t from) {
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
            const auto& wanted = reference[i].cells;
            const auto& found = lanes[i].cells;
            if (found == wanted) continue;
            ++different;
            const auto at = static_cast<std::size_t>(
                std::mismatch(wanted.begin(), wanted.end(), found.begin(), found.end()).first - wanted.begin());
            ADD_FAILURE() << describe(field) << ", ray " << i << ": " << describe(rays[i]) << ": step " << at << " of "
                          << wanted.size() << " and " << found.size() << ":" << textOf(wanted, at) << " and in lanes"
                          << textOf(found, at);
        }
    });
}

TEST(ConeCells, lanesLookAtThoseThatTheReferenceLogs) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    constexpr std::size_t kRays = 400;
    std::size_t steps = 0;
    for (const auto& [width, height] :
         std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {5, 3}, {16, 17}, {100, 3}, {64, 64}}) {
        const Heights heights = width == 64 ? share(makeRelief("spikes", width, height, kSeed))
                                            : randomHeights(width, height, kSeed);
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                for (const double depth : {0.02, 0.9}) {
                    const HeightField field(heights, surface, address, depth);
                    expectSameCells(field, finiteRays(awkwardRays(field, kSeed, kRays)), steps);
                }
            }
        }
    }
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 100000U);
}

}  // namespace
}  // namespace relief::test
