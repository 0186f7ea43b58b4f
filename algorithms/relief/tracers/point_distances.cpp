#include "relief/tracers/point_distances.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "relief/maps/refined.h"
#include "relief/maps/surface_distance.h"
#include "relief/tracers.h"

namespace relief {

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
    for (const SampledDirection& direction : directions) {
        rays.push({s - lambda * direction.a, t - lambda * direction.b, direction.a, direction.b});
    }
    HitBlock hits;
    NullSink sink;
    makeTracer({"max-pyramid", {}}, field, cache, work)->trace(rays, hits, sink, work);
    out.rays = static_cast<int>(rays.size());
    out.refined = (z + 1) * slab;
    // Component of a ray's direction towards the nearest point, in texels.
    const auto towardsNearest = [&](const SampledDirection& direction) {
        return (direction.a * (out.s - s) + direction.b * (out.t - t) + slab * slab * (z - out.z)) / direction.length;
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
