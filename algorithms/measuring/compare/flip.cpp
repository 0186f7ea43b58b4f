#include "measuring/compare/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "base/parallel.h"
#include "relief/memory.h"

namespace relief {

namespace {

using glm::dvec3;
using Plane = Image<float>;
using Planes = Image<glm::vec3>;

// Section 4.1.3: the exponent, and the bend of the error mapping.
constexpr double kColorExponent = 0.7;
constexpr double kBendError = 0.4;
constexpr double kBendValue = 0.95;
// Section 4.2: width of the feature detectors in degrees, and the exponent.
constexpr double kFeatureDegrees = 0.082;
constexpr double kFeatureExponent = 0.5;

// Section 4.1.1: contrast sensitivity of a channel as a sum of two Gaussians a sqrt(pi / b) exp(-pi^2 r^2 / b).
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr Sensitivity kAchromatic{1.0, 0.0047, 0.0, 1e-5};
constexpr Sensitivity kRedGreen{1.0, 0.0053, 0.0, 1e-5};
constexpr Sensitivity kBlueYellow{34.1, 0.04, 13.5, 0.025};
constexpr double kWidest = 0.04;

// sRGB primaries, D65. Each column is the contribution of one unit of R, G, B.
const glm::dmat3 kXyzFromRgb{0.41238656, 0.21263682, 0.01933062, 0.35759149, 0.71518298,
                             0.11919716, 0.18045049, 0.07218020, 0.95037259};
const glm::dmat3 kRgbFromXyz = glm::inverse(kXyzFromRgb);
const dvec3 kWhite = kXyzFromRgb * dvec3(1);

// Converts to the linear opponent space in which the pictures are filtered.
dvec3 opponentFromXyz(const dvec3& xyz) {
    const dvec3 n = xyz / kWhite;
    return {116 * n.y - 16, 500 * (n.x - n.y), 200 * (n.y - n.z)};
}
dvec3 xyzFromOpponent(const dvec3& c) {
    const double y = (c.x + 16) / 116;
    return dvec3(y + c.y / 500, y, y - c.z / 200) * kWhite;
}

dvec3 labFromRgb(const dvec3& rgb) {
    constexpr double kDelta = 6.0 / 29.0;
    const auto curve = [](double v) {
        return v > kDelta * kDelta * kDelta ? std::cbrt(v) : v / (3 * kDelta * kDelta) + 4.0 / 29.0;
    };
    const dvec3 n = kXyzFromRgb * rgb / kWhite;
    const dvec3 f{curve(n.x), curve(n.y), curve(n.z)};
    return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

// Perceived colourfulness grows with luminance (Hunt).
dvec3 huntAdjusted(const dvec3& lab) {
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

double hyab(const dvec3& a, const dvec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// Weights of offsets -radius ... radius.
using Taps = std::vector<double>;

template <class T, class Wide>
Image<T> convolveRows(const Image<T>& in, const std::vector<Wide>& taps, Work& work) {
    const int radius = static_cast<int>(taps.size() / 2);
    Image<T> out(in.width(), in.height());
    parallelFor(work, in.height(), [&](int y) {
        for (int x = 0; x < in.width(); ++x) {
            Wide sum(0);
            for (int k = -radius; k <= radius; ++k) {
                sum += taps[static_cast<std::size_t>(k + radius)] * Wide(in(std::clamp(x + k, 0, in.width() - 1), y));
            }
            out(x, y) = T(sum);
        }
    });
    return out;
}

template <class T, class Wide>
Image<T> convolveColumns(const Image<T>& in, const std::vector<Wide>& taps, Work& work) {
    const int radius = static_cast<int>(taps.size() / 2);
    Image<T> out(in.width(), in.height());
    parallelFor(work, in.height(), [&](int y) {
        std::vector<Wide> sums(static_cast<std::size_t>(in.width()), Wide(0));
        for (int k = -radius; k <= radius; ++k) {
            const auto row = in.row(std::clamp(y + k, 0, in.height() - 1));
            const Wide tap = taps[static_cast<std::size_t>(k + radius)];
            for (std::size_t x = 0; x < sums.size(); ++x) sums[x] += tap * Wide(row[x]);
        }
        for (std::size_t x = 0; x < sums.size(); ++x) out.row(y)[x] = T(sums[x]);
    });
    return out;
}

// One of the two Gaussians of every channel, with its share of the channel's total. The published two-dimensional
// filter is a sum of such separable filters.
struct SpatialFilter {
    std::vector<dvec3> taps;
    dvec3 share;
};

SpatialFilter spatialFilter(int radius, double pixelsPerDegree, bool second) {
    constexpr double kPi = std::numbers::pi;
    const auto channel = [&](const Sensitivity& s, double offset) {
        const double x = offset / pixelsPerDegree;
        return std::exp(-kPi * kPi * x * x / (second ? s.b2 : s.b1));
    };
    SpatialFilter filter;
    dvec3 sum(0);
    for (int k = -radius; k <= radius; ++k) {
        filter.taps.emplace_back(channel(kAchromatic, k), channel(kRedGreen, k), channel(kBlueYellow, k));
        sum += filter.taps.back();
    }
    const auto weight = [&](const Sensitivity& s) {
        return second ? s.a2 * std::sqrt(kPi / s.b2) : s.a1 * std::sqrt(kPi / s.b1);
    };
    filter.share = sum * sum * dvec3(weight(kAchromatic), weight(kRedGreen), weight(kBlueYellow));
    for (dvec3& tap : filter.taps) tap /= sum;
    return filter;
}

// Section 4.1.1: attenuates detail that the eye cannot resolve, in the opponent space.
Planes spatiallyFiltered(const Planes& opponent, double pixelsPerDegree, Work& work) {
    constexpr double kPi = std::numbers::pi;
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi * kPi)) * pixelsPerDegree));
    const SpatialFilter first = spatialFilter(radius, pixelsPerDegree, false);
    const SpatialFilter second = spatialFilter(radius, pixelsPerDegree, true);
    const Planes a = convolveColumns(convolveRows(opponent, first.taps, work), first.taps, work);
    const Planes b = convolveColumns(convolveRows(opponent, second.taps, work), second.taps, work);
    const dvec3 total = first.share + second.share;
    Planes out(opponent.width(), opponent.height());
    parallelFor(work, out.height(), [&](int y) {
        for (int x = 0; x < out.width(); ++x) {
            out(x, y) = glm::vec3((first.share * dvec3(a(x, y)) + second.share * dvec3(b(x, y))) / total);
        }
    });
    return out;
}

struct FeatureFilters {
    Taps smooth, edge, point;
};

FeatureFilters featureFilters(double pixelsPerDegree) {
    const double deviation = 0.5 * kFeatureDegrees * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    FeatureFilters filters;
    for (int k = -radius; k <= radius; ++k) {
        const double gauss = std::exp(-k * k / (2 * deviation * deviation));
        filters.smooth.push_back(gauss);
        filters.edge.push_back(-k * gauss);
        filters.point.push_back((k * k / (deviation * deviation) - 1) * gauss);
    }
    // Positive weights sum to 1 and negative ones to -1, so that a step of full contrast gives 1.
    const auto balance = [](Taps& taps, bool bothSigns) {
        double positive = 0;
        double negative = 0;
        for (const double tap : taps) (tap > 0 ? positive : negative) += std::abs(tap);
        for (double& tap : taps) tap /= tap > 0 || !bothSigns ? positive : negative;
    };
    balance(filters.smooth, false);
    balance(filters.edge, true);
    balance(filters.point, true);
    return filters;
}

// Section 4.2: strength of edges and points; the larger difference of the two counts.
struct Features {
    Plane edge, point;
};

Features features(const Planes& opponent, double pixelsPerDegree, Work& work) {
    Plane grey(opponent.width(), opponent.height());
    parallelFor(work, grey.height(), [&](int y) {
        for (int x = 0; x < grey.width(); ++x) grey(x, y) = (opponent(x, y).x + 16) / 116;
    });
    const FeatureFilters filters = featureFilters(pixelsPerDegree);
    const Plane smoothRows = convolveRows(grey, filters.smooth, work);
    const Plane smoothColumns = convolveColumns(grey, filters.smooth, work);
    const auto strength = [&](const Taps& taps) {
        const Plane alongX = convolveRows(smoothColumns, taps, work);
        const Plane alongY = convolveColumns(smoothRows, taps, work);
        Plane out(grey.width(), grey.height());
        parallelFor(work, out.height(), [&](int y) {
            for (int x = 0; x < out.width(); ++x) out(x, y) = std::hypot(alongX(x, y), alongY(x, y));
        });
        return out;
    };
    return {strength(filters.edge), strength(filters.point)};
}

Planes opponentPicture(const ColorImage& picture, Work& work) {
    Planes out(picture.width(), picture.height());
    parallelFor(work, out.height(), [&](int y) {
        for (int x = 0; x < out.width(); ++x) {
            const dvec3 rgb = glm::clamp(dvec3(picture(x, y)), 0.0, 1.0);
            out(x, y) = glm::vec3(opponentFromXyz(kXyzFromRgb * rgb));
        }
    });
    return out;
}

dvec3 adjustedLab(const glm::vec3& opponent) {
    return huntAdjusted(labFromRgb(glm::clamp(kRgbFromXyz * xyzFromOpponent(dvec3(opponent)), 0.0, 1.0)));
}

// Section 4.1.3: small differences use most of the scale.
double colorError(const dvec3& a, const dvec3& b, double largest) {
    const double error = std::pow(hyab(a, b), kColorExponent);
    const double bend = kBendError * largest;
    return error < bend ? error * kBendValue / bend : kBendValue + (error - bend) / (largest - bend) * (1 - kBendValue);
}

}  // namespace

