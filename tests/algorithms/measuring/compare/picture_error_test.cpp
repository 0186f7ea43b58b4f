#include "measuring/compare/picture_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "measuring/compare/flip.h"

namespace relief {
namespace {

// Two smooth pictures, given by a formula, that differ in places.
ColorImage waves(int width, int height, bool disturbed) {
    ColorImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                double v = 0.5 + 0.5 * std::sin(0.1 * (x * (c + 1) + 2 * y));
                if (disturbed && x > width / 2) v += 0.3 * std::sin(1.7 * x * x + 2.3 * y + c);
                image(x, y)[c] = static_cast<float>(std::clamp(v, 0.0, 1.0));
            }
        }
    }
    return image;
}

TEST(PictureError, EqualPicturesDoNotDiffer) {
    Work work(2);
    const ColorImage a = waves(37, 23, false);
    FloatImage map;
    const PictureError error = pictureError(a, a, kPixelsPerDegree, map, work);
    EXPECT_EQ(error.rmse, 0);
    EXPECT_TRUE(std::isinf(error.psnr));
    EXPECT_EQ(error.flip, 0);
    EXPECT_EQ(map.width(), 37);
    EXPECT_EQ(map.height(), 23);
}

TEST(PictureError, BlackAndWhite) {
    Work work(1);
    FloatImage map;
    const PictureError error =
        pictureError(ColorImage(40, 30, Color(0)), ColorImage(40, 30, Color(7)), kPixelsPerDegree, map, work);
    EXPECT_EQ(error.rmse, 1) << "clamped before comparing";
    EXPECT_NEAR(error.psnr, 0, 1e-12);
    // There are no edges, so only the colour error counts. HyAB(black, white) = 100 = |dL|; the largest distance,
    // between the adjusted green and blue, is 41.276, which includes the power 0.7; 0.95 + 0.05 (100^0.7 - 0.4 c) /
    // (0.6 c).
    const double c = 41.276098;
    const double expected = 0.95 + 0.05 * (std::pow(100, 0.7) - 0.4 * c) / (0.6 * c);
    for (const float value : map.pixels()) EXPECT_NEAR(static_cast<double>(value), expected, 1e-5);
}

