// The max pyramid in the form that DepthWalk and its SIMD version use: the depths 1 - maximum in 16 bits, level by
// level in one array; for a field that is read by tiles, those of its TiledPyramid.
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

// Levels and depths that SIMD gathers by offsets of 32 bits in bytes. Larger pyramids, and levels of tiles that are not
// kept in memory, are read lane by lane.
inline constexpr int kGatheredLevels = 16;
inline constexpr std::size_t kGatheredDepths = std::size_t{1} << 30;

struct DepthPyramid {
    static constexpr RayClass kRays = RayClass::AnyRays;
    std::vector<std::uint16_t> depths;  // padded by two, since SIMD loads four bytes
    std::array<std::size_t, kMaxLevels> starts{};
    // Of the levels that are gathered, in gatheredDepths().
    std::array<std::int32_t, kMaxLevels> offsets{};
    int firstGathered = kMaxLevels;  // the levels from this one up are gathered
    int cells = 0;                   // of a row
    int top = 0;
    double highest = 0;
    std::shared_ptr<const TiledPyramid> tiled{};  // in place of the array

    std::size_t bytes() const { return depths.size() * sizeof(std::uint16_t); }
    // Whether all levels are gathered, by a table of kGatheredLevels offsets.
    bool gathered() const { return firstGathered == 0 && top < kGatheredLevels; }
    const std::uint16_t* gatheredDepths() const { return tiled ? tiled->keptDepths() : depths.data(); }
    // Depth of a node in units of kDepthUnit.
    std::uint16_t depth(int level, int x, int y) const {
        if (tiled) return tiled->depth(level, x, y);
        const auto width = static_cast<std::size_t>(((cells - 1) >> level) + 1);
        return depths[starts[static_cast<std::size_t>(level)] + static_cast<std::size_t>(y) * width +
                      static_cast<std::size_t>(x)];
    }
};

// Takes the pyramid from the cache, or builds it in parallel.
std::shared_ptr<const DepthPyramid> depthPyramid(const HeightField& field,
                                                 const std::shared_ptr<const MaxPyramidMap>& map, MapCache& cache,
                                                 Work& work);

}  // namespace relief
