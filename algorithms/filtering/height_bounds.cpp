#include "filtering/height_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "images/tiled_heights.h"

#include "relief/maps/map_memory.h"

namespace relief {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Longest side, in texels, of maps that are bounded per texel. Larger maps are bounded over blocks.
constexpr int kFinestSide = 4096;
// The same for maps that are read by tiles. They get no bounds of the surface per texel, which take a multiple of the
// map's memory.
constexpr int kFinestTiledSide = 1024;

// Texels from `first` to `last` along an axis after addressing: one interval, or two if they cross the seam.
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
    // A bilinear surface is determined by texels up to half a texel beyond the interval on either side.
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

// Valid for any addressing: the slopes of the last column include those at the rim and at the seam.
SurfaceBounds texelBounds(const FloatImage& heights, int i, int j) {
    const float h = heights(i, j);
    SurfaceBounds out{h, h, 0, 0, 0, 0};
    const float ds = heights((i + 1) % heights.width(), j) - h;
    const float dt = heights(i, (j + 1) % heights.height()) - h;
    out.lowS = out.highS = ds, out.lowT = out.highT = dt;
    if (i + 1 == heights.width()) out.lowS = std::min(ds, 0.0F), out.highS = std::max(ds, 0.0F);
    if (j + 1 == heights.height()) out.lowT = std::min(dt, 0.0F), out.highT = std::max(dt, 0.0F);
    return out;
}

std::vector<Image<SurfaceBounds>> surfacePyramid(const FloatImage& heights, Work& work) {
    std::vector<Image<SurfaceBounds>> levels;
    levels.emplace_back(heights.width(), heights.height());
    for (int l = 0;; ++l) {
        Image<SurfaceBounds>& to = levels.back();
        const Image<SurfaceBounds>* from = l > 0 ? &levels[static_cast<std::size_t>(l) - 1] : nullptr;
        const auto row = [&](int y) {
            for (int x = 0; x < to.width(); ++x) {
                if (from == nullptr) {
                    to(x, y) = texelBounds(heights, x, y);
                    continue;
                }
                for (int n = 0; n < 4; ++n) {
                    const int i = 2 * x + n % 2, j = 2 * y + n / 2;
                    if (i < from->width() && j < from->height()) to(x, y).join((*from)(i, j));
                }
            }
        };
        parallelFor(work, to.height(), row, 16);
        if (to.width() == 1 && to.height() == 1) return levels;
        const int width = (to.width() + 1) / 2, height = (to.height() + 1) / 2;
        levels.emplace_back(width, height);
    }
}

// Calls visit(level, x, y) for nodes that cover the rectangle, three or four along its longer side. A texel of level 0
// covers 2^shift texels.
template <class Visit>
void overNodes(const Stretches& across, const Stretches& down, int shift, int levels, const Visit& visit) {
    int level = 0;
    while ((std::max(across.widest, down.widest) >> (shift + level)) > 3 && level + 1 < levels) ++level;
    const int by = shift + level;
    for (int q = 0; q < down.count; ++q) {
        const auto [top, bottom] = down.part[static_cast<std::size_t>(q)];
        for (int y = top >> by; y <= bottom >> by; ++y) {
            for (int p = 0; p < across.count; ++p) {
                const auto [left, right] = across.part[static_cast<std::size_t>(p)];
                for (int x = left >> by; x <= right >> by; ++x) visit(level, x, y);
            }
        }
    }
}

HeightBoundsMap blockBounds(FloatImage low, FloatImage high, int shift, Work& work) {
    float smallestRange = kInfinity;
    for (std::size_t i = 0; i < low.size(); ++i)
        smallestRange = std::min(smallestRange, high.pixels()[i] - low.pixels()[i]);
    return {Pyramid(PyramidKind::Min, std::move(low), work),
            Pyramid(PyramidKind::Max, std::move(high), work),
            shift,
            {},
            smallestRange};
}

HeightBoundsMap tiledBounds(const TiledHeights& tiles, int shift, Work& work) {
    FloatImage low(tiles.width(shift), tiles.height(shift)), high = low;
    parallelFor(work, low.height(), [&](int y) {
        for (int x = 0; x < low.width(); ++x)
            low(x, y) = tiles.minimum(shift, x, y), high(x, y) = tiles.maximum(shift, x, y);
    });
    return blockBounds(std::move(low), std::move(high), shift, work);
}

}  // namespace

