#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "relief/maps/refined.h"
#include "relief/max_pyramid.h"

namespace relief {

namespace {

struct Direction {
    double a;
    double b;
    double length;  // in the map's metric, a unit of lambda
};

// Evenly over the half sphere below the horizontal of the metric, down from the flattest: a golden spiral.
std::vector<Direction> spread(int count, double slab, double maxRun) {
    const double sinFlattest = slab / std::hypot(slab, maxRun);
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<Direction> directions;
    for (int i = 0; i < count; ++i) {
        const double sine = sinFlattest + (1 - sinFlattest) * (i + 0.5) / count;
        const double run = slab * std::sqrt(1 - sine * sine) / sine;
        directions.push_back({run * std::cos(golden * i), run * std::sin(golden * i), slab / sine});
    }
    return directions;
}

}  // namespace

void refinedSampled(const DistanceMap& map, int nx, int ny, const HeightField& field, std::vector<float>& values,
                    Work& work) {
    // A hit this little before the voxel's own height is the voxel's own place on the surface.
    constexpr double kReached = 1e-9;
    MapCache own;
    const MaxPyramidTracer tracer(PyramidWalk(field, maxPyramidMap(field, own, work)));
    const std::vector<Direction> directions = spread(map.parameters.directions, map.slabTexels, map.maxRun);
    const int layers = map.layers();
    const auto voxel = [&](int x, int y, int k) {
        const double s = (x + 0.5) * field.width() / nx;
        const double t = (y + 0.5) * field.height() / ny;
        const double lambda = 1 - map.centreZ(k);
        if (field.at(s, t) >= 1 - lambda) return 0.0;
        double least = (1 - lambda + 1) * map.slabTexels;  // where no ray comes: more than any drop
        for (const Direction& d : directions) {
            NullSink sink;
            const Hit hit = tracer.trace({s - lambda * d.a, t - lambda * d.b, d.a, d.b}, sink);
            if (hit.outcome != Outcome::Hit || hit.lambda < lambda - kReached) continue;
            least = std::min(least, std::max(hit.lambda - lambda, 0.0) * d.length);
        }
        return least;
    };
    work.progress().begin("map refined-sampled", ny);
    parallelFor(work, ny, [&](int y) {
        for (int k = 0; k < layers; ++k) {
            float* out = values.data() +
                         (static_cast<std::size_t>(k) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) *
                             static_cast<std::size_t>(nx);
            for (int x = 0; x < nx; ++x) *out++ = static_cast<float>(voxel(x, y, k));
        }
        work.progress().advance();
    });
}

}  // namespace relief