TEST(PictureError, RmseIsOfTheEncodedValues) {
    Work work(1);
    FloatImage map;
    // 0.2140411 in linear light is 0.5 in sRGB.
    const PictureError error =
        pictureError(ColorImage(3, 3, Color(0)), ColorImage(3, 3, Color(0.21404114F, 0, 0)), 67, map, work);
    EXPECT_NEAR(error.rmse, 0.5 / std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(error.psnr, -20 * std::log10(0.5 / std::sqrt(3.0)), 1e-5);
}

// All channels of all pixels have the same weight, checked by hand: sRGB is 12.92 c up to 0.0031308 and 1.055 c^(1/2.4)
// - 0.055 above.
TEST(PictureError, EveryChannelOfEveryPixelCountsAlike) {
    constexpr double kFloat = 1e-6;
    const double dark = 12.92 * 0.002, middle = 1.055 * std::pow(0.5, 1 / 2.4) - 0.055;
    const float infinite = std::numeric_limits<float>::infinity();
    ColorImage a(2, 2, Color(0)), b(2, 2, Color(0));
    a(0, 0) = {0.002F, 1, 0};
    b(0, 0) = {0, 0.5F, 0};
    a(1, 0) = {0, 0, 0.5F};
    b(1, 0) = {0, 0, 0.002F};
    // Clamping on both sides makes two of the three channels equal.
    a(0, 1) = {-3, infinite, 0};
    b(0, 1) = {0, 2, -infinite};
    a(1, 1) = {infinite, 0, 0};
    const double squares = dark * dark + (1 - middle) * (1 - middle) + (middle - dark) * (middle - dark) + 1;
    Work work(1);
    FloatImage map;
    for (const bool swapped : {false, true}) {
        const PictureError error = pictureError(swapped ? b : a, swapped ? a : b, kPixelsPerDegree, map, work);
        EXPECT_NEAR(error.rmse, std::sqrt(squares / 12), kFloat);
        EXPECT_NEAR(error.psnr, -10 * std::log10(squares / 12), 10 * kFloat);
        double sum = 0;
        for (const float value : map.pixels()) sum += static_cast<double>(value);
        EXPECT_NEAR(error.flip, sum / 4, kFloat);
        EXPECT_GT(error.flip, 0);
    }
}

// A pair of uniform pictures has no edges or points, and filtering does not change its colours: the result is the
// paper's colour term alone, at any distance. Covers both branches of its mapping, and of the L*a*b* curve, which is
// linear for dark colours.
TEST(Flip, UniformPairsAreTheirColourTerm) {
    using Truth = long double;
    using Three = std::array<Truth, 3>;
    // planes are float, and powers of small differences are taken
    constexpr double kFloat = 2e-5;
    const auto seen = [](const Color& c) {
        constexpr Truth kToXyz[3][3] = {{0.41238656L, 0.35759149L, 0.18045049L},
                                        {0.21263682L, 0.71518298L, 0.07218020L},
                                        {0.01933062L, 0.11919716L, 0.95037259L}};
        Three f{};
        for (std::size_t n = 0; n < 3; ++n) {
            Truth value = 0, white = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                value += kToXyz[n][k] * std::clamp<Truth>(static_cast<Truth>(c[static_cast<int>(k)]), 0, 1);
                white += kToXyz[n][k];
            }
            value /= white;
            f[n] = value > 216 / 24389.0L ? std::cbrt(value) : (24389 / 27.0L * value + 16) / 116;
        }
        const Truth lightness = 116 * f[1] - 16;
        return Three{lightness, lightness / 100 * 500 * (f[0] - f[1]), lightness / 100 * 200 * (f[1] - f[2])};
    };
    const auto distance = [&](const Color& a, const Color& b) {
        const Three p = seen(a), q = seen(b);
        return std::pow(std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]), 0.7L);
    };
    const Truth largest = distance({0, 1, 0}, {0, 0, 1});
    const std::vector<std::pair<Color, Color>> pairs{{{0, 0, 0}, {1, 1, 1}},
                                                     {{1, 0, 0}, {0, 1, 0}},
                                                     {{0, 1, 0}, {0, 0, 1}},
                                                     {{0.5F, 0.5F, 0.5F}, {0.51F, 0.5F, 0.5F}},
                                                     {{0.2F, 0.3F, 0.4F}, {0.4F, 0.3F, 0.2F}},
                                                     {{0.001F, 0.002F, 0.003F}, {0.004F, 0.002F, 0.001F}},
                                                     {{0.7F, 0.1F, 0.9F}, {7, -1, 0.9F}}};
    Work work(1);
    bool below = false, above = false;
    for (const auto& [a, b] : pairs) {
        const Truth share = distance(a, b) / largest;
        const Truth expected = share < 0.4L ? share * 0.95L / 0.4L : 0.95L + (share - 0.4L) / 0.6L * 0.05L;
        (share < 0.4L ? below : above) = true;
        for (const double pixelsPerDegree : {5.0, 67.0}) {
            const FloatImage errors = flipErrors(ColorImage(7, 4, a), ColorImage(7, 4, b), pixelsPerDegree, work);
            for (const float error : errors.pixels()) {
                EXPECT_NEAR(error, static_cast<double>(expected), kFloat) << a.x << " " << b.x;
            }
        }
    }
    EXPECT_TRUE(below && above);
}

TEST(Flip, AgreesWithTheUnseparatedFilters) {
    Work work(2);
    const ColorImage a = waves(70, 50, false);
    const ColorImage b = waves(70, 50, true);
    const auto mean = [&](double pixelsPerDegree) {
        double sum = 0;
        const FloatImage errors = flipErrors(a, b, pixelsPerDegree, work);
        for (const float value : errors.pixels()) sum += static_cast<double>(value);
        return sum / static_cast<double>(errors.size());
    };
    // From a direct evaluation of the published two-dimensional filters in double.
    EXPECT_NEAR(mean(67), 0.138771256, 2e-6);
    EXPECT_NEAR(mean(20), 0.260995778, 2e-6);
}

TEST(Flip, SameBitsForAnyNumberOfThreads) {
    const ColorImage a = waves(70, 50, false);
    const ColorImage b = waves(70, 50, true);
    Work one(1);
    Work two(2);
    EXPECT_TRUE(flipErrors(a, b, 67, one) == flipErrors(a, b, 67, two));
}

}  // namespace
}  // namespace relief
