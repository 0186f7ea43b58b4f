#include "filtering/elliptical_options.h"

#include <algorithm>
#include <cmath>

namespace relief {

namespace {

// sqrt(1/2), and a little for rounding.
constexpr double kCoveringRadius = 0.7072;
// Beyond this many sigma a Gaussian pixel is cut: 4% of the peak, chosen by measured error.
constexpr double kGaussianCut = 2.5;
// Radii at which these come nearest to a Gaussian pixel (checker, brick; 60, 25, 8 degrees). Nearest to a box pixel
// they come at 0.6 and 0.7.
constexpr double kUniformRadius = 0.9;
constexpr double kTexelDistanceRadius = 1.15;

// Texels of a level across half a pixel whose shape a map has: below it the shape is too coarse (brick, box pixel:
// error 5.6 at 1.4, 3.6 at 2, 2.0 at 3, times 1000, for 1, 1.6 and 5 times the texels).
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
    // Shapes have no closed form over r^2; distance in texels has none over the pixel.
    if (settings.shaped()) settings.source = WeightSource::Map;
    if (settings.weights == WeightKind::TexelDistance) settings.source = WeightSource::Direct;
    settings.resolution = options.resolution;
    settings.implementation = options.implementation == "lanes" ? Implementation::Lanes : Implementation::Scalar;
    // A level on which some channel could miss every texel is too coarse.
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
