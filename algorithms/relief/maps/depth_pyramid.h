// The max pyramid in the form that DepthWalk and its SIMD version use: one array of the depths 1 - maximum in 16 bits,
// level by level.
//
// A depth is rounded down, and walks in float compute the lambda at which a ray leaves a node late by more than
// PyramidWalk's kExclusionMargin (kCrossingMargin, float_margins.h). So the condition "the ray leaves the node above
// this depth" excludes no node that PyramidWalk::excluded keeps.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "relief/maps/max_pyramid_map.h"

namespace relief {

inline constexpr int kDepthLevels = 16;  // for fields of up to 32768 cells per side
inline constexpr double kDepthUnit = 0x1p-16;

struct DepthPyramid {
    static constexpr RayClass kRays = RayClass::AnyRays;
    std::vector<std::uint16_t> depths;  // padded by two, since SIMD loads four bytes
    std::array<std::int32_t, kDepthLevels> offsets{};
    int top = 0;
    double highest = 0;

    std::size_t bytes() const { return depths.size() * sizeof(std::uint16_t); }
};

// Takes the pyramid from the cache, or builds it in parallel. Null if the field is too large for it; then the paper's
// walk in double is used.
std::shared_ptr<const DepthPyramid> depthPyramid(const HeightField& field,
                                                 const std::shared_ptr<const MaxPyramidMap>& map, MapCache& cache,
                                                 Work& work);

}  // namespace relief