FloatImage flipErrors(const ColorImage& reference, const ColorImage& test, double pixelsPerDegree, Work& work) {
    // Per pixel: both pictures in the opponent space and filtered, the features of one picture, and the peak of
    // computing the other's.
    constexpr std::uint64_t kBytes = 4 * sizeof(Planes::Value) + 10 * sizeof(Plane::Value);
    requireMemory(byteProduct({reference.size(), kBytes}), "FLIP", MemoryHint::SmallerPicture);
    const Planes opponentA = opponentPicture(reference, work);
    const Planes opponentB = opponentPicture(test, work);
    const Planes seenA = spatiallyFiltered(opponentA, pixelsPerDegree, work);
    const Planes seenB = spatiallyFiltered(opponentB, pixelsPerDegree, work);
    const Features featuresA = features(opponentA, pixelsPerDegree, work);
    const Features featuresB = features(opponentB, pixelsPerDegree, work);
    const double largest =
        std::pow(hyab(huntAdjusted(labFromRgb({0, 1, 0})), huntAdjusted(labFromRgb({0, 0, 1}))), kColorExponent);
    FloatImage out(reference.width(), reference.height());
    parallelFor(work, out.height(), [&](int y) {
        for (int x = 0; x < out.width(); ++x) {
            const double color = colorError(adjustedLab(seenA(x, y)), adjustedLab(seenB(x, y)), largest);
            const float edge = std::abs(featuresA.edge(x, y) - featuresB.edge(x, y));
            const float point = std::abs(featuresA.point(x, y) - featuresB.point(x, y));
            const double feature =
                std::pow(static_cast<double>(std::max(edge, point)) / std::numbers::sqrt2, kFeatureExponent);
            out(x, y) = static_cast<float>(std::clamp(std::pow(color, 1 - feature), 0.0, 1.0));
        }
    });
    return out;
}

}  // namespace relief
