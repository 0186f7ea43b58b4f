// The exact methods against each other, bit for bit, and against an independent computation in long double.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include "base/parallel.h"
#include "fields.h"
#include "measuring/random_rays.h"
#include "reference.h"
#include "relief/cell_grid.h"
#include "relief/files.h"

namespace relief::test {
namespace {

// Bound on |lambda - truth| x max(1, hypot(a, b)), in texels. The leaf computes in double with the parameter measured
// from the cell's entry: the error is 2^-53 times positions of some thousand texels times the slope of patches. Where a
// ray is tangent to a patch the error is the square root of that; such rays have a small clearance and are listed.
constexpr double kTexelBound = 1e-9;
// Height difference below which double cannot decide whether a ray hits or passes: results may differ there.
constexpr long double kTangent = 1e-13L;
constexpr std::size_t kPart = 1000;  // rays that a thread compares at a time

struct Compared {
    std::size_t rays = 0;
    std::size_t different = 0;
    std::size_t tangent = 0;
    double worst = 0;

    void add(const Compared& one) {
        rays += one.rays, different += one.different, tangent += one.tangent;
        worst = std::max(worst, one.worst);
    }
};

void compare(const HeightField& field, const ViewRay& ray, const Hit& hit, Compared& compared) {
    const reference::Answer truth = reference::trace(field, ray);
    ++compared.rays;
    const bool same = truth.hit == (hit.outcome == Outcome::Hit);
    double error = 0;
    if (same && truth.hit) {
        error = static_cast<double>(std::abs(truth.lambda - static_cast<long double>(hit.lambda))) *
                std::max(1.0, std::hypot(ray.a, ray.b));
    }
    if (same && error <= kTexelBound) {
        compared.worst = std::max(compared.worst, error);
        return;
    }
    if (truth.clearance < kTangent) {
        ++compared.tangent;
        std::cout << "  within rounding of a tangent: ray " << describe(ray) << " clearance "
                  << static_cast<double>(truth.clearance) << " error " << error << "\n";
        return;
    }
    ++compared.different;
    ADD_FAILURE() << describe(field) << "\nray " << describe(ray) << "\ntruth "
                  << (truth.hit ? numberText(static_cast<double>(truth.lambda)) : "miss") << ", got "
                  << numberText(hit.lambda) << " outcome " << static_cast<int>(hit.outcome) << " clearance "
                  << static_cast<double>(truth.clearance);
}

std::vector<std::pair<std::string, Heights>> proceduralMaps() {
    std::vector<std::pair<std::string, Heights>> maps;
    for (const char* name : {"bricks", "pits", "city", "columns", "fractal", "hills"}) {
        maps.emplace_back(name, share(makeRelief(name, 256, 256, 1)));
    }
    return maps;
}

std::vector<std::pair<std::string, Heights>> realMaps() {
    Work work;
    std::vector<std::pair<std::string, Heights>> maps;
    for (const char* name :
         {"stone_wall_bricks102/height.jpg", "gray_rocks/height.png", "terrain_srtm_east_africa/height.png"}) {
        maps.emplace_back(name, share(readHeight(std::string(RELIEF_DATASETS "/") + name, {}, work).heights));
    }
    return maps;
}

// Texels of the largest maps built without RELIEF_LONG: distance and cone maps of whole pictures take long, so crops
// are used.
constexpr std::size_t kBuildTexels = 70'000;

bool buildsAMap(const MethodChoice& choice) {
    const auto& maps = findTracer(choice.name).maps;
    const auto inner = choice.options.find("inner");
    return (!maps.empty() && maps.front() != "max-pyramid") ||
           (inner != choice.options.end() && buildsAMap({inner->second, {}}));
}

Heights part(const FloatImage& whole, int width, int height) {
    FloatImage image(width, height);
    const int x0 = (whole.width() - width) / 2, y0 = (whole.height() - height) / 2;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image(x, y) = whole(x + x0, y + y0);
    }
    return share(std::move(image));
}

// 10^6 rays over six procedural and three real maps, both surfaces, three addressings (10^7 with RELIEF_LONG).
TEST(Exactness, millionRaysGiveIdenticalBitsInEveryExactTracer) {
    const bool longRun = std::getenv("RELIEF_LONG") != nullptr;
    const std::size_t rayCount = longRun ? 10'000'000 : 1'000'000;
    auto maps = proceduralMaps();
    for (auto& real : realMaps()) {
        maps.push_back(real);
        maps.emplace_back(real.first + ", a part", part(*real.second, 200, 168));
    }
    const std::size_t perField = rayCount / (maps.size() * 6) + 1;
    MapCache cache;
    Work work;
    const std::vector<MethodChoice> exactChoices = choicesThatPromise(Guarantee::Exact);
    std::size_t total = 0;
    for (const auto& [name, heights] : maps) {
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(heights, surface, address, 0.1 + 0.1 * static_cast<double>(total % 3));
                SCOPED_TRACE(name + " " + describe(field));
                const RayBlock rays = randomRays(1000 + total, field, perField, 1);
                HitBlock truth;
                BlockCounts counts;
                makeTracer({"exact", {}}, field, cache, work)->trace(rays, truth, counts, work);
                for (const MethodChoice& choice : exactChoices) {
                    if (!supports(choice, surface, address)) continue;
                    if (heights->size() > kBuildTexels && !longRun && buildsAMap(choice)) continue;
                    HitBlock hits;
                    makeTracer(choice, field, cache, work)->trace(rays, hits, counts, work);
                    for (std::size_t i = 0; i < rays.size(); ++i) {
                        ASSERT_TRUE(sameBits(truth[i], hits[i]))
                            << describe(choice) << " ray " << describe(rays[i]) << ": " << numberText(truth[i].lambda)
                            << " against " << numberText(hits[i].lambda);
                        ASSERT_NE(hits[i].outcome, Outcome::Limit);
                    }
                }
                if (address != Address::Border) {
                    for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_EQ(truth.outcome[i], Outcome::Hit);
                }
                total += rays.size();
            }
        }
    }
    std::cout << total << " rays, seeds from 1000: identical bits\n";
}

