// The colour pyramid, its axes and the pixel models.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "filter_cases.h"
#include "filtering/color_levels.h"
#include "filtering/weight_map.h"
#include "relief/errors.h"

using namespace relief;
using namespace relief::test;

namespace {

TEST(ColorLevels, topIsTheMeanOfThePicture) {
    for (const auto& [w, h] : std::vector<std::pair<int, int>>{{16, 16}, {37, 21}, {5, 1}, {1, 1}, {3, 64}}) {
        const Picture picture = randomPicture(w, h, 3);
        Work work(2);
        const ColorLevels levels(picture, work);
        glm::dvec3 sum(0);
        for (const Color& c : picture->pixels()) sum += glm::dvec3(c);
        sum /= static_cast<double>(picture->size());
        const Color top = levels.level(levels.top())(0, 0);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(top[k], sum[k], 1e-6) << w << "x" << h;
        EXPECT_EQ(levels.level(levels.top()).size(), 1U);
    }
}

TEST(LevelAxis, visitsEveryTexelOnceAPeriod) {
    for (const int size : {1, 2, 5, 37, 64, 100}) {
        for (int level = 0; level < 7; ++level) {
            const LevelAxis axis = LevelAxis::of(size, level, Address::Repeat);
            double share = 0;
            int count = 0;
            double last = -1;
            axis.over(1e-9, axis.extent, [&](int i, double centre, float s) {
                share += static_cast<double>(s);
                ++count;
                EXPECT_GT(centre, last);
                EXPECT_GE(i, 0);
                EXPECT_LT(i, axis.size);
                last = centre;
            });
            EXPECT_EQ(count, axis.size) << size << " level " << level;
            EXPECT_NEAR(share, axis.extent, 1e-6);
        }
    }
}

TEST(LevelAxis, supportInterpolatesBetweenTrueCentres) {
    for (const Address address : {Address::Repeat, Address::Clamp}) {
        for (const int size : {1, 2, 5, 37}) {
            for (int level = 0; level < 4; ++level) {
                const LevelAxis axis = LevelAxis::of(size, level, address);
                for (int i = 0; i < axis.size; ++i) {
                    const BilinearSupport at = axis.support(axis.centre(i));
                    const int texel = at.share < 0.5F ? at.first : at.second;
                    EXPECT_EQ(texel, i) << size << " level " << level;
                    EXPECT_NEAR(std::min(at.share, 1 - at.share), 0, 1e-6);
                }
            }
        }
    }
}

// At every position, also across the seam, interpolating the two supporting centres by the share gives the position
// itself.
TEST(LevelAxis, supportIsExactBetweenCentresAndAcrossTheSeam) {
    for (const int size : {1, 2, 5, 37, 64}) {
        for (int level = 0; level < 5; ++level) {
            const LevelAxis axis = LevelAxis::of(size, level, Address::Repeat);
            for (int n = 0; n < 200; ++n) {
                double x = axis.extent * (n + 0.5) / 200;
                const BilinearSupport at = axis.support(x);
                double second = axis.centre(at.second);
                if (at.second <= at.first) {
                    EXPECT_EQ(at.first, axis.size - 1);
                    EXPECT_EQ(at.second, 0);
                    second += axis.extent;
                    if (x < axis.centre(at.first)) x += axis.extent;
                }
                const auto share = static_cast<double>(at.share);
                EXPECT_NEAR((1 - share) * axis.centre(at.first) + share * second, x, 1e-5)
                    << size << " level " << level << " at " << x;
            }
        }
    }
}

TEST(PixelModels, namesAreReadBack) {
    for (std::size_t n = 0; n < kPixelModelNames.size(); ++n) {
        EXPECT_EQ(parsePixelModel(kPixelModelNames[n]), static_cast<PixelModel>(n));
    }
    EXPECT_THROW(parsePixelModel("round"), InputError);
}

// Each channel's density has its centre of mass at the display's stripe or spot.
TEST(PixelModels, channelsLieWhereTheDisplayHasThem) {
    const auto centre = [](PixelModel model, int channel) {
        double x = 0, y = 0, sum = 0;
        for (double dy = -3; dy < 3; dy += 0.01) {
            for (double dx = -3; dx < 3; dx += 0.01) {
                const double w = pixelFactorAcross(model, channel, dx) * pixelFactorDown(model, channel, dy);
                x += w * dx;
                y += w * dy;
                sum += w;
            }
        }
        return glm::dvec2(x / sum, y / sum);
    };
    constexpr double kGrid = 0.01;
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(centre(PixelModel::Box, c).x, 0, kGrid);
        EXPECT_NEAR(centre(PixelModel::Gaussian, c).y, 0, kGrid);
        EXPECT_NEAR(centre(PixelModel::Lcd, c).x, (c - 1) / 3.0, kGrid);
        EXPECT_NEAR(glm::length(centre(PixelModel::Crt, c)), kCrtCircle, kGrid);
    }
}

TEST(WeightMap, thePapersPixelIsCutAtItsBase) {
    EllipticalOptions options;
    options.radius = 0.5;  // base diameter 1
    options.source = "map";
    const EllipticalSettings settings = EllipticalSettings::of(options);
    const WeightMap map(settings);
    EXPECT_EQ(map.at(0.51F, 0).x, 0);
    EXPECT_GT(map.at(0.4F, 0.1F).x, 0);
    EXPECT_EQ(map.at(0.45F, 0.45F).x, 0);
    // The closed form of the volume: 2 pi sigma^2 (1 - exp(-R^2 / (2 sigma^2))).
    double volume = 0;
    for (const glm::vec3& w : map.weights().pixels()) volume += static_cast<double>(w.x);
    volume /= std::pow(settings.resolution, 2);
    const double exact = 2 * 3.14159265358979 * settings.sigma * settings.sigma *
                         (1 - std::exp(-0.125 / (settings.sigma * settings.sigma)));
    EXPECT_NEAR(volume, exact, 0.01);
}

TEST(FilterChoice, textsAreReadBackAndFaultsAreSaid) {
    const FilterChoice choice = parseFilter("elliptical-visible:form=plane:sigma=0.5", "--filter");
    EXPECT_EQ(parseFilter(filterText(choice), "--filter"), choice);
    for (const char* bad : {"elliptic", "elliptical:sigma", "elliptical:sigma=x", "elliptical:sigma=99",
                            "elliptical:form=plane", "bilinear:sigma=1", "elliptical:weights=round", "elliptical:"}) {
        EXPECT_THROW(parseFilter(bad, "--filter"), InputError) << bad;
    }
}

}  // namespace
