#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "base/scratch_pool.h"
#include "relief/maps/refined.h"

namespace relief {

std::vector<SampledDirection> sampledDirections(int count, double slabTexels, double maxRun) {
    const double sinFlattest = slabTexels / std::hypot(slabTexels, maxRun);
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<SampledDirection> directions;
    for (int i = 0; i < count; ++i) {
        const double sine = sinFlattest + (1 - sinFlattest) * (i + 0.5) / count;
        const double run = slabTexels * std::sqrt(1 - sine * sine) / sine;
        directions.push_back({run * std::cos(golden * i), run * std::sin(golden * i), slabTexels / sine});
    }
    return directions;
}

void refinedSampled(const DistanceMap& map, int nx, int ny, const HeightField& field, const ExactHits& exactHits,
                    UnfilledVector<float>& values, Work& work) {
    const std::vector<SampledDirection> directions =
        sampledDirections(map.parameters.directions, map.slabTexels, map.maxRun);
    const std::size_t count = directions.size();
    struct Scratch {
        RayBlock rays;
        HitBlock hits;
    };
    ScratchPool<Scratch> pool;
    // Voxels of a row that are traced together, so that a thread holds some megabytes of rays.
    constexpr std::size_t kMostRays = std::size_t{1} << 16;
    const int together = static_cast<int>(std::clamp<std::size_t>(kMostRays / count, 1, static_cast<std::size_t>(nx)));
    // Computes the voxels first ... last - 1 of a row of layer k.
    const auto voxels = [&](int first, int last, int y, int k, Scratch& scratch, float* out) {
        const double lambda = 1 - map.centreZ(k);
        const double t = (y + 0.5) * field.height() / ny;
        scratch.rays.resize(static_cast<std::size_t>(last - first) * count);
        for (int x = first; x < last; ++x) {
            const double s = (x + 0.5) * field.width() / nx;
            for (std::size_t d = 0; d < count; ++d) {
                const SampledDirection& direction = directions[d];
                scratch.rays.set(static_cast<std::size_t>(x - first) * count + d,
                                 {s - lambda * direction.a, t - lambda * direction.b, direction.a, direction.b});
            }
        }
        exactHits(scratch.rays, scratch.hits);
        for (int x = first; x < last; ++x) {
            const bool solid = field.at((x + 0.5) * field.width() / nx, t) >= 1 - lambda;
            double least = solid ? 0 : (1 - lambda + 1) * map.slabTexels;  // if no ray arrives: more than any drop
            for (std::size_t d = 0; !solid && d < count; ++d) {
                const Hit hit = scratch.hits[static_cast<std::size_t>(x - first) * count + d];
                if (hit.outcome != Outcome::Hit || hit.lambda < lambda - kReached) continue;
                least = std::min(least, std::max(hit.lambda - lambda, 0.0) * directions[d].length);
            }
            out[x] = static_cast<float>(least);
        }
    };
    const int layers = map.layers();
    work.progress().begin("map refined-sampled", ny);
    parallelFor(work, ny, [&](int y) {
        const auto scratch = pool.borrow();
        for (int k = 0; k < layers; ++k) {
            const auto first = static_cast<std::size_t>(k) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y);
            float* const out = values.data() + first * static_cast<std::size_t>(nx);
            for (int x = 0; x < nx; x += together) voxels(x, std::min(x + together, nx), y, k, *scratch, out);
        }
        work.progress().advance();
    });
}

}  // namespace relief
