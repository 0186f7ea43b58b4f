#include "filtering/weight_map.h"

#include <algorithm>
#include <cmath>

namespace relief {

double radialWeight(const EllipticalSettings& settings, double r) {
    if (r > settings.radius) return 0;
    if (settings.weights == WeightKind::Uniform) return 1;
    const double x = r / settings.sigma;
    return std::exp(-0.5 * x * x);
}

double mapError(const EllipticalSettings& settings) {
    // The Gaussian is steepest at r = sigma, where its slope is exp(-1/2) / sigma.
    const double halfDiagonal = std::sqrt(2.0) * settings.radius / settings.resolution;
    return halfDiagonal * std::exp(-0.5) / settings.sigma;
}

RadialTable::RadialTable(const EllipticalSettings& settings) {
    const int entries = settings.resolution * settings.resolution;
    weights_.reserve(static_cast<std::size_t>(entries) + 1);
    for (int i = 0; i < entries; ++i) {
        weights_.push_back(
            static_cast<float>(radialWeight(settings, settings.radius * std::sqrt((i + 0.5) / entries))));
    }
    weights_.push_back(weights_.back());
    scale_ = static_cast<float>(entries);
}

WeightMap::WeightMap(const EllipticalSettings& settings)
    : weights_(settings.resolution, settings.resolution, glm::vec3(0)),
      reach_(static_cast<float>(settings.radius)),
      scale_(static_cast<float>(settings.resolution / (2 * settings.radius))) {
    const int n = settings.resolution;
    const auto place = [&](int i) { return ((i + 0.5) / n * 2 - 1) * settings.radius; };
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const double dx = place(x);
            const double dy = place(y);
            if (!settings.shaped()) {
                weights_(x, y) = glm::vec3(static_cast<float>(radialWeight(settings, std::hypot(dx, dy))));
                continue;
            }
            for (int c = 0; c < 3; ++c) {
                weights_(x, y)[c] = static_cast<float>(pixelFactorAcross(settings.model(), c, dx) *
                                                       pixelFactorDown(settings.model(), c, dy));
            }
        }
    }
}

}  // namespace relief
