#include "filtering/lane_job.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "filtering/level_footprint.h"

namespace relief {

LaneJob laneJob(const LaneLevels& levels, const EllipticalSettings& settings) {
    const auto squared = [](double x) { return static_cast<float>(x * x); };
    LaneJob job;
    job.levels = &levels;
    job.weights = settings.weights;
    job.top = levels.count - 1;
    job.width = levels.width[0];
    job.height = levels.height[0];
    job.radius = static_cast<float>(settings.radius);
    job.radiusSquare = squared(settings.radius);
    job.exponent = static_cast<float>(std::numbers::log2e / (2 * settings.sigma * settings.sigma));
    job.perFloorSquare = squared(1 / settings.floor);
    job.perAnisotropySquare = squared(1 / settings.anisotropy);
    job.leastMinorSquare = squared(settings.smallestMinor());
    job.mostSquare = squared(largestMajor(levels.width[0], levels.height[0]));
    job.smallSquare = squared(bilinearMajor(settings));
    for (int l = 0; l < levels.count; ++l) {
        const auto n = static_cast<std::size_t>(l);
        job.scale[n] = std::ldexp(1.0F, -l);
        job.texelTerm[n] = static_cast<float>(texelVariance(l, settings));
    }
    return job;
}

}  // namespace relief
