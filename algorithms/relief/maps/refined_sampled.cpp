#include <cmath>
#include <limits>
#include <numbers>

#include "base/parallel.h"
#include "base/scratch_pool.h"
#include "relief/maps/refined.h"
#include "relief/maps/surface_distance.h"
#include "relief/max_pyramid.h"
#include "relief/tracers.h"

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

namespace {

// A hit this little before the point's own height is the point's own place on the surface.
constexpr double kReached = 1e-9;

}  // namespace

void refinedSampled(const DistanceMap& map, int nx, int ny, const HeightField& field, std::vector<float>& values,
                    Work& work) {
    MapCache own;
    const MaxPyramidTracer tracer = MaxPyramidTracer::make(field, {}, own, work);
    const std::vector<SampledDirection> directions =
        sampledDirections(map.parameters.directions, map.slabTexels, map.maxRun);
    const std::size_t count = directions.size();
    struct Scratch {
        RayBlock rays;
        HitBlock hits;
    };
    ScratchPool<Scratch> pool;
    // A row of voxels of layer k.
    const auto row = [&](int y, int k, Scratch& scratch, float* out) {
        const double lambda = 1 - map.centreZ(k);
        const double t = (y + 0.5) * field.height() / ny;
        scratch.rays.resize(static_cast<std::size_t>(nx) * count);
        scratch.hits.resize(scratch.rays.size());
        for (int x = 0; x < nx; ++x) {
            const double s = (x + 0.5) * field.width() / nx;
            for (std::size_t d = 0; d < count; ++d) {
                const SampledDirection& way = directions[d];
                scratch.rays.set(static_cast<std::size_t>(x) * count + d,
                                 {s - lambda * way.a, t - lambda * way.b, way.a, way.b});
            }
        }
        tracer.traceLanes(scratch.rays, 0, scratch.rays.size(), scratch.hits);
        for (int x = 0; x < nx; ++x) {
            const bool solid = field.at((x + 0.5) * field.width() / nx, t) >= 1 - lambda;
            double least = solid ? 0 : (1 - lambda + 1) * map.slabTexels;  // where no ray comes: more than any drop
            for (std::size_t d = 0; !solid && d < count; ++d) {
                const Hit hit = scratch.hits[static_cast<std::size_t>(x) * count + d];
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
            row(y, k, *scratch, values.data() + first * static_cast<std::size_t>(nx));
        }
        work.progress().advance();
    });
}

PointDistances distancesAt(const HeightField& field, double s, double t, double z, double flattest, MapCache& cache,
                           Work& work) {
    const double slab = field.slabTexels();
    PointDistances out;
    const SurfaceDistance surface(field, maxPyramidMap(field, cache, work));
    const auto nearest = surface.nearest(s, t, z, std::numeric_limits<double>::infinity());
    out.euclidean = nearest.distance;
    out.s = nearest.s, out.t = nearest.t, out.z = nearest.z;
    if (field.at(s, t) >= z) return out;
    const double lambda = 1 - z;
    std::vector<SampledDirection> directions =
        sampledDirections(kPointDirections, slab, slab / std::tan(flattest * std::numbers::pi / 180));
    directions.push_back({0, 0, slab});
    RayBlock rays;
    for (const SampledDirection& way : directions) {
        rays.push({s - lambda * way.a, t - lambda * way.b, way.a, way.b});
    }
    HitBlock hits;
    NullSink sink;
    makeTracer({"max-pyramid", {}}, field, cache, work)->trace(rays, hits, sink, work);
    out.rays = static_cast<int>(rays.size());
    out.refined = (z + 1) * slab;
    // Texels along the direction towards the nearest point.
    const auto towardsNearest = [&](const SampledDirection& way) {
        return (way.a * (out.s - s) + way.b * (out.t - t) + slab * slab * (z - out.z)) / way.length;
    };
    double closest = -std::numeric_limits<double>::infinity();
    for (std::size_t d = 0; d < directions.size(); ++d) {
        const Hit hit = hits[d];
        if (hit.outcome != Outcome::Hit) continue;
        if (hit.lambda < lambda - kReached) {
            ++out.blocked;
            if (const double along = towardsNearest(directions[d]); along > closest) {
                closest = along;
                out.blockedRay = rays[d];
                out.blockedHit = hit;
            }
            continue;
        }
        const double distance = std::max(hit.lambda - lambda, 0.0) * directions[d].length;
        if (out.reached && distance >= out.refined) continue;
        out.reached = true;
        out.refined = distance;
        out.ray = rays[d];
        out.hit = hit;
    }
    return out;
}

}  // namespace relief
