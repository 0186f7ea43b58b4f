#include "filtering/height_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace relief {

namespace {

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
        return HeightBoundsMap{Pyramid(PyramidKind::Min, field.heights(), w),
                               Pyramid(PyramidKind::Max, field.heights(), w)};
    });
}

HeightBounds heightBounds(const HeightBoundsMap& map, const HeightField& field, double s0, double t0, double s1,
                          double t1) {
    const Stretches across = stretches(s0, s1, field.width(), field.address());
    const Stretches down = stretches(t0, t1, field.height(), field.address());
    // Three or four nodes along the longer side.
    int level = 0;
    while ((std::max(across.widest, down.widest) >> level) > 3 && level + 1 < map.highest.levels()) ++level;
    HeightBounds range{1, 0};
    const FloatImage& lowest = map.lowest.level(level);
    const FloatImage& highest = map.highest.level(level);
    for (int q = 0; q < down.count; ++q) {
        const auto [top, bottom] = down.part[static_cast<std::size_t>(q)];
        for (int y = top >> level; y <= bottom >> level; ++y) {
            for (int p = 0; p < across.count; ++p) {
                const auto [left, right] = across.part[static_cast<std::size_t>(p)];
                for (int x = left >> level; x <= right >> level; ++x) {
                    range.low = std::min<double>(range.low, lowest(x, y));
                    range.high = std::max<double>(range.high, highest(x, y));
                }
            }
        }
    }
    return range;
}

}  // namespace relief
