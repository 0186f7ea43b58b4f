#include "relief/maps/depth_pyramid.h"

#include <cmath>

#include "base/parallel.h"

#include "relief/maps/map_memory.h"

namespace relief {

namespace {

std::uint16_t depthOf(float maximum) {
    const double depth = (1 - static_cast<double>(maximum)) / kDepthUnit;
    return static_cast<std::uint16_t>(std::clamp(std::floor(depth), 0.0, 65535.0));
}

DepthPyramid buildDepths(const MaxPyramidMap& map, Work& work) {
    DepthPyramid depths;
    depths.top = map.top();
    depths.highest = static_cast<double>(map.highest());
    std::size_t count = 0;
    for (int l = 0; l <= map.top(); ++l) {
        depths.offsets[static_cast<std::size_t>(l)] = static_cast<std::int32_t>(count);
        count += map.pyramid.level(l).size();
    }
    depths.depths.resize(count + 2);
    for (int l = 0; l <= map.top(); ++l) {
        const FloatImage& level = map.pyramid.level(l);
        std::uint16_t* const to = depths.depths.data() + depths.offsets[static_cast<std::size_t>(l)];
        parallelFor(work, level.height(), [&](int y) {
            const auto row = level.row(y);
            std::uint16_t* const out = to + static_cast<std::size_t>(y) * row.size();
            for (std::size_t x = 0; x < row.size(); ++x) out[x] = depthOf(row[x]);
        });
    }
    return depths;
}

}  // namespace

std::shared_ptr<const DepthPyramid> depthPyramid(const HeightField& field,
                                                 const std::shared_ptr<const MaxPyramidMap>& map, MapCache& cache,
                                                 Work& work) {
    const bool fits = map->top() < kDepthLevels && map->bytes() / sizeof(float) < (std::size_t{1} << 30);
    if (!fits) return nullptr;
    std::string kind = "depth-pyramid/columns";
    if (field.surface() == Surface::Bilinear) {
        kind = field.address() == Address::Repeat ? "depth-pyramid/bilinear/repeat" : "depth-pyramid/bilinear/clamped";
    }
    constexpr std::uint64_t kBytes = 3;  // per texel: 16 bits on all levels
    return cache.get<DepthPyramid>({kind, field.sharedHeights()}, bytesForTexels(field, kBytes), work,
                                   [&](Work& w) { return buildDepths(*map, w); });
}

}  // namespace relief
