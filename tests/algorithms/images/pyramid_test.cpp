#include "images/pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "relief/addressing.h"
#include "relief/reliefs.h"

namespace relief {
namespace {

void expectLevel(const FloatImage& level, int width, std::initializer_list<double> values) {
    ASSERT_EQ(level.size(), values.size());
    ASSERT_EQ(level.width(), width);
    std::size_t i = 0;
    for (const double value : values) {
        EXPECT_NEAR(level.pixels()[i], value, 1e-7) << "texel " << i;
        ++i;
    }
}

// Fig. 3 of [MIP18]; the maxima are taken from there, means and minima were computed by hand.
TEST(Pyramid, PaperExampleMax) {
    Work work(1);
    const Pyramid pyramid(PyramidKind::Max, makeRelief("paper8x8", 8, 8, 0), work);
    ASSERT_EQ(pyramid.levels(), 4);
    expectLevel(pyramid.level(1), 4, {.9, .6, .8, .6, .7, .7, .6, .7, .5, .5, .5, .4, .7, .7, .7, .3});
    expectLevel(pyramid.level(2), 2, {.9, .8, .7, .7});
    expectLevel(pyramid.level(3), 1, {.9});
}

TEST(Pyramid, PaperExampleMin) {
    Work work(1);
    const Pyramid pyramid(PyramidKind::Min, makeRelief("paper8x8", 8, 8, 0), work);
    ASSERT_EQ(pyramid.levels(), 4);
    expectLevel(pyramid.level(1), 4, {.2, .2, .5, .1, .3, .3, .3, .3, .2, .2, .4, .2, .1, .3, .3, .2});
    expectLevel(pyramid.level(2), 2, {.2, .1, .1, .2});
    expectLevel(pyramid.level(3), 1, {.1});
}

TEST(Pyramid, PaperExampleMean) {
    Work work(1);
    const Pyramid pyramid(PyramidKind::Mean, makeRelief("paper8x8", 8, 8, 0), work);
    ASSERT_EQ(pyramid.levels(), 4);
    // Sums of four texels, in tenths: 22 19 26 14 / 19 19 18 19 / 14 14 18 12 / 17 19 19 10.
    expectLevel(pyramid.level(1), 4,
                {.55, .475, .65, .35, .475, .475, .45, .475, .35, .35, .45, .3, .425, .475, .475, .25});
    // Sums of sixteen texels, in tenths: 79 77 / 64 59; of all, 279.
    expectLevel(pyramid.level(2), 2, {7.9 / 16, 7.7 / 16, 6.4 / 16, 5.9 / 16});
    expectLevel(pyramid.level(3), 1, {27.9 / 64});
}

FloatImage noise(int width, int height) {
    std::mt19937 generator(static_cast<unsigned>(width * 1000 + height));
    FloatImage image(width, height);
    for (float& value : image.pixels()) value = static_cast<float>(generator() % 100000) / 100000.0F;
    return image;
}

TEST(Pyramid, AnySizeAgainstTheDefinition) {
    Work work(2);
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {7, 1}, {5, 3}, {8, 8}, {13, 29}, {64, 65}}) {
        const FloatImage base = noise(width, height);
        const Pyramid most(PyramidKind::Max, base, work);
        const Pyramid least(PyramidKind::Min, base, work);
        const Pyramid mean(PyramidKind::Mean, base, work);
        ASSERT_EQ(most.levels(), Pyramid::levelCount(width, height));
        EXPECT_EQ(most.level(0), base);
        for (int l = 0; l < most.levels(); ++l) {
            const int size = 1 << l;
            ASSERT_EQ(most.level(l).width(), (width + size - 1) / size);
            ASSERT_EQ(most.level(l).height(), (height + size - 1) / size);
            for (int y = 0; y < most.level(l).height(); ++y)
                for (int x = 0; x < most.level(l).width(); ++x) {
                    float high = -1, low = 2;
                    double sum = 0;
                    int count = 0;
                    for (int j = y * size; j < std::min(height, (y + 1) * size); ++j)
                        for (int i = x * size; i < std::min(width, (x + 1) * size); ++i, ++count) {
                            high = std::max(high, base(i, j));
                            low = std::min(low, base(i, j));
                            sum += static_cast<double>(base(i, j));
                        }
                    EXPECT_EQ(most.level(l)(x, y), high);
                    EXPECT_EQ(least.level(l)(x, y), low);
                    EXPECT_NEAR(mean.level(l)(x, y), sum / count, 6e-8);
                }
        }
        EXPECT_EQ(most.level(most.levels() - 1).size(), 1U);
    }
}

TEST(Pyramid, EqualBitsForAnyThreadCount) {
    const FloatImage base = noise(1023, 511);
    for (const PyramidKind kind : {PyramidKind::Mean, PyramidKind::Max, PyramidKind::Min}) {
        Work one(1);
        const Pyramid alone(kind, base, one);
        for (const int threads : {2, 7}) {
            Work many(threads);
            const Pyramid together(kind, base, many);
            for (int l = 0; l < alone.levels(); ++l) EXPECT_EQ(alone.level(l), together.level(l)) << l;
        }
    }
}

