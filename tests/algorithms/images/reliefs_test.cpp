#include "relief/reliefs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "images/recipe_rows.h"
#include "temporary_folder.h"

namespace relief {
namespace {

using testing::faultOf;

double share(const FloatImage& image, float low, float high) {
    const auto inside =
        std::count_if(image.pixels().begin(), image.pixels().end(), [&](float h) { return h >= low && h <= high; });
    return static_cast<double>(inside) / static_cast<double>(image.size());
}

// FNV-1a of the heights in 65535ths; integers and not the bytes of floats, so that it is the same on every machine.
std::uint64_t fingerprint(const FloatImage& image) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const float h : image.pixels())
        hash = (hash ^ static_cast<std::uint64_t>(std::lround(static_cast<double>(h) * 65535))) * 0x100000001b3ULL;
    return hash;
}

TEST(Reliefs, ListsThemAll) {
    std::set<std::string_view> names;
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        names.insert(recipe.name);
        EXPECT_FALSE(recipe.help.empty());
        EXPECT_EQ(recipe.anySize, recipe.name != "paper8x8");
        const FloatImage image = makeRelief(recipe.name, recipe.defaultSize, recipe.defaultSize, 1);
        EXPECT_EQ(image.width(), recipe.defaultSize);
    }
    EXPECT_EQ(names, (std::set<std::string_view>{"bricks", "spikes", "pits", "columns", "city", "fractal", "hills",
                                                 "steps", "checker", "paper8x8", "paper-walls"}));
}

TEST(Reliefs, AnySizeInZeroToOneInSixteenBitSteps) {
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        if (!recipe.anySize) continue;
        for (const auto& [width, height] :
             {std::pair{1, 1}, {1, 7}, {7, 1}, {2, 2}, {5, 3}, {31, 17}, {128, 128}, {1023, 511}, {1, 4096}}) {
            const FloatImage image = makeRelief(recipe.name, width, height, 3);
            ASSERT_EQ(image.width(), width);
            ASSERT_EQ(image.height(), height);
            for (const float h : image.pixels()) {
                ASSERT_TRUE(h >= 0 && h <= 1) << recipe.name;
                ASSERT_EQ(h, static_cast<float>(std::round(static_cast<double>(h) * 65535) / 65535)) << recipe.name;
            }
        }
    }
}

TEST(Reliefs, SeededAndRepeatable) {
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        const int size = recipe.anySize ? 64 : 8;
        const FloatImage image = makeRelief(recipe.name, size, size, 7);
        EXPECT_EQ(image, makeRelief(recipe.name, size, size, 7));
        const bool random = recipe.anySize && recipe.name != "checker" && recipe.name != "paper-walls";
        EXPECT_EQ(image != makeRelief(recipe.name, size, size, 8), random) << recipe.name;
    }
}

// Row by row, in any bands, and going on with what an earlier run has learned.
TEST(Reliefs, HaveTheSameHeightsByRows) {
    Work work(2);
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        for (const auto& [width, height] : {std::pair{64, 50}, {1, 3}, {37, 129}}) {
            if (!recipe.anySize) continue;
            const FloatImage image = makeRelief(recipe.name, width, height, 3);
            const auto rows = reliefHeightRows(recipe.name, width, height, 3);
            const auto again = reliefHeightRows(recipe.name, width, height, 3);
            ASSERT_EQ(rows->type(), NumberType::UInt16);
            rows->prepare(work);
            again->restore(rows->learned());
            for (HeightRows* source : {rows.get(), again.get()}) {
                for (int y = 0; y < height; y += 7) {
                    const int count = std::min(7, height - y);
                    std::vector<std::uint16_t> codes(static_cast<std::size_t>(width) * static_cast<std::size_t>(count));
                    source->read(y, count, reinterpret_cast<std::byte*>(codes.data()), work);
                    for (std::size_t i = 0; i < codes.size(); ++i) {
                        const int x = static_cast<int>(i) % width, row = y + static_cast<int>(i) / width;
                        ASSERT_EQ(static_cast<float>(codes[i]) / 65535.0F, image(x, row)) << recipe.name;
                    }
                }
            }
        }
    }
    const auto paper = reliefHeightRows("paper8x8", 8, 8, 1);
    ASSERT_EQ(paper->type(), NumberType::Float);
    std::vector<float> heights(64);
    paper->prepare(work);
    paper->read(0, 8, reinterpret_cast<std::byte*>(heights.data()), work);
    EXPECT_TRUE(std::ranges::equal(heights, makeRelief("paper8x8", 8, 8, 1).pixels()));
}

// Recorded values: another machine, compiler or option must not change a bit.
TEST(Reliefs, SameBitsEverywhere) {
    EXPECT_EQ(fingerprint(makeRelief("bricks", 128, 128, 1)), 0x9e041a934294a37dULL);
    EXPECT_EQ(fingerprint(makeRelief("spikes", 128, 128, 1)), 0x2722f77c6546fe5cULL);
    EXPECT_EQ(fingerprint(makeRelief("pits", 128, 128, 1)), 0xf00fb13f20781765ULL);
    EXPECT_EQ(fingerprint(makeRelief("columns", 128, 128, 1)), 0x54c0171d7be73bdeULL);
    EXPECT_EQ(fingerprint(makeRelief("city", 128, 128, 1)), 0x25a901c9bd914465ULL);
    EXPECT_EQ(fingerprint(makeRelief("fractal", 128, 128, 1)), 0x64841b86b0f0eb25ULL);
    EXPECT_EQ(fingerprint(makeRelief("hills", 128, 128, 1)), 0xa2ea88e4f17b96a1ULL);
    EXPECT_EQ(fingerprint(makeRelief("steps", 128, 128, 1)), 0x25d821e34b70358dULL);
}

