// The max pyramid as DepthWalk and its SIMD version read it: one array of depths 1 - maximum in 16 bits, level after
// level.
//
// A depth is rounded down, and walks in float compute the lambda at which a ray leaves a node late by more than
// PyramidWalk's kExclusionMargin (kCrossingMargin, float_margins.h). So "the ray leaves the node above this depth"
// excludes no node that PyramidWalk::excluded keeps.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relief/maps/max_pyramid_map.h"

namespace relief {

inline constexpr int kDepthLevels = 16;  // fields of up to 32768 cells a side
inline constexpr double kDepthUnit = 0x1p-16;

struct DepthPyramid {
    static constexpr RayClass kRays = RayClass::AnyRays;
    std::vector<std::uint16_t> depths;  // two more than there are: lanes read four bytes
    std::array<std::int32_t, kDepthLevels> offsets{};
    int top = 0;
    double highest = 0;

    std::size_t bytes() const { return depths.size() * sizeof(std::uint16_t); }
};

// From the cache, or built in parallel. Null: the field is too large for it (the paper's walk in double runs).
std::shared_ptr<const DepthPyramid> depthPyramid(const HeightField& field,
                                                 const std::shared_ptr<const MaxPyramidMap>& map, MapCache& cache,
                                                 Work& work);

}  // namespace relief
