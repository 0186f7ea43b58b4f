// Tracers that use maps, with random options, depths, sizes and addressing: the same bits as `exact`.
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "relief/cell_grid.h"
#include "relief/files.h"
#include "relief/tracers/map_choice.h"

namespace relief::test {
namespace {

constexpr std::size_t kRaysEach = 4000;
constexpr std::uint64_t kSeed = 20000;

template <class T, std::size_t N>
const T& oneOf(Random& random, const T (&all)[N]) {
    return all[random.below(static_cast<int>(N))];
}

// Walls, needles and pits added to the procedural reliefs; odd sizes, a single texel, long narrow pictures.
HeightField anyField(Random& random) {
    static const std::pair<int, int> sizes[] = {{1, 1},   {1, 7},   {2, 3},   {5, 64},  {13, 9},
                                                {31, 17}, {64, 64}, {100, 3}, {77, 53}, {96, 80}};
    static const char* const names[] = {"bricks", "spikes", "pits", "city", "columns", "fractal", "hills", "checker"};
    const auto& [width, height] = oneOf(random, sizes);
    const int kind = random.below(10);
    const Heights heights = kind < 8 ? share(makeRelief(names[kind], width, height, random.bits()))
                                     : randomHeights(width, height, random.bits());
    const Surface surface = random.below(2) == 0 ? Surface::Bilinear : Surface::Columns;
    // Slabs from a tenth of a texel to a few picture widths.
    const double depth = 0.02 * std::pow(100.0, random.unit());
    return {heights, surface, allAddresses()[static_cast<std::size_t>(random.below(3))], depth};
}

OptionValues anyOptions(Random& random, const std::string& method) {
    const char* const precisions[] = {"float", "u16", "u8"};
    OptionValues options{{"precision", oneOf(random, precisions)}};
    if (method == "cone") {
        const char* const sectors[] = {"1", "2", "3", "4", "5", "8"};
        options["sectors"] = oneOf(random, sectors);
        return options;
    }
    options["footprint"] = std::to_string(1 + random.below(6));
    options["layers"] = std::to_string(1 + random.below(32));
    options["rule"] = random.below(2) == 0 ? "exit" : "classic";
    if (method == "distance-refined") {
        const char* const horizons[] = {"4", "8", "12", "16", "32"};
        options["horizons"] = oneOf(random, horizons);
        std::vector<std::string> divisors;
        for (int n = 1; n <= 32; ++n) {
            if (std::stoi(options["horizons"]) % n == 0) divisors.push_back(std::to_string(n));
        }
        options["sectors"] = divisors[static_cast<std::size_t>(random.below(static_cast<int>(divisors.size())))];
        options["flattest"] = numberText(random.between(1, 40));
    }
    return options;
}

class MapTracers : public testing::TestWithParam<const char*> {};

// 10^6 rays per method, 10^7 with RELIEF_LONG.
TEST_P(MapTracers, GiveTheBitsOfExactWhateverTheOptions) {
    const std::string method = GetParam();
    const std::size_t wanted = std::getenv("RELIEF_LONG") != nullptr ? 10'000'000 : 1'000'000;
    Work work(2);
    std::size_t total = 0;
    std::size_t steps = 0;
    std::size_t cells = 0;
    for (std::uint64_t seed = kSeed; total < wanted; ++seed) {
        Random random(seedFor(seed, 1));
        const HeightField field = anyField(random);
        MethodChoice choice{method, anyOptions(random, method)};
        if (random.below(4) == 0) {
            OptionValues outer{{"inner", method}, {"level", std::to_string(random.below(4))}};
            for (const auto& [name, value] : choice.options) outer[std::string(kInnerPrefix) + name] = value;
            choice = {"hybrid", outer};
        }
        if (!supports(choice, field.surface(), field.address())) continue;
        MapCache cache;
        const RayBlock rays = randomRays(seed, field, kRaysEach, 1);
        HitBlock truth;
        HitBlock hits;
        BlockCounts all;
        BlockCounts counts;
        makeTracer({"exact", {}}, field, cache, work)->trace(rays, truth, all, work);
        makeTracer(choice, field, cache, work)->trace(rays, hits, counts, work);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_TRUE(sameBits(truth[i], hits[i]))
                << describe(choice) << " on " << describe(field) << " seed " << seed << " ray " << describe(rays[i])
                << ": " << numberText(hits[i].lambda) << ", exact " << numberText(truth[i].lambda);
        }
        total += rays.size();
        if (const auto rule = choice.options.find("rule"); rule != choice.options.end() && rule->second == "classic") {
            continue;
        }
        steps += counts.steps;
        cells += all.steps;
    }
    // Shows that maps do save steps: if every voxel were a surface voxel, the test would prove nothing. The classic
    // step rule is excluded, because it takes very small steps.
    EXPECT_LT(steps, cells);
    std::cout << total << " rays, seeds from " << kSeed << ": identical bits, "
              << static_cast<double>(steps) / static_cast<double>(cells) << " of the steps of every cell\n";
}

INSTANTIATE_TEST_SUITE_P(All, MapTracers, testing::Values("distance-conservative", "distance-refined", "cone"),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::erase(name, '-');
                             return name;
                         });

