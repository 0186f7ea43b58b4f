#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "measuring/verify/stress_cases.h"
#include "relief/reliefs.h"

namespace relief {

namespace {

constexpr float kBelowOne = 1 - std::numeric_limits<float>::epsilon() / 2;
constexpr float kSmallest = std::numeric_limits<float>::denorm_min();

// Fills the map with height(x, y), row by row.
template <class Height>
StressMap filled(int width, int height, const Height& heightAt) {
    FloatImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image(x, y) = heightAt(x, y);
    }
    return {std::make_shared<FloatImage>(std::move(image)), "", 0};
}

StressMap constant(int width, int height, float value) {
    return filled(width, height, [&](int, int) { return value; });
}

float unit(Random& random) {
    return static_cast<float>(random.unit());
}

StressMap zero(int width, int height, Random&) {
    return constant(width, height, 0);
}
StressMap one(int width, int height, Random&) {
    return constant(width, height, 1);
}
StressMap level(int width, int height, Random& random) {
    constexpr std::array<float, 4> kLevels{0.5F, 0.1F, kBelowOne, 1.0F / 3};
    const int which = random.below(5);
    return constant(width, height, which < 4 ? kLevels[static_cast<std::size_t>(which)] : unit(random));
}

StressMap denormal(int width, int height, Random& random) {
    return filled(width, height, [&](int, int) {
        return random.below(4) == 0 ? kSmallest : static_cast<float>(random.unit()) * std::numeric_limits<float>::min();
    });
}

// One texel of height `special` on constant ground.
StressMap single(int width, int height, Random& random, float ground, float special) {
    const int i = random.below(width);
    const int j = random.below(height);
    return filled(width, height, [&](int x, int y) { return x == i && y == j ? special : ground; });
}
StressMap spike(int width, int height, Random& random) {
    const float ground = random.below(2) == 0 ? 0.0F : unit(random);
    return single(width, height, random, ground, 1);
}
StressMap pit(int width, int height, Random& random) {
    const float ground = random.below(2) == 0 ? 1.0F : unit(random);
    return single(width, height, random, ground, 0);
}

StressMap needles(int width, int height, Random& random) {
    return filled(width, height, [&](int, int) { return random.below(50) == 0 ? unit(random) : 0.02F; });
}
StressMap fineChecker(int width, int height, Random&) {
    return filled(width, height, [](int x, int y) { return static_cast<float>((x + y) % 2); });
}
StressMap plateaus(int width, int height, Random& random) {
    std::array<float, 256> levels{};
    for (float& value : levels) value = static_cast<float>(random.below(9)) / 8;
    const int block = 1 + random.below(5);
    return filled(width, height, [&](int x, int y) {
        return levels[static_cast<std::size_t>((x / block) * 7 + (y / block) * 13) % levels.size()];
    });
}
StressMap roundings(int width, int height, Random& random) {
    const float middle = unit(random);
    return filled(width, height, [&](int, int) {
        const int which = random.below(3);
        if (which == 0) return middle;
        return std::clamp(std::nextafter(middle, which == 1 ? 0.0F : 1.0F), 0.0F, 1.0F);
    });
}
StressMap noise(int width, int height, Random& random) {
    return filled(width, height, [&](int, int) { return unit(random); });
}
// Constant slopes, so that a ray can lie in the surface.
StressMap ramps(int width, int height, Random& random) {
    const int period = 2 + random.below(30);
    const bool across = random.below(2) == 0;
    return filled(width, height, [&](int x, int y) {
        return static_cast<float>((across ? x : y) % period) / static_cast<float>(period);
    });
}
StressMap extremes(int width, int height, Random& random) {
    constexpr std::array<float, 8> kValues{0,         1,    kSmallest, std::numeric_limits<float>::min(),
                                           kBelowOne, 0.5F, 0.1F,      1e-20F};
    return filled(width, height,
                  [&](int, int) { return kValues[static_cast<std::size_t>(random.below(int{kValues.size()}))]; });
}

template <const char* kName>
StressMap recipe(int width, int height, Random& random) {
    const std::uint64_t seed = random.bits() % 1'000'000;
    return {std::make_shared<FloatImage>(makeRelief(kName, width, height, seed)), kName, seed};
}
constexpr char kBricks[] = "bricks";
constexpr char kCity[] = "city";
constexpr char kColumns[] = "columns";
constexpr char kFractal[] = "fractal";
constexpr char kHills[] = "hills";
constexpr char kSpikes[] = "spikes";

}  // namespace

const std::vector<StressMapFamily>& stressMapFamilies() {
    static const std::vector<StressMapFamily> families{
        {"zero", zero},
        {"one", one},
        {"level", level},
        {"denormal", denormal},
        {"spike", spike},
        {"pit", pit},
        {"needles", needles},
        {"fine-checker", fineChecker},
        {"plateaus", plateaus},
        {"roundings", roundings},
        {"noise", noise},
        {"ramps", ramps},
        {"extremes", extremes},
        {kBricks, recipe<kBricks>},
        {kCity, recipe<kCity>},
        {kColumns, recipe<kColumns>},
        {kFractal, recipe<kFractal>},
        {kHills, recipe<kHills>},
        {kSpikes, recipe<kSpikes>},
    };
    return families;
}

const std::vector<StressSize>& stressSizes() {
    static const std::vector<StressSize> sizes{{1, 1},   {1, 7},     {7, 1},     {2, 2},     {1, 1000},  {3, 2},
                                               {5, 3},   {65536, 1}, {1, 65536}, {65536, 2}, {8, 8},     {13, 9},
                                               {31, 17}, {64, 64},   {100, 3},   {129, 257}, {512, 512}, {33, 2},
                                               {2, 513}, {1023, 5},  {3, 16384}, {16384, 3}};
    return sizes;
}

}  // namespace relief
