#include "measuring/picture_error.h"

#include <cmath>

#include <gtest/gtest.h>

#include "measuring/flip.h"

namespace relief {
namespace {

// Two smooth pictures that differ in places, by a formula.
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
    // No edges: the colour error alone. HyAB(black, white) = 100 = |dL|; the largest distance, of the adjusted green
    // and blue, is 41.276 to the power 0.7 already; 0.95 + 0.05 (100^0.7 - 0.4 c) / (0.6 c).
    const double c = 41.276098;
    const double expected = 0.95 + 0.05 * (std::pow(100, 0.7) - 0.4 * c) / (0.6 * c);
    for (const float value : map.pixels()) EXPECT_NEAR(static_cast<double>(value), expected, 1e-5);
}

TEST(PictureError, RmseIsOfTheEncodedValues) {
    Work work(1);
    FloatImage map;
    // Linear 0.2140411 is sRGB 0.5.
    const PictureError error =
        pictureError(ColorImage(3, 3, Color(0)), ColorImage(3, 3, Color(0.21404114F, 0, 0)), 67, map, work);
    EXPECT_NEAR(error.rmse, 0.5 / std::sqrt(3.0), 1e-6);
    EXPECT_NEAR(error.psnr, -20 * std::log10(0.5 / std::sqrt(3.0)), 1e-5);
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
    // From a direct double-precision evaluation of the published two-dimensional filters.
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
