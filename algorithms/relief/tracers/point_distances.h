// The Euclidean and the refined distance at one point of the slab, with what decided them. [DIST17], figs. 5 to 8.
#pragma once

#include "relief/height_field.h"
#include "relief/map_cache.h"
#include "relief/ray.h"
#include "relief/work.h"

namespace relief {

// The Euclidean and the refined distance of [DIST17], figs. 5 to 8, at one point of the slab. The refined one is
// computed with kPointDirections rays and the vertical one.
struct PointDistances {
    double euclidean = 0;  // in texels, to the point (s, t, z) of the surface
    double s = 0, t = 0, z = 0;
    // in texels along `ray`, from the point to the ray's first hit; if no ray arrives, the value that maps store then
    double refined = 0;
    bool reached = false;  // true if any ray from above reaches the point
    ViewRay ray;
    Hit hit;
    int rays = 0;
    int blocked = 0;  // rays that hit the surface before the point
    // The blocked ray that is closest to the direction of (s, t, z), and its hit; only if `blocked` > 0.
    ViewRay blockedRay;
    Hit blockedHit;
};
inline constexpr int kPointDirections = 16384;
// Computes both distances at (s, t, z), a point in the slab over the picture; at or below the surface both are 0.
// flattest: degrees from the plane below which rays are not considered. Throws Cancelled.
PointDistances distancesAt(const HeightField& field, double s, double t, double z, double flattest, MapCache& cache,
                           Work& work);

}  // namespace relief
