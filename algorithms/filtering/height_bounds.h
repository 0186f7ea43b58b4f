// Bounds of heights and slopes over a rectangle of the height map, by which visibility tests are skipped where nothing
// can hide.
#pragma once

#include <memory>
#include <vector>

#include "images/pyramid.h"
#include "relief/height_field.h"
#include "relief/map_cache.h"

namespace relief {

// Bounds over a region of the surface: heights, and slopes along s and t in heights per texel. The default is the empty
// region.
struct SurfaceBounds {
    float low = 1, high = 0;
    float lowS = 1, highS = -1, lowT = 1, highT = -1;  // slopes lie in [-1, 1]

    void join(const SurfaceBounds& other);
};

struct HeightBoundsMap {
    Pyramid lowest;
    Pyramid highest;
    int shift = 0;  // a texel of level 0 covers 2^shift texels along each side
    // Level l: bounds over 2^l x 2^l texels and the cells to their right and below. Empty for large maps.
    std::vector<Image<SurfaceBounds>> surface{};
    float smallestRange = 0;  // smallest height difference within any texel of level 0
    std::size_t bytes() const;
};

struct HeightBounds {
    double low = 0;
    double high = 0;
};

// From the cache, or built in parallel. The bounds are over texels, so they are valid for any surface and addressing.
// Throws MemoryError, Cancelled.
std::shared_ptr<const HeightBoundsMap> heightBoundsMap(const HeightField& field, MapCache& cache, Work& work);
// Bounds over blocks of 2^shift texels, shift >= 0; for a field that is read by tiles, below the number
// of the file's levels.
HeightBoundsMap coarseHeightBounds(const HeightField& field, int shift, Work& work);

// Bounds of all heights of the surface over [s0, s1] x [t0, t1] (texels, unwrapped, any finite values), for bilinear
// surfaces and for columns. The bounds may be wider than necessary. Reads a few tens of values at most.
HeightBounds heightBounds(const HeightBoundsMap& map, const HeightField& field, double s0, double t0, double s1,
                          double t1);

// Bounds of heights and slopes of a bilinear surface. Under clamp and border the ground beyond the rim is level.
SurfaceBounds surfaceBounds(const HeightBoundsMap& map, const HeightField& field, double s0, double t0, double s1,
                            double t1);

}  // namespace relief
