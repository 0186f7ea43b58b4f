#include "relief/maps/tile_prefetch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "images/tiled_heights.h"
#include "relief/maps/tiled_pyramid.h"

namespace relief {

namespace {

// Side, in texels, of the largest square whose tiles are read in advance.
constexpr double kMostTexels = 2048;

// The texels between the ends of rays on one axis, for one period of the map or two.
struct Reach {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void add(double from, double to) { low = std::min({low, from, to}), high = std::max({high, from, to}); }
    bool little() const { return high - low <= kMostTexels; }  // false also for NaN and infinity
    // Parts of the map, [first, second].
    std::vector<std::pair<int, int>> parts(int size, bool repeats) const {
        const double begin = repeats ? std::floor(low / size) * size : 0;
        const auto clamped = [&](double x) { return static_cast<int>(std::clamp(x, 0.0, size - 1.0)); };
        std::vector<std::pair<int, int>> all{{clamped(low - begin - 1), clamped(high - begin + 1)}};
        if (repeats && high - begin + 1 > size) all.emplace_back(0, clamped(high - begin + 1 - size));
        return all;
    }
};

}  // namespace

void prefetchAlong(const HeightField& field, const TiledPyramid* pyramid, const RayBlock& rays) {
    const TiledHeights& tiles = *field.tiles();
    const int top = tiles.levels() - 1;
    const double first = 1 - static_cast<double>(tiles.maximum(top, 0, 0));
    const double last = 1 - static_cast<double>(tiles.minimum(top, 0, 0));
    Reach across, down;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        across.add(rays.s0[i] + first * rays.a[i], rays.s0[i] + last * rays.a[i]);
        down.add(rays.t0[i] + first * rays.b[i], rays.t0[i] + last * rays.b[i]);
    }
    if (!across.little() || !down.little()) return;
    const bool repeats = field.address() == Address::Repeat;
    std::vector<TileRange> ranges;
    for (const auto& [left, right] : across.parts(field.width(), repeats)) {
        for (const auto& [up, bottom] : down.parts(field.height(), repeats)) {
            ranges.push_back({TileKind::Height, 0, left, up, right, bottom});
            for (int l = 1; pyramid != nullptr && l < pyramid->firstKept(); ++l) {
                ranges.push_back({TileKind::Max, l, left >> l, up >> l, right >> l, bottom >> l});
            }
        }
    }
    tiles.prefetch(ranges);
}

}  // namespace relief