void SurfaceBounds::join(const SurfaceBounds& other) {
    low = std::min(low, other.low), high = std::max(high, other.high);
    lowS = std::min(lowS, other.lowS), highS = std::max(highS, other.highS);
    lowT = std::min(lowT, other.lowT), highT = std::max(highT, other.highT);
}

std::size_t HeightBoundsMap::bytes() const {
    std::size_t total = lowest.bytes() + highest.bytes();
    for (const auto& level : surface) total += level.bytes();
    return total;
}

std::shared_ptr<const HeightBoundsMap> heightBoundsMap(const HeightField& field, MapCache& cache, Work& work) {
    // Large maps are bounded by blocks: this saves memory, and single texels there hardly affect what can be skipped.
    const bool tiled = field.tiles() != nullptr;
    int shift = 0;
    while ((std::max(field.width(), field.height()) >> shift) > (tiled ? kFinestTiledSide : kFinestSide)) ++shift;
    // Bytes per texel: the levels of lowest and highest, and of the surface's bounds.
    constexpr std::uint64_t kBytes = 4 * (2 * sizeof(float) + sizeof(SurfaceBounds)) / 3 + 1;
    const std::uint64_t need = tiled ? 0 : bytesForTexels(field, shift == 0 ? kBytes : sizeof(float));
    const std::string kind = (tiled ? kTiledKind : "") + "height-bounds";
    return cache.get<HeightBoundsMap>({kind, field.identity()}, need, work, [&](Work& w) {
        HeightBoundsMap map = coarseHeightBounds(field, shift, w);
        if (shift == 0 && !tiled) map.surface = surfacePyramid(field.heights(), w);
        return map;
    });
}

HeightBoundsMap coarseHeightBounds(const HeightField& field, int shift, Work& work) {
    if (field.tiles() != nullptr) return tiledBounds(*field.tiles(), shift, work);
    const std::shared_ptr<const FloatImage>& heights = field.sharedHeights();
    if (shift == 0) return {Pyramid(PyramidKind::Min, heights, work), Pyramid(PyramidKind::Max, heights, work)};
    const int side = 1 << shift;
    FloatImage low((heights->width() + side - 1) >> shift, (heights->height() + side - 1) >> shift, kInfinity);
    FloatImage high(low.width(), low.height(), -kInfinity);
    parallelFor(work, low.height(), [&](int block) {
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
    return blockBounds(std::move(low), std::move(high), shift, work);
}

HeightBounds heightBounds(const HeightBoundsMap& map, const HeightField& field, double s0, double t0, double s1,
                          double t1) {
    const Stretches across = stretches(s0, s1, field.width(), field.address());
    const Stretches down = stretches(t0, t1, field.height(), field.address());
    HeightBounds range{1, 0};
    overNodes(across, down, map.shift, map.highest.levels(), [&](int level, int x, int y) {
        range.low = std::min<double>(range.low, map.lowest.level(level)(x, y));
        range.high = std::max<double>(range.high, map.highest.level(level)(x, y));
    });
    return range;
}

SurfaceBounds surfaceBounds(const HeightBoundsMap& map, const HeightField& field, double s0, double t0, double s1,
                            double t1) {
    const Stretches across = stretches(s0, s1, field.width(), field.address());
    const Stretches down = stretches(t0, t1, field.height(), field.address());
    SurfaceBounds out;
    overNodes(across, down, 0, static_cast<int>(map.surface.size()),
              [&](int level, int x, int y) { out.join(map.surface[static_cast<std::size_t>(level)](x, y)); });
    if (field.address() != Address::Repeat) {
        out.lowS = std::min(out.lowS, 0.0F), out.highS = std::max(out.highS, 0.0F);
        out.lowT = std::min(out.lowT, 0.0F), out.highT = std::max(out.highT, 0.0F);
    }
    return out;
}

}  // namespace relief