// 33,600 rays, 10^8 with RELIEF_LONG.
TEST(Exactness, agreesWithLongDouble) {
    const std::size_t perField = std::getenv("RELIEF_LONG") != nullptr ? 1'200'000 : 400;
    auto maps = proceduralMaps();
    for (auto& real : realMaps()) maps.push_back(real);
    maps.emplace_back("noise 31 x 17", randomHeights(31, 17, 71));
    maps.emplace_back("noise 1 x 1", randomHeights(1, 1, 72));
    maps.emplace_back("noise 1 x 7", randomHeights(1, 7, 73));
    maps.emplace_back("noise 5 x 3", randomHeights(5, 3, 74));
    maps.emplace_back("noise 1023 x 511", randomHeights(1023, 511, 75));
    MapCache cache;
    Work work;
    Compared compared;
    for (const auto& [name, heights] : maps) {
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(heights, surface, address, 0.2);
                SCOPED_TRACE(name);
                const RayBlock rays = randomRays(99, field, perField, 1);
                HitBlock hits;
                BlockCounts counts;
                makeTracer({"max-pyramid", {}}, field, cache, work)->trace(rays, hits, counts, work);
                std::vector<Compared> parts((rays.size() + kPart - 1) / kPart);
                parallelFor(work, parts.size(), [&](std::size_t n) {
                    for (std::size_t i = n * kPart; i < std::min((n + 1) * kPart, rays.size()); ++i) {
                        compare(field, rays[i], hits[i], parts[n]);
                    }
                });
                for (const Compared& part : parts) compared.add(part);
            }
        }
    }
    std::cout << compared.rays << " rays, largest difference " << compared.worst << " texel, " << compared.tangent
              << " tangent within rounding\n";
    EXPECT_EQ(compared.different, 0U);
    EXPECT_LE(compared.tangent, compared.rays / 10000);
}

// Rays parallel to an axis, vertical, along cell borders, through corners, with distant origins, with both zeros.
std::vector<ViewRay> awkwardRays(int width, int height) {
    std::vector<ViewRay> rays;
    const std::vector<double> runs{0.0, -0.0, 0.25, -0.25, 1, -1, 3.5, -3.5, 40, -40, 1e-12, -1e-12, 1e-310};
    const std::vector<double> places{0.0, 0.5, 1.0, 0.25, 0.999999999};
    for (const double a : runs) {
        for (const double b : runs) {
            for (const double s : places) {
                for (const double t : places) {
                    rays.push_back({s * width, t * height, a, b});
                    rays.push_back({std::floor(s * width) + 0.5, std::floor(t * height), a, b});
                    rays.push_back({s * width + 1e6, t * height - 1e6, a, b});
                }
            }
        }
    }
    return rays;
}

