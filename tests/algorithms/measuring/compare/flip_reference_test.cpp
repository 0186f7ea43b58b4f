// An independent implementation of FLIP, pixel by pixel from the published definition: two-dimensional filters in
// double, no code shared with the library.
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "measuring/compare/flip.h"

namespace relief {
namespace {

// The library stores filtered planes in float (an error of 1e-7 was measured first); powers of small differences
// magnify it.
constexpr double kFloatPlanes = 1e-5;

using Rgb = std::array<double, 3>;
using Filter = std::function<double(int, int)>;
using Pixels = std::function<double(int, int)>;

// The matrix from sRGB to XYZ with the authors' fractions.
Rgb xyzOf(const Rgb& c) {
    return {10135552.0 / 24577794 * c[0] + 8788810.0 / 24577794 * c[1] + 4435075.0 / 24577794 * c[2],
            2613072.0 / 12288897 * c[0] + 8788810.0 / 12288897 * c[1] + 887015.0 / 12288897 * c[2],
            1425312.0 / 73733382 * c[0] + 8788810.0 / 73733382 * c[1] + 70074185.0 / 73733382 * c[2]};
}
const Rgb kWhite{0.950428545, 1.0, 1.088900371};

// Inverse of xyzOf by Cramer's rule.
Rgb rgbOf(const Rgb& xyz) {
    std::array<Rgb, 3> columns{xyzOf({1, 0, 0}), xyzOf({0, 1, 0}), xyzOf({0, 0, 1})};
    const auto det = [](const Rgb& a, const Rgb& b, const Rgb& c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
               c[0] * (a[1] * b[2] - a[2] * b[1]);
    };
    const double all = det(columns[0], columns[1], columns[2]);
    return {det(xyz, columns[1], columns[2]) / all, det(columns[0], xyz, columns[2]) / all,
            det(columns[0], columns[1], xyz) / all};
}

Rgb opponentOf(const Rgb& rgb) {
    const Rgb xyz = xyzOf(rgb);
    const double x = xyz[0] / kWhite[0];
    const double y = xyz[1] / kWhite[1];
    const double z = xyz[2] / kWhite[2];
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Hunt-adjusted L*a*b* of a colour in the opponent space, clamped to the display's gamut.
Rgb seenOf(const Rgb& opponent) {
    const double y = (opponent[0] + 16) / 116;
    Rgb rgb = rgbOf({(opponent[1] / 500 + y) * kWhite[0], y * kWhite[1], (y - opponent[2] / 200) * kWhite[2]});
    for (double& v : rgb) v = std::min(std::max(v, 0.0), 1.0);
    const Rgb xyz = xyzOf(rgb);
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : t * 841.0 / 108 + 4.0 / 29; };
    const double fx = f(xyz[0] / kWhite[0]);
    const double fy = f(xyz[1] / kWhite[1]);
    const double fz = f(xyz[2] / kWhite[2]);
    const double lightness = 116 * fy - 16;
    return {lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)};
}

double hyab(const Rgb& a, const Rgb& b) {
    return std::abs(a[0] - b[0]) + std::sqrt((a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

double convolved(const Pixels& pixels, const Filter& filter, int radius, int x, int y) {
    double sum = 0;
    for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) sum += filter(i, j) * pixels(x + i, y + j);
    }
    return sum;
}

double referenceFlip(const ColorImage& a, const ColorImage& b, double ppd, int x, int y) {
    const auto colorAt = [](const ColorImage& image, int i, int j) {
        const Color& c = image(std::clamp(i, 0, image.width() - 1), std::clamp(j, 0, image.height() - 1));
        return opponentOf({std::min(std::max(double(c.r), 0.0), 1.0), std::min(std::max(double(c.g), 0.0), 1.0),
                           std::min(std::max(double(c.b), 0.0), 1.0)});
    };
    constexpr double kPi = std::numbers::pi;
    // Contrast sensitivity: a1, b1, a2, b2 for each of the three channels.
    const std::array<std::array<double, 4>, 3> channels{
        {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};
    const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
    const auto seen = [&](const ColorImage& image) {
        Rgb filtered{};
        for (std::size_t c = 0; c < 3; ++c) {
            const auto& k = channels[c];
            const Filter weight = [&](int i, int j) {
                const double d = (i * i + j * j) / (ppd * ppd);
                return k[0] * std::sqrt(kPi / k[1]) * std::exp(-kPi * kPi * d / k[1]) +
                       k[2] * std::sqrt(kPi / k[3]) * std::exp(-kPi * kPi * d / k[3]);
            };
            const double sum = convolved([](int, int) { return 1.0; }, weight, radius, 0, 0);
            filtered[c] = convolved([&](int i, int j) { return colorAt(image, i, j)[c]; }, weight, radius, x, y) / sum;
        }
        return seenOf(filtered);
    };
    const double cmax = std::pow(hyab(seenOf(opponentOf({0, 1, 0})), seenOf(opponentOf({0, 0, 1}))), 0.7);
    const double power = std::pow(hyab(seen(a), seen(b)), 0.7);
    const double color =
        power < 0.4 * cmax ? power * 0.95 / (0.4 * cmax) : 0.95 + (power - 0.4 * cmax) / (0.6 * cmax) * 0.05;

    const double sd = 0.5 * 0.082 * ppd;
    const int reach = int(std::ceil(3 * sd));
    const auto strength = [&](const ColorImage& image, bool point) {
        const Filter raw = [&](int i, int j) {
            const double g = std::exp(-(i * i + j * j) / (2 * sd * sd));
            return point ? (i * i / (sd * sd) - 1) * g : -i * g;
        };
        double positive = 0;
        double negative = 0;
        for (int j = -reach; j <= reach; ++j) {
            for (int i = -reach; i <= reach; ++i) (raw(i, j) > 0 ? positive : negative) += std::abs(raw(i, j));
        }
        const Pixels grey = [&](int i, int j) { return (colorAt(image, i, j)[0] + 16) / 116; };
        const auto balanced = [&](double w) { return w > 0 ? w / positive : w / negative; };
        return std::hypot(convolved(
                              grey, [&](int i, int j) { return balanced(raw(i, j)); }, reach, x, y),
                          convolved(
                              grey, [&](int i, int j) { return balanced(raw(j, i)); }, reach, x, y));
    };
    const double feature =
        std::max(std::abs(strength(a, false) - strength(b, false)), std::abs(strength(a, true) - strength(b, true)));
    return std::pow(color, 1 - std::sqrt(feature / std::sqrt(2.0)));
}

// Stripes and a disc in saturated colours; `other`: with other colours, shifted and noisy.
ColorImage picture(bool other) {
    ColorImage image(48, 36);
    for (int y = 0; y < 36; ++y) {
        for (int x = 0; x < 48; ++x) {
            const bool stripe = (x + (other ? 1 : 0)) / 5 % 2 == 0;
            const bool disc = (x - 30) * (x - 30) + (y - 18) * (y - 18) < (other ? 90 : 110);
            const float noise = other ? 0.05F * static_cast<float>((x * 31 + y * 17) % 7) : 0.0F;
            image(x, y) = disc ? Color(0.9F - noise, 0.2F, other ? 0.5F : 0.1F)
                               : (stripe ? Color(0.05F, 0.4F + noise, 0.8F) : Color(0.7F, 0.75F, 0.6F));
        }
    }
    return image;
}

TEST(Flip, everyPixelIsThePublishedDefinition) {
    const ColorImage a = picture(false);
    const ColorImage b = picture(true);
    Work work(2);
    for (const double ppd : {67.0, 25.0}) {
        const FloatImage errors = flipErrors(a, b, ppd, work);
        double worst = 0;
        double largest = 0;
        for (int y = 0; y < 36; y += 3) {
            for (int x = 0; x < 48; x += 3) {
                const double reference = referenceFlip(a, b, ppd, x, y);
                worst = std::max(worst, std::abs(reference - static_cast<double>(errors(x, y))));
                largest = std::max(largest, reference);
            }
        }
        std::cout << ppd << " pixels a degree: largest error " << largest << ", at most " << worst << " apart\n";
        EXPECT_LE(worst, kFloatPlanes);
        EXPECT_GT(largest, 0.3);
    }
}

}  // namespace
}  // namespace relief
