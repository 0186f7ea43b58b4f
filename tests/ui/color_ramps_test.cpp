// The colour maps are readable for everybody: larger magnitude is lighter, on each side of 0 and with each colour
// vision deficiency, and the two sides are distinguishable.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "painting/style.h"

namespace reliefui {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;
using Lab = std::array<double, 3>;

struct Vision {
    std::string name;
    Matrix seen;  // in linear RGB
};

// Machado, Oliveira, Fernandes 2009, severity 1.
const std::array<Vision, 4> kVisions{
    {{"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
     {"protanopia",
      {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
     {"deuteranopia",
      {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
     {"tritanopia",
      {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}}};

double linear(double code) {
    const double c = code / 255;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// CIE 1976 L*a*b* of an sRGB colour, white D65.
Lab labOf(Rgba color, const Vision& vision) {
    const std::array<double, 3> own{linear(color.r), linear(color.g), linear(color.b)};
    std::array<double, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) rgb[i] += vision.seen[i][k] * own[k];
        rgb[i] = std::min(std::max(rgb[i], 0.0), 1.0);
    }
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const double x = f((0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2]) / 0.95047);
    const double y = f(0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2]);
    const double z = f((0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2]) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double deltaE(const Lab& a, const Lab& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

constexpr int kSteps = 16;
// Smallest difference of L* between adjacent sixteenths of a map: half of that of a map from 20 to 90 with constant
// steps.
constexpr double kLeastStep = 2;
// Smallest CIE 1976 difference of the two sides: far more than a just noticeable difference (2.3).
constexpr double kSidesApart = 40;

// Checks that the map becomes lighter from position `from` to position `to`.
void expectLighter(const Style& style, ColorMap map, double from, double to, const std::string& name) {
    for (const Vision& vision : kVisions) {
        double before = 0;
        for (int k = 0; k <= kSteps; ++k) {
            const double light = labOf(style.mapped(map, from + (to - from) * k / kSteps), vision)[0];
            if (k > 0) {
                EXPECT_GT(light - before, kLeastStep) << name << ", " << vision.name << ", step " << k;
            }
            before = light;
        }
    }
}

}  // namespace

TEST(ColorRamps, SequentialMapsGetLighterForEverybody) {
    Style style;
    expectLighter(style, ColorMap::Count, 0, 1, "count");
    expectLighter(style, ColorMap::Distance, 0, 1, "distance");
    expectLighter(style, ColorMap::Level, 1, 0, "level");
    expectLighter(style, ColorMap::Height, 0, 1, "grey");
    style.heights = HeightColors::Cividis;
    expectLighter(style, ColorMap::Height, 0, 1, "cividis");
}

TEST(ColorRamps, TwoSidedMapsDoSoOnEitherSideAndTheSidesDiffer) {
    const Style style;
    constexpr double kMiddle = 1e-9;  // the two sides of a map with a dark middle meet in a discontinuity
    expectLighter(style, ColorMap::Signed, 0.5 - kMiddle, 0, "short");
    expectLighter(style, ColorMap::Signed, 0.5, 1, "past");
    expectLighter(style, ColorMap::Difference, 0, 0.5, "less");
    expectLighter(style, ColorMap::Difference, 1, 0.5, "more");
    const auto apart = [&](ColorMap map, double size, const Vision& vision) {
        return deltaE(labOf(style.mapped(map, 0.5 - size / 2 - kMiddle), vision),
                      labOf(style.mapped(map, 0.5 + size / 2), vision));
    };
    for (const Vision& vision : kVisions) {
        for (int k = 0; k <= kSteps; ++k) {
            EXPECT_GT(apart(ColorMap::Signed, static_cast<double>(k) / kSteps, vision), kSidesApart)
                << vision.name << ", size " << k;
        }
        EXPECT_GT(apart(ColorMap::Difference, 1, vision), kSidesApart) << vision.name;
        EXPECT_GT(apart(ColorMap::Difference, 0.5, vision), kSidesApart) << vision.name;
    }
}

// The colour for values below a threshold differs from all colours of the map.
TEST(ColorRamps, WhatIsUnderAThresholdStandsApart) {
    constexpr double kApart = 10;
    for (const Vision& vision : kVisions) {
        for (const ColorMap map : {ColorMap::Count, ColorMap::Distance, ColorMap::Signed}) {
            for (int k = 0; k <= kSteps; ++k) {
                const Rgba color = Style().mapped(map, static_cast<double>(k) / kSteps);
                EXPECT_GT(deltaE(labOf(color, vision), labOf(Style::under(map), vision)), kApart) << vision.name;
            }
        }
    }
}

}  // namespace reliefui