TEST(Reliefs, BricksAreFacesAndMortar) {
    const FloatImage image = makeRelief("bricks", 128, 128, 1);
    EXPECT_NEAR(share(image, 0.0799F, 0.1201F) + share(image, 0.8999F, 1), 1, 1e-12);
    // 27 x 11 texels of 32 x 16.
    EXPECT_NEAR(share(image, 0.8999F, 1), 27.0 * 11 / (32 * 16), 1e-12);
    // Twice the size, with mortar twice as wide.
    EXPECT_NEAR(share(makeRelief("bricks", 256, 256, 1), 0.8999F, 1), 27.0 * 11 / (32 * 16), 1e-12);
}

TEST(Reliefs, NeedlesAreFewAndThin) {
    for (const int size : {128, 512}) {
        const FloatImage image = makeRelief("spikes", size, size, 1);
        EXPECT_NEAR(share(image, 0.5999F, 1), 0.01, 0.004) << size;
        EXPECT_NEAR(share(image, 0.5999F, 1) + share(image, 0.0199F, 0.0501F), 1, 1e-12);
    }
}

TEST(Reliefs, PitsColumnsAndCityKeepTheirShares) {
    for (const int size : {128, 512}) {
        EXPECT_NEAR(share(makeRelief("pits", size, size, 1), 0, 0.1F), 0.32, 0.08) << size;
        EXPECT_NEAR(share(makeRelief("columns", size, size, 1), 0.2999F, 1), 0.05, 0.02) << size;
        EXPECT_NEAR(share(makeRelief("city", size, size, 1), 0.4999F, 1), 64.0 / (11.64 * 11.64), 0.03) << size;
    }
}

TEST(Reliefs, StepsAreEightTerracesAndCheckerIsHalfBlack) {
    const FloatImage steps = makeRelief("steps", 256, 256, 5);
    EXPECT_EQ(std::set<float>(steps.pixels().begin(), steps.pixels().end()).size(), 8U);
    const FloatImage checker = makeRelief("checker", 64, 64, 0);
    EXPECT_EQ(share(checker, 0, 0), 0.5);
    EXPECT_EQ(share(checker, 1, 1), 0.5);
    EXPECT_EQ(checker(0, 0), checker(3, 3));
    EXPECT_NE(checker(3, 0), checker(4, 0));
}

// Across the seam a smooth relief changes no more than inside, and blocks of the same height do not touch.
TEST(Reliefs, TileWithoutASeam) {
    for (const char* name : {"hills", "fractal"}) {
        for (const auto& [width, height] : {std::pair{256, 256}, {300, 200}}) {
            const FloatImage image = makeRelief(name, width, height, 2);
            float inside = 0, seam = 0;
            for (int y = 0; y < height; ++y) {
                seam = std::max(seam, std::abs(image(0, y) - image(width - 1, y)));
                for (int x = 1; x < width; ++x) inside = std::max(inside, std::abs(image(x, y) - image(x - 1, y)));
            }
            EXPECT_LE(seam, inside) << name;
            seam = 0;
            for (int x = 0; x < width; ++x) seam = std::max(seam, std::abs(image(x, 0) - image(x, height - 1)));
            EXPECT_LE(seam, inside * 1.5F) << name;
        }
    }
    for (const auto& [width, height] : {std::pair{128, 64}, {100, 37}, {7, 2}}) {
        const FloatImage checker = makeRelief("checker", width, height, 0);
        for (int y = 0; y < height; ++y) EXPECT_NE(checker(0, y), checker(width - 1, y));
    }
}

TEST(Reliefs, PaperExampleAsPrinted) {
    const FloatImage image = makeRelief("paper8x8", 8, 8, 0);
    EXPECT_EQ(image(0, 0), 0.9F);
    EXPECT_EQ(image(6, 1), 0.1F);
    EXPECT_EQ(image(1, 7), 0.7F);
    EXPECT_EQ(image(7, 7), 0.3F);
}

TEST(Reliefs, RefusesWhatTheyAreNot) {
    EXPECT_EQ(faultOf([] { makeRelief("paper8x8", 16, 8, 0); }), "paper8x8: exists only as 8 x 8, not as 16 x 8");
    EXPECT_EQ(faultOf([] { makeRelief("bricks", 0, 8, 0); }), "bricks: the picture has no pixels (0 x 8)");
    EXPECT_EQ(faultOf([] { makeRelief("walls", 8, 8, 0); }),
              "there is no relief \"walls\"; did you mean \"paper-walls\"? Known: bricks, spikes, pits, columns, city, "
              "fractal, hills, steps, "
              "checker, paper8x8, paper-walls");
}

}  // namespace
}  // namespace relief
