#include "relief/maps/depth_pyramid.h"

#include "base/parallel.h"

#include "relief/maps/map_memory.h"

namespace relief {

namespace {

// start: of a level, in the array of `count` depths.
template <class Start>
void setGathered(DepthPyramid& depths, int first, std::size_t count, const Start& start) {
    if (count >= kGatheredDepths) return;
    depths.firstGathered = first;
    for (int l = first; l <= depths.top; ++l) {
        depths.offsets[static_cast<std::size_t>(l)] = static_cast<std::int32_t>(start(l));
    }
}

DepthPyramid buildDepths(const MaxPyramidMap& map, Work& work) {
    DepthPyramid depths;
    depths.top = map.top();
    depths.highest = static_cast<double>(map.highest());
    if (map.tiled) {
        depths.tiled = map.tiled;
        setGathered(depths, map.tiled->firstKept(), map.tiled->keptCount(),
                    [&](int level) { return map.tiled->start(level); });
        return depths;
    }
    depths.cells = map.pyramid.level(0).width();
    std::size_t count = 0;
    for (int l = 0; l <= map.top(); ++l) {
        depths.starts[static_cast<std::size_t>(l)] = count;
        count += map.pyramid.level(l).size();
    }
    setGathered(depths, 0, count, [&](int level) { return depths.starts[static_cast<std::size_t>(level)]; });
    depths.depths.resize(count + 2);
    for (int l = 0; l <= map.top(); ++l) {
        const FloatImage& level = map.pyramid.level(l);
        std::uint16_t* const to = depths.depths.data() + depths.starts[static_cast<std::size_t>(l)];
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
    std::string kind = "depth-pyramid/columns";
    if (field.surface() == Surface::Bilinear) {
        kind = field.address() == Address::Repeat ? "depth-pyramid/bilinear/repeat" : "depth-pyramid/bilinear/clamped";
    }
    if (map->tiled) kind = kTiledKind + kind;
    constexpr std::uint64_t kBytes = 3;  // per texel: 16 bits on all levels
    return cache.get<DepthPyramid>({kind, field.identity()}, map->tiled ? 0 : bytesForTexels(field, kBytes), work,
                                   [&](Work& w) { return buildDepths(*map, w); });
}

}  // namespace relief
