// Compares what the scalar and the SIMD version share with sums over the picture in long double: the level from which a
// pixel is read, and the second moments of its footprint.
#include <numbers>

#include <gtest/gtest.h>

#include "filter_cases.h"

namespace relief::test {
namespace {

using Truth = long double;
constexpr Truth kTurn = 2 * std::numbers::pi_v<Truth>;

// A texel of level l of a picture whose sides are powers of two: the mean of a square of texels, computed
// independently.
Color levelTexel(const ColorImage& picture, int l, int i, int j) {
    const int side = 1 << l, width = picture.width() >> l, height = picture.height() >> l;
    const int x0 = ((i % width + width) % width) * side, y0 = ((j % height + height) % height) * side;
    Truth sum[3] = {};
    for (int y = y0; y < y0 + side; ++y) {
        for (int x = x0; x < x0 + side; ++x) {
            for (int k = 0; k < 3; ++k) sum[k] += static_cast<Truth>(picture(x, y)[k]);
        }
    }
    const Truth count = static_cast<Truth>(side) * side;
    return {static_cast<float>(sum[0] / count), static_cast<float>(sum[1] / count), static_cast<float>(sum[2] / count)};
}

// Bilinear interpolation under repeat.
glm::dvec3 bilinear(const ColorImage& picture, int l, glm::dvec2 place) {
    const glm::dvec2 p = place * std::ldexp(1.0, -l) - 0.5;
    const int i = static_cast<int>(std::floor(p.x)), j = static_cast<int>(std::floor(p.y));
    const double u = p.x - i, v = p.y - j;
    const auto at = [&](int di, int dj) { return glm::dvec3(levelTexel(picture, l, i + di, j + dj)); };
    return (1 - v) * ((1 - u) * at(0, 0) + u * at(1, 0)) + v * ((1 - u) * at(0, 1) + u * at(1, 1));
}

// The level follows from the longer of the two paths on the texture that a step of one pixel makes, for any rotation of
// the texture under the pixel; colours are interpolated between that level and the next.
TEST(FilterTruth, TrilinearReadsTheLevelOfTheLongerStep) {
    constexpr double kColor = 1e-5;  // float sums in another order
    const auto picture = randomPicture(64, 64, 4);
    MadeFilter made({"trilinear", {}}, picture, fieldFor(*picture, Address::Repeat));
    const Truth lengths[][2] = {{9, 0.1L}, {0.1L, 9}, {5, 3}, {2.5L, 20}, {1.5L, 1.5L}, {0.6L, 0.2L}};
    constexpr int kAngles = 24;
    for (const auto& [alongX, alongY] : lengths) {
        for (int n = 0; n < kAngles; ++n) {
            const Truth one = kTurn * n / kAngles, two = one + kTurn * (n % 5 + 1) / 7;
            const Jacobian j{static_cast<double>(alongX * std::cos(one)), static_cast<double>(alongX * std::sin(one)),
                             static_cast<double>(alongY * std::cos(two)), static_cast<double>(alongY * std::sin(two))};
            const Truth level = std::max(std::log2(std::max(alongX, alongY)), Truth{0});
            const int lower = static_cast<int>(std::floor(level));
            const double share = static_cast<double>(level - lower);
            const glm::dvec2 place{20.3 + n, 31.7};
            FootprintLog log;
            const Color found = made.at(place, j, &log);
            EXPECT_EQ(log.footprint.level, lower) << alongX << ", " << alongY << " turned by " << n;
            const glm::dvec3 truth =
                (1 - share) * bilinear(*picture, lower, place) + share * bilinear(*picture, lower + 1, place);
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], truth[k], kColor) << n;
        }
    }
}

// A picture of x^2, x y and y^2 relative to its centre.
Picture squares(int size) {
    auto image = std::make_shared<ColorImage>(size, size);
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            const Truth x = i + 0.5L - size / 2, y = j + 0.5L - size / 2;
            (*image)(i, j) = {static_cast<float>(x * x), static_cast<float>(x * y), static_cast<float>(y * y)};
        }
    }
    return image;
}

