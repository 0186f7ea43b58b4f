#include "filtering/lane_job.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "filtering/level_footprint.h"

namespace relief {

namespace {

// Splits a coordinate into its texel and the position in it. The result is in [0, size) under repeat, and near the
// picture otherwise. Returns false if x is not finite or too large.
bool placed(double x, double size, bool repeat, std::int32_t& whole, float& rest) {
    if (!(std::abs(x) <= kFarthest)) return false;
    if (repeat && !(x >= 0 && x < size)) {
        x -= std::floor(x / size) * size;
        if (!(x >= 0 && x < size)) x = 0;
    } else if (!repeat) {
        x = std::min(std::max(x, -kBeyond * size), kBeyond * size);
    }
    // Floor, without a function call.
    whole = static_cast<std::int32_t>(x);
    if (whole > x) --whole;
    rest = static_cast<float>(x - whole);
    return true;
}

}  // namespace

void LaneChunk::fill(const LaneJob& job, std::size_t begin, std::size_t from) {
    const bool repeat = job.levels->address == Address::Repeat;
    count = std::min(kLanePixels, job.count - begin);
    const auto none = [&](std::size_t k) {
        valid[k] = 0;
        wholeS[k] = wholeT[k] = 0;
        restS[k] = restT[k] = 0;
    };
    for (std::size_t k = from; k < count; ++k) {
        const std::size_t i = begin + k;
        valid[k] = 1;
        if (!placed(job.s[i] * job.perS, job.width, repeat, wholeS[k], restS[k]) ||
            !placed(job.t[i] * job.perT, job.height, repeat, wholeT[k], restT[k])) {
            none(k);
        }
        const auto footprint = [&](const double* column, std::size_t n, double per) {
            return column == nullptr ? job.narrow[n][i] : static_cast<float>(column[i] * per);
        };
        ux[k] = footprint(job.ux, 0, job.perS), vx[k] = footprint(job.vx, 1, job.perT);
        uy[k] = footprint(job.uy, 2, job.perS), vy[k] = footprint(job.vy, 3, job.perT);
    }
    for (std::size_t k = count; k < (count + kMostLanes - 1) / kMostLanes * kMostLanes; ++k) {
        none(k);
        ux[k] = vx[k] = uy[k] = vy[k] = 0;
    }
}

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
