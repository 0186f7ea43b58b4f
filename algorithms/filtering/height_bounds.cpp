#include "filtering/height_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <oneapi/tbb/parallel_for.h>

namespace relief {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Larger maps are bounded over blocks of texels.
constexpr int kFinestSide = 4096;

// Texels from `first` to `last` of an axis, addressed: one stretch, or two where they cross the seam.
struct Stretches {
    std::array<std::pair<int, int>, 2> part{};
    int count = 0;
    int widest = 1;

    void add(std::int64_t first, std::int64_t last) {
        part[static_cast<std::size_t>(count++)] = {static_cast<int>(first), static_cast<int>(last)};
        widest = std::max(widest, static_cast<int>(last - first + 1));
    }
};

Stretches stretches(double low, double high, int size, Address address) {
    // The texels whose centres bound the interval: half a texel on either side belongs to a bilinear surface.
    const double begin = std::floor(low - 0.5);
    const double end = std::floor(high - 0.5) + 1;
    Stretches out;
    if (address != Address::Repeat) {
        const double last = size - 1;
        out.add(static_cast<std::int64_t>(std::clamp(begin, 0.0, last)),
                static_cast<std::int64_t>(std::clamp(end, 0.0, last)));
        return out;
    }
    if (!(end - begin + 1 < size)) {
        out.add(0, size - 1);
        return out;
    }
    const double start = begin - std::floor(begin / size) * size;
    const auto first = static_cast<std::int64_t>(std::clamp(start, 0.0, size - 1.0));
    const std::int64_t last = first + static_cast<std::int64_t>(end - begin);
    if (last < size) {
        out.add(first, last);
    } else {
        out.add(first, size - 1);
        out.add(0, last - size);
    }
    return out;
}

}  // namespace

std::shared_ptr<const HeightBoundsMap> heightBoundsMap(const HeightField& field, MapCache& cache, Work& work) {
    return cache.get<HeightBoundsMap>({"height-bounds", field.sharedHeights()}, work, [&](Work& w) {
        // Large maps by blocks: what is skipped does not hang on single texels there, but memory does.
        int shift = 0;
        while ((std::max(field.width(), field.height()) >> shift) > kFinestSide) ++shift;
        return coarseHeightBounds(field.sharedHeights(), shift, w);
    });
}

HeightBoundsMap coarseHeightBounds(const std::shared_ptr<const FloatImage>& heights, int shift, Work& work) {
    if (shift == 0) return {Pyramid(PyramidKind::Min, heights, work), Pyramid(PyramidKind::Max, heights, work)};
    const int side = 1 << shift;
    FloatImage low((heights->width() + side - 1) >> shift, (heights->height() + side - 1) >> shift, kInfinity);
    FloatImage high(low.width(), low.height(), -kInfinity);
    work.arena().execute([&] {
        tbb::parallel_for(0, low.height(), [&](int block) {
            if (work.stopped()) return;
            const auto lows = low.row(block);
            const auto highs = high.row(block);
            for (int y = block << shift; y < std::min((block + 1) << shift, heights->height()); ++y) {
                const auto row = heights->row(y);
                for (std::size_t x = 0; x < row.size(); ++x) {
                    lows[x >> shift] = std::min(lows[x >> shift], row[x]);
                    highs[x >> shift] = std::max(highs[x >> shift], row[x]);
                }
            }
        });
    });
    work.throwIfStopped();
    return {Pyramid(PyramidKind::Min, std::move(low), work), Pyramid(PyramidKind::Max, std::move(high), work), shift};
}

HeightBounds heightBounds(const HeightBoundsMap& map, const HeightField& field, double s0, double t0, double s1,
                          double t1) {
    const Stretches across = stretches(s0, s1, field.width(), field.address());
    const Stretches down = stretches(t0, t1, field.height(), field.address());
    // Three or four nodes along the longer side.
    int level = 0;
    while ((std::max(across.widest, down.widest) >> (map.shift + level)) > 3 && level + 1 < map.highest.levels())
        ++level;
    HeightBounds range{1, 0};
    const FloatImage& lowest = map.lowest.level(level);
    const FloatImage& highest = map.highest.level(level);
    const int shift = map.shift + level;
    for (int q = 0; q < down.count; ++q) {
        const auto [top, bottom] = down.part[static_cast<std::size_t>(q)];
        for (int y = top >> shift; y <= bottom >> shift; ++y) {
            for (int p = 0; p < across.count; ++p) {
                const auto [left, right] = across.part[static_cast<std::size_t>(p)];
                for (int x = left >> shift; x <= right >> shift; ++x) {
                    range.low = std::min<double>(range.low, lowest(x, y));
                    range.high = std::max<double>(range.high, highest(x, y));
                }
            }
        }
    }
    return range;
}

}  // namespace relief