// [DIST17]: "only the data change, the tracer does not". A stored refined map is used by the unchanged tracers.
TEST(DropIn, AStoredRefinedMapServesTheUnchangedTracers) {
    Work work(2);
    const HeightField field(share(makeRelief("bricks", 48, 40, 3)), Surface::Bilinear, Address::Repeat, 0.1);
    RayBlock rays = randomRays(91, field, 3000, 3);
    std::size_t flat = 0;
    MapCache building;
    HitBlock exact;
    NullSink sink;
    makeTracer({"exact", {}}, field, building, work)->trace(rays, exact, sink, work);
    struct Case {
        const char* tracer;
        const char* kind;
        const char* own;  // the tracer that this map was made for
    };
    for (const Case& c : {Case{"distance", "refined-sampled", "distance-refined-sampled"},
                          Case{"distance-conservative", "refined", "distance-refined"}}) {
        SCOPED_TRACE(c.tracer);
        const StoredMap map = buildMap(c.kind, {{"layers", "8"}, {"footprint", "2"}}, field, building, work);
        MapCache cache;
        const MethodChoice choice = useMap("map.tif", map, {c.tracer, {}}, field, cache);
        EXPECT_EQ(choice.options.at("map"), c.kind);
        const auto tracer = makeTracer(choice, field, cache, work);
        EXPECT_EQ(tracer->description().name, c.tracer);
        HitBlock hits;
        HitBlock own;
        tracer->trace(rays, hits, sink, work);
        const MethodChoice with = useMap("map.tif", map, {c.own, {}}, field, cache);
        makeTracer(with, field, cache, work)->trace(rays, own, sink, work);
        const double maxRun = std::get<std::shared_ptr<const DistanceMap>>(map)->maxRun;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_EQ(hits.outcome[i], own.outcome[i]) << describe(rays[i]);
            ASSERT_EQ(hits.lambda[i], own.lambda[i]) << describe(rays[i]);
            // Rays flatter than the map supports are still traced, and exactly.
            if (std::hypot(rays.a[i], rays.b[i]) <= maxRun) continue;
            ++flat;
            ASSERT_EQ(hits.lambda[i], exact.lambda[i]) << describe(rays[i]);
        }
        // The same map in place of one of another kind is refused.
        const MethodChoice wanted{c.tracer, {{"map", findTracer(c.tracer).maps.front()}}};
        EXPECT_THROW((void)useMap("map.tif", map, wanted, field, cache), InputError);
    }
    EXPECT_GT(flat, 100U);
}

// A ray flatter than the domain of exactness ends after as many steps as DistanceWalk::records() allows, besides its
// start and its end.
TEST(DropIn, ARayThatIsTooFlatGivesUpInTime) {
    const HeightField field(share(FloatImage(4, 4, 0.0F)), Surface::Bilinear, Address::Repeat, 1);
    MapCache cache;
    Work work(1);
    RayBlock rays;
    rays.push({0.5, 0.5, 2 * kMaxRun, 1});
    HitBlock hits;
    BlockCounts counts;
    makeTracer({"distance-conservative", {{"layers", "8"}}}, field, cache, work)->trace(rays, hits, counts, work);
    EXPECT_EQ(hits.outcome[0], Outcome::Limit);
    EXPECT_EQ(hits.steps[0], 2 * static_cast<std::uint32_t>(kFlatCells) + 8 + 4 + 2);
}

// The march that ends at the surface, on the shipped pictures with their own depth.
TEST(DistanceMarch, FewRaysAreOffByMoreThanHalfATexel) {
    constexpr double kMost = 0.06;
    constexpr int kSide = 128;  // side of a crop; the slab has the same depth in texels as for the whole picture
    Work work(2);
    struct Case {
        std::string name;
        Heights heights;
        double depth;
    };
    std::vector<Case> cases{{"bricks", share(makeRelief("bricks", 256, 256, 1)), 0.1},
                            {"fractal", share(makeRelief("fractal", 256, 256, 1)), 0.1}};
    for (const char* file : {"brick_tiles037/height.jpg", "gray_rocks/height.png", "stone_wall_bricks102/height.jpg",
                             "terrain_srtm_east_africa/height.png"}) {
        const FloatImage whole = readHeight(std::string(RELIEF_DATASETS) + "/" + file, {}, work).heights;
        FloatImage part(kSide, kSide);
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) part(x, y) = whole(x, y);
        }
        cases.push_back({file, share(std::move(part)), 0.1 * whole.width() / kSide});
    }
    for (const Case& c : cases) {
        SCOPED_TRACE(c.name);
        MapCache cache;
        const HeightField field(c.heights, Surface::Bilinear, Address::Repeat, c.depth);
        const RayBlock rays = randomRays(61, field, 4000, 3);
        HitBlock exact;
        HitBlock hits;
        NullSink sink;
        makeTracer({"max-pyramid", {}}, field, cache, work)->trace(rays, exact, sink, work);
        makeTracer({"distance", {}}, field, cache, work)->trace(rays, hits, sink, work);
        int wrong = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const double off = std::abs(hits.lambda[i] - exact.lambda[i]);
            wrong += off * std::max(1.0, std::hypot(rays.a[i], rays.b[i])) <= 0.5 ? 0 : 1;
        }
        EXPECT_LE(wrong, kMost * static_cast<double>(rays.size()));
    }
}

}  // namespace
}  // namespace relief::test
