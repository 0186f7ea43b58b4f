// The least and the greatest height over a rectangle of the map: for skipping what nothing can hide.
#pragma once

#include <memory>
#include <vector>

#include "images/pyramid.h"
#include "relief/height_field.h"
#include "relief/map_cache.h"

namespace relief {

// Of a stretch of the surface: heights, and slopes along s and t, heights a texel.
struct SurfaceBounds {
    float low = 1, high = 0;
    float lowS = 1, highS = -1, lowT = 1, highT = -1;  // slopes lie in [-1, 1]

    void join(const SurfaceBounds& other);
};

struct HeightBoundsMap {
    Pyramid lowest;
    Pyramid highest;
    int shift = 0;  // a texel of level 0 stands for 2^shift texels along each side
    // Level l: of 2^l x 2^l texels and the cells to their right and below. Empty for large maps.
    std::vector<Image<SurfaceBounds>> surface{};
    float evenest = 0;  // the least difference of heights within a texel of level 0
    std::size_t bytes() const;
};

struct HeightBounds {
    double low = 0;
    double high = 0;
};

// From the cache, or built in parallel. Of texels, whatever the surface and the addressing.
std::shared_ptr<const HeightBoundsMap> heightBoundsMap(const HeightField& field, MapCache& cache, Work& work);
// Over blocks of 2^shift texels, shift >= 0.
HeightBoundsMap coarseHeightBounds(const std::shared_ptr<const FloatImage>& heights, int shift, Work& work);

// Bounds of all heights of the surface over [s0, s1] x [t0, t1] (texels, unwrapped, any finite), for bilinear surfaces
// and for columns; exact or wider. At most a few tens of values are read.
HeightBounds heightBounds(const HeightBoundsMap& map, const HeightField& field, double s0, double t0, double s1,
                          double t1);

// The same with slopes, of bilinear surfaces; what lies beyond the rim under clamp and border is level.
SurfaceBounds surfaceBounds(const HeightBoundsMap& map, const HeightField& field, double s0, double t0, double s1,
                            double t1);

}  // namespace relief