TEST(Pyramid, CountsItsBytesAndLevels) {
    Work work(1);
    const Pyramid pyramid(PyramidKind::Max, FloatImage(5, 3), work);
    EXPECT_EQ(pyramid.bytes(), (15U + 6U + 2U + 1U) * sizeof(float));
    EXPECT_EQ(Pyramid::levelCount(1, 1), 1);
    EXPECT_EQ(Pyramid::levelCount(65536, 1), 17);
    EXPECT_EQ(Pyramid::levelCount(65537, 1), 18);
}

TEST(Pyramid, CanBeCancelled) {
    std::stop_source stop;
    stop.request_stop();
    Work work(2, stop.get_token());
    EXPECT_THROW(Pyramid(PyramidKind::Mean, FloatImage(64, 64), work), Cancelled);
}

TEST(Pyramid, ReportsProgressOfLargeMapsToTheEnd) {
    double last = -1;
    std::mutex mutex;
    const auto listener = [&](std::string_view, double fraction) {
        const std::lock_guard lock(mutex);
        last = std::max(last, fraction);
    };
    for (const PyramidKind kind : {PyramidKind::Max, PyramidKind::Mean}) {
        last = -1;
        Work work(2, {}, listener);
        const Pyramid pyramid(kind, FloatImage(2048, 2048), work);
        EXPECT_EQ(last, 1.0);
        last = -1;
        const Pyramid small(kind, FloatImage(64, 64), work);
        EXPECT_EQ(last, -1.0);
    }
}

TEST(Addressing, WrapsClampsAndKeepsTheBorder) {
    EXPECT_EQ(wrapIndex(-1, 5), 4);
    EXPECT_EQ(wrapIndex(-5, 5), 0);
    EXPECT_EQ(wrapIndex(12, 5), 2);
    EXPECT_EQ(wrapIndex(std::numeric_limits<std::int64_t>::min(), 7), 6);
    EXPECT_EQ(addressIndex(-3, 4, Address::Repeat), 1);
    EXPECT_EQ(addressIndex(-3, 4, Address::Clamp), 0);
    EXPECT_EQ(addressIndex(9, 4, Address::Clamp), 3);
    EXPECT_EQ(addressIndex(std::int64_t{1} << 40, 4, Address::Border), 3);
}

bool sameTexels(const FloatImage& a, const FloatImage& b) {
    return std::ranges::equal(a.pixels(), b.pixels());
}

// An edited pyramid has the same bits as one built from the edited heights, and shares every unchanged level.
TEST(Pyramid, EditsShareWhatDoesNotChange) {
    constexpr unsigned kSeed = 20261122;
    std::printf("seed %u\n", kSeed);
    std::mt19937 generator(kSeed);
    Work work(1);
    for (const auto& [width, height] : {std::pair{8, 8}, {32, 32}, {13, 5}, {1, 9}, {1, 1}}) {
        for (const PyramidKind kind : {PyramidKind::Max, PyramidKind::Min, PyramidKind::Mean}) {
            auto heights = std::make_shared<const FloatImage>(noise(width, height));
            Pyramid before(kind, heights, work);
            std::size_t shared = 0;
            for (int n = 0; n < 50; ++n) {
                FloatImage next = *heights;
                // Edits none, one or a few texels.
                for (unsigned k = generator() % 4; k > 0; --k) {
                    const auto x = static_cast<int>(generator() % static_cast<unsigned>(width));
                    const auto y = static_cast<int>(generator() % static_cast<unsigned>(height));
                    // Or edits by the smallest possible amount: means may stay the same and still change on a higher
                    // level.
                    next(x, y) = generator() % 2 == 0 ? static_cast<float>(generator() % 1000) / 1000.0F
                                                      : std::nextafter(next(x, y), 1.0F);
                }
                heights = std::make_shared<const FloatImage>(std::move(next));
                const Pyramid edited = Pyramid::edited(before, heights);
                const Pyramid built(kind, heights, work);
                ASSERT_EQ(edited.levels(), built.levels());
                EXPECT_EQ(edited.kind(), kind);
                EXPECT_EQ(edited.bytes(), built.bytes());
                EXPECT_EQ(&edited.level(0), heights.get());
                for (int l = 0; l < built.levels(); ++l) {
                    ASSERT_TRUE(sameTexels(edited.level(l), built.level(l))) << "level " << l;
                    const bool same = sameTexels(edited.level(l), before.level(l));
                    if (l == 0) continue;
                    EXPECT_EQ(&edited.level(l) == &before.level(l), same) << "level " << l;
                    shared += same ? 1 : 0;
                }
                before = edited;
            }
            EXPECT_EQ(shared > 0, before.levels() > 1);
        }
    }
}

// A pyramid counts the bytes of a picture that it owns, but not those of a shared one.
TEST(Pyramid, EditedCountsThePictureThatItOwns) {
    Work work(1);
    const auto picture = std::make_shared<const FloatImage>(16, 8, 0.5F);
    const Pyramid shared(PyramidKind::Max, picture, work);
    EXPECT_EQ(Pyramid::edited(shared, *picture).bytes(), shared.bytes() + picture->bytes());
    EXPECT_EQ(Pyramid::edited(shared, picture).bytes(), shared.bytes());
}

}  // namespace
}  // namespace relief
