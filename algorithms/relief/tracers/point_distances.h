// The Euclidean and the refined distance at one point of the slab, with what decided them. [DIST17], figs. 5 to 8.
#pragma once

#include "relief/height_field.h"
#include "relief/map_cache.h"
#include "relief/ray.h"
#include "relief/work.h"

namespace relief {

// Which distance holds at one point of the slab: the Euclidean one, and the refined one of [DIST17], figs. 5 to 8, by
// kPointDirections rays and the vertical one.
struct PointDistances {
    double euclidean = 0;  // texels, to (s, t, z) of the surface
    double s = 0, t = 0, z = 0;
    double refined = 0;    // along `ray`, from the point to its first hit; as in maps where no ray arrives
    bool reached = false;  // by any ray from above
    ViewRay ray;
    Hit hit;
    int rays = 0;
    int blocked = 0;  // that hit something before the point
    // Of those the one that runs closest to the direction of (s, t, z), and where it hits; only if `blocked`.
    ViewRay blockedRay;
    Hit blockedHit;
};
inline constexpr int kPointDirections = 16384;
// flattest: degrees below which rays are not served. The point lies in the slab, over the picture; at or below the
// surface both distances are 0. Throws Cancelled.
PointDistances distancesAt(const HeightField& field, double s, double t, double z, double flattest, MapCache& cache,
                           Work& work);

}  // namespace relief
