// Tracers that walk maps, with options, depths, sizes and addressing at random: the same bits as `exact`.
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include "fields.h"

namespace relief::test {
namespace {

constexpr std::size_t kRaysEach = 4000;
constexpr std::uint64_t kSeed = 20000;

template <class T, std::size_t N>
const T& oneOf(Random& random, const T (&all)[N]) {
    return all[random.below(static_cast<int>(N))];
}

// Walls, needles and pits among what the recipes make; odd sizes, a single texel, long and thin.
HeightField anyField(Random& random) {
    static const std::pair<int, int> sizes[] = {{1, 1},   {1, 7},   {2, 3},   {5, 64},  {13, 9},
                                                {31, 17}, {64, 64}, {100, 3}, {77, 53}, {96, 80}};
    static const char* const names[] = {"bricks", "spikes", "pits", "city", "columns", "fractal", "hills", "checker"};
    const auto& [width, height] = oneOf(random, sizes);
    const int kind = random.below(10);
    const Heights heights = kind < 8 ? share(makeRelief(names[kind], width, height, random.bits()))
                                     : randomHeights(width, height, random.bits());
    const Surface surface = random.below(2) == 0 ? Surface::Bilinear : Surface::Columns;
    // Slabs of a tenth of a texel to a few picture widths.
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

// 10^6 rays a method, 10^7 with RELIEF_LONG.
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
    // Were every voxel a surface voxel, nothing would be shown. The classic rule creeps; that is its nature.
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

}  // namespace
}  // namespace relief::test
