#include "mapping/rows/coefficients.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "algorithms/mapping/mapping_cases.h"

namespace relief {
namespace {

using test::Random;
using test::randomView;
using test::View;

// Compared with differences of the map itself and with the formulas of [TEX], written out here.
TEST(Coefficients, areThoseOfThePapers) {
    Random random(4);
    for (int n = 0; n < 300; ++n) {
        const View view = randomView(random);
        const Homography map = fromCameraAndPlane(view.camera, view.plane);
        const double x = view.camera.principal.x + random.real(-1.0, 1.0);
        const double y = view.camera.principal.y + random.real(-1.0, 1.0);
        if (!(map.denominator(x, y) > 0.01)) continue;
        const PixelCoefficients pixel = pixelCoefficients(map, x, y);
        std::map<std::string, double, std::less<>> by;
        for (const NamedNumber& number : namedNumbers(pixel)) by[std::string(number.name)] = number.value;
        EXPECT_EQ(by.size(), namedNumbers(pixel).size()) << "a name twice";
        const double q = by["G"] * x + by["H"] * y + by["I"];
        EXPECT_NEAR(by["q"], q, 1e-12 * std::abs(q) + 1e-12);
        EXPECT_NEAR(by["u"], (by["A"] * x + by["B"] * y + by["C"]) / q, 1e-9 * (1 + std::abs(by["u"])));
        EXPECT_NEAR(by["M"], by["A"] * by["H"] - by["B"] * by["G"], 1e-12);
        EXPECT_NEAR(by["N"], by["D"] * by["H"] - by["E"] * by["G"], 1e-12);
        EXPECT_EQ(by["O"], -by["M"]);
        EXPECT_EQ(by["P"], -by["N"]);
        constexpr double kStep = 1e-4;
        const TexelPoint right = map.at(x + kStep, y), left = map.at(x - kStep, y);
        const TexelPoint down = map.at(x, y + kStep), up = map.at(x, y - kStep);
        const double size = by["major"] + 1e-9;
        EXPECT_NEAR(by["ux"], (right.s - left.s) / (2 * kStep), 1e-3 * size);
        EXPECT_NEAR(by["vx"], (right.t - left.t) / (2 * kStep), 1e-3 * size);
        EXPECT_NEAR(by["uy"], (down.s - up.s) / (2 * kStep), 1e-3 * size);
        EXPECT_NEAR(by["vy"], (down.t - up.t) / (2 * kStep), 1e-3 * size);
        EXPECT_NEAR(by["ellipse_A"], by["vx"] * by["vx"] + by["vy"] * by["vy"], 1e-9 * (1 + by["ellipse_A"]));
        EXPECT_NEAR(by["ellipse_F"], by["ellipse_A"] * by["ellipse_C"] - by["ellipse_B"] * by["ellipse_B"] / 4,
                    1e-6 * (by["ellipse_A"] * by["ellipse_C"] + 1e-12));
    }
}

// The point one pixel to the right lies on the circle of radius 1.
TEST(Coefficients, squaredRadiusIsThatOfThePixel) {
    const Jacobian j{1.5, 0.25, -0.5, 2};
    const Ellipse ellipse = ellipseOf(j);
    EXPECT_NEAR(squaredRadius(ellipse, j.ux, j.vx), 1, 1e-12);
    EXPECT_NEAR(squaredRadius(ellipse, 3 * j.uy, 3 * j.vy), 9, 1e-12);
    EXPECT_EQ(squaredRadius(ellipse, 0, 0), 0);
    EXPECT_EQ(squaredRadius(ellipseOf(Jacobian{0, 0, 0, 0}), 1, 1), 0);
}

}  // namespace
}  // namespace relief