// Variance of a Gaussian cut off at `radius`, as a share of the whole Gaussian's variance, per direction.
Truth shareWithin(Truth radius, Truth sigma) {
    const Truth h = radius * radius / (2 * sigma * sigma);
    return 1 - h * std::exp(-h) / (1 - std::exp(-h));
}

struct Moments {
    Truth xx, xy, yy;
};

// The second moments that a pixel should have on level l (level_footprint.h): the truncated Gaussian of the pixel,
// combined with the reconstruction of level 0 in place of the level's own box filters and sampled from those boxes. The
// test picture's texels are point samples, not boxes, so the box of level 0 is subtracted.
Moments meant(const Jacobian& j, const EllipticalSettings& settings, int l) {
    constexpr Truth kReconstruction = 0.25L, kBox = 1 / 12.0L;
    const Truth share = shareWithin(settings.radius, settings.sigma);
    const Truth box = kBox * std::pow(Truth{4}, l), variance = Truth{settings.sigma} * settings.sigma;
    const Truth ux = j.ux, vx = j.vx, uy = j.uy, vy = j.vy;
    const Truth texels = kReconstruction - box;
    return {share * (variance * (ux * ux + uy * uy) + texels) + box - kBox, share * variance * (ux * vx + uy * vy),
            share * (variance * (vx * vx + vy * vy) + texels) + box - kBox};
}

TEST(FilterTruth, SecondMomentsAreThePixelsOnEveryLevel) {
    constexpr int kSize = 256;
    constexpr int kPhases = 6;  // positions of the centre within a texel of the level, in each direction
    // Tolerance as a share of the trace: a Gaussian summed at some twenty points differs from its integral.
    constexpr Truth kMoments = 0.015L;
    const Picture picture = squares(kSize);
    for (const char* implementation : {"scalar", "lanes"}) {
        MadeFilter made({"elliptical", {{"implementation", implementation}}}, picture,
                        fieldFor(*picture, Address::Clamp));
        EllipticalOptions options;
        const EllipticalSettings settings = EllipticalSettings::of(options);
        const double axes[][2] = {{1.6, 1.4}, {3, 2}, {4, 3.2}, {12, 6}, {24, 12}, {40, 24}};
        Truth worst = 0;
        for (const auto& [major, minor] : axes) {
            for (const double angle : {0.0, 0.5, 1.1, 2.3}) {
                const Jacobian j = jacobian(major, minor, angle, 0.7);
                FootprintLog log;
                (void)made.at({kSize / 2.0, kSize / 2.0}, j, &log);
                const int level = log.footprint.level;
                Moments seen{};
                const Truth step = std::ldexp(Truth{1}, level) / kPhases;
                for (int n = 0; n < kPhases * kPhases; ++n) {
                    const Truth dx = step * (n % kPhases), dy = step * (n / kPhases);
                    const Color color =
                        made.at({static_cast<double>(kSize / 2 + dx), static_cast<double>(kSize / 2 + dy)}, j);
                    constexpr Truth kEach = Truth{1} / (kPhases * kPhases);
                    seen.xx += kEach * (static_cast<Truth>(color.x) - dx * dx);
                    seen.xy += kEach * (static_cast<Truth>(color.y) - dx * dy);
                    seen.yy += kEach * (static_cast<Truth>(color.z) - dy * dy);
                }
                const Moments truth = meant(j, settings, level);
                const Truth allowed = kMoments * (truth.xx + truth.yy);
                const auto near = [&](Truth found, Truth expected, const char* what) {
                    worst = std::max(worst, std::abs(found - expected) / (truth.xx + truth.yy));
                    EXPECT_NEAR(static_cast<double>(found), static_cast<double>(expected), static_cast<double>(allowed))
                        << what << ", level " << level << ", axes " << major << " " << minor << ", angle " << angle;
                };
                near(seen.xx, truth.xx, "xx");
                near(seen.xy, truth.xy, "xy");
                near(seen.yy, truth.yy, "yy");
            }
        }
        std::cout << implementation << ": off by at most " << static_cast<double>(worst) << " of the trace\n";
    }
}

}  // namespace
}  // namespace relief::test