TEST(Exactness, awkwardRaysAgreeInEveryTracer) {
    MapCache cache;
    Work work;
    const std::vector<MethodChoice> exactChoices = choicesThatPromise(Guarantee::Exact);
    for (const auto& [w, h] :
         std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {7, 1}, {5, 3}, {8, 8}, {33, 17}, {1023, 511}}) {
        for (const Heights& heights : {randomHeights(w, h, 81), constantHeights(w, h, 0), constantHeights(w, h, 1),
                                       share(makeRelief("checker", w, h, 1))}) {
            for (const Surface surface : allSurfaces()) {
                for (const Address address : allAddresses()) {
                    const HeightField field(heights, surface, address);
                    SCOPED_TRACE(describe(field));
                    RayBlock rays;
                    for (const ViewRay& ray : awkwardRays(w, h)) rays.push(ray);
                    HitBlock truth;
                    NullSink sink;
                    makeTracer({"exact", {}}, field, cache, work)->trace(rays, truth, sink, work);
                    for (const MethodChoice& choice : exactChoices) {
                        if (!supports(choice, surface, address)) continue;
                        if (heights->size() > kBuildTexels && buildsAMap(choice)) continue;
                        HitBlock hits;
                        makeTracer(choice, field, cache, work)->trace(rays, hits, sink, work);
                        for (std::size_t i = 0; i < rays.size(); ++i) {
                            ASSERT_TRUE(sameBits(truth[i], hits[i]))
                                << describe(choice) << " ray " << describe(rays[i]);
                            if (address != Address::Border) {
                                ASSERT_EQ(hits.outcome[i], Outcome::Hit);
                            }
                        }
                    }
                }
            }
        }
    }
}

// A bilinear surface has no borders with two valid answers, so the awkward rays must agree with the truth there, too.
TEST(Exactness, awkwardRaysAgreeWithLongDouble) {
    MapCache cache;
    Work work;
    Compared compared;
    for (const auto& [w, h] : std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {5, 3}, {8, 8}}) {
        for (const Address address : {Address::Repeat, Address::Clamp}) {
            const HeightField field(randomHeights(w, h, 83), Surface::Bilinear, address);
            const auto tracer = makeTracer({"max-pyramid", {}}, field, cache, work);
            for (const ViewRay& ray : awkwardRays(w, h)) {
                if (std::abs(ray.s0) > 1e5) continue;  // sorting the crossings for the truth is slow there
                compare(field, ray, traceLogged(*tracer, ray).hit, compared);
            }
        }
    }
    EXPECT_EQ(compared.different, 0U);
    std::cout << compared.rays << " rays, largest difference " << compared.worst << " texel\n";
}

// A run may be so long that positions within it cannot resolve cells. The index must still be one of the map, because
// otherwise memory beyond the map would be read.
TEST(Exactness, cellsOfAnyRunAreCellsOfTheMap) {
    constexpr std::uint64_t kCellSeed = 22;
    std::cout << "seed " << kCellSeed << '\n';
    Random random(kCellSeed);
    constexpr int kCases = 200000;
    for (int n = 0; n < kCases; ++n) {
        const int size = 1 + random.below(600);
        const GridAxis axis(size, random.below(2) == 0 ? Surface::Bilinear : Surface::Columns, Address::Repeat);
        const double run = std::ldexp(random.between(-1, 1), random.below(90));
        const RayAxis ray(axis, random.between(-2.0 * size, 3.0 * size), run);
        const AxisCell cell = ray.cellAt(axis, random.unit());
        ASSERT_GE(cell.index, 0) << size << " " << run;
        ASSERT_LT(cell.index, size) << size << " " << run;
    }
}

// Up to the domain's limit, a run of 2^20 texels, hits are exact; flatter rays end within the step bound, without NaN.
TEST(Exactness, flatRays) {
    MapCache cache;
    Work work;
    FloatImage low(64, 64, 0.0F);
    low(5, 9) = 1e-4F;
    const HeightField field(share(std::move(low)));
    for (const MethodChoice& choice : choicesThatPromise(Guarantee::Exact)) {
        const auto tracer = makeTracer(choice, field, cache, work);
        const auto exact = makeTracer({"exact", {}}, field, cache, work);
        RayBlock rays;
        rays.push({0.3, 0.7, kMaxRun, 0.01});
        rays.push({0.3, 0.7, -kMaxRun * 0.7, kMaxRun * 0.7});
        rays.push({0.3, 9.5, 1e9, 0});
        rays.push({0.3, 3.5, 1e300, -1e300});
        HitBlock hits;
        HitBlock truth;
        NullSink sink;
        tracer->trace(rays, hits, sink, work);
        exact->trace(rays, truth, sink, work);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_EQ(hits.outcome[i], Outcome::Hit) << describe(choice);
            EXPECT_TRUE(sameBits(hits[i], truth[i])) << describe(choice);
        }
        for (std::size_t i = 2; i < rays.size(); ++i) {
            EXPECT_NE(hits.outcome[i], Outcome::Unset);
            if (hits.outcome[i] == Outcome::Hit) {
                EXPECT_TRUE(std::isfinite(hits.lambda[i]));
            }
        }
    }
}

}  // namespace
}  // namespace relief::test
