#include "filtering/elliptical_options.h"

#include <algorithm>
#include <cmath>

namespace relief {

namespace {

// sqrt(1/2), rounded up.
constexpr double kCoveringRadius = 0.7072;
// A Gaussian pixel is cut off at this number of sigma, at 4% of its peak. Chosen by measured error.
constexpr double kGaussianCut = 2.5;
// Radii, in pixels, with the smallest error against a Gaussian pixel (checker, bricks; 60, 25, 8 degrees). Against a
// box pixel the best radii are 0.6 and 0.7.
constexpr double kUniformRadius = 0.9;
constexpr double kTexelDistanceRadius = 1.15;

// Smallest number of texels of a level across half a pixel that represents the shape of the pixel. RMSE on bricks
// against a box pixel: 5.6e-3 with 1.4, 3.6e-3 with 2, 2.0e-3 with 3, for 1, 1.6 and 5 times the texels.
constexpr double kShapeFloor = 2;

WeightKind weightKind(const std::string& name) {
    constexpr std::array<std::string_view, 6> kNames{"uniform", "gaussian", "texel-distance", "box", "lcd", "crt"};
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    return static_cast<WeightKind>(found - kNames.begin());
}

double radiusOf(WeightKind weights, double sigma) {
    switch (weights) {
        case WeightKind::Uniform:
            return kUniformRadius;
        case WeightKind::Gaussian:
            return kGaussianCut * sigma;
        case WeightKind::TexelDistance:
            return kTexelDistanceRadius;
        case WeightKind::Box:
        case WeightKind::Lcd:
            return 0.7072;  // the square's corners
        case WeightKind::Crt:
            break;
    }
    return kCrtCircle + kGaussianCut * kCrtSigma;
}

}  // namespace

EllipticalSettings EllipticalSettings::of(const EllipticalOptions& options) {
    EllipticalSettings settings;
    settings.weights = weightKind(options.weights);
    settings.sigma = options.sigma;
    settings.radius = options.radius > 0 ? options.radius : radiusOf(settings.weights, options.sigma);
    settings.exhaustive = options.levels == "exhaustive";
    settings.anisotropy = options.anisotropy;
    settings.texelSize = settings.weights == WeightKind::Gaussian && options.texelSize == "on";
    settings.source = options.source == "table" ? WeightSource::Table
                      : options.source == "map" ? WeightSource::Map
                                                : WeightSource::Direct;
    // Pixel shapes have no closed form over r^2, and the distance in texels has none over the pixel.
    if (settings.shaped()) settings.source = WeightSource::Map;
    if (settings.weights == WeightKind::TexelDistance) settings.source = WeightSource::Direct;
    settings.resolution = options.resolution;
    settings.implementation = options.implementation == "lanes" ? Implementation::Lanes : Implementation::Scalar;
    // On a coarser level some channel could miss every texel.
    settings.floor = std::max(options.floor, settings.shaped() ? std::max(kShapeFloor, settings.smallestMinor()) : 0.0);
    return settings;
}

double EllipticalSettings::smallestMinor() const {
    switch (weights) {
        case WeightKind::Box:
            return kCoveringRadius / 0.5;
        case WeightKind::Lcd:
            return kCoveringRadius * 6;
        case WeightKind::Crt:
            return kCoveringRadius / (kGaussianCut * kCrtSigma);
        default:
            return kCoveringRadius / radius;
    }
}

PixelModel EllipticalSettings::model() const {
    switch (weights) {
        case WeightKind::Box:
            return PixelModel::Box;
        case WeightKind::Lcd:
            return PixelModel::Lcd;
        case WeightKind::Crt:
            return PixelModel::Crt;
        default:
            return PixelModel::Gaussian;
    }
}

}  // namespace relief
