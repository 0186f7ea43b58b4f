#include "relief/maps/packed_cones.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "base/scratch_pool.h"
#include "relief/maps/map_memory.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/maps/packed_cone_lanes.h"

namespace relief {

namespace {

constexpr int kTileWidth = 256;  // so that the buffers of a tile fit L2
constexpr int kTileHeight = 64;
constexpr int kReach = 16;       // cells, or blocks of a level, by which windows extend beyond a tile
constexpr int kNearRings = 15;   // gaps of 1 to 15 cells, in single steps
constexpr int kFirstBlocks = 8;  // then gaps of 8 to 15 blocks on each level
constexpr float kEmpty = -1;     // below every height
using DepthImage = Image<std::uint16_t>;

std::size_t toSize(int at) {
    return static_cast<std::size_t>(at);
}
// Padded length of a row of windows.
std::size_t strideOf(int width) {
    return toSize((width + kReach + 2 * kConePad - 1) / kConePad * kConePad);
}

// One axis in the direction of a quadrant: index n is cell n, or the n-th cell from the end.
struct QuadrantAxis {
    int cells = 0;
    bool wraps = false;
    bool mirrored = false;

    // -1: outside, no cell.
    int cellAt(int n) const {
        if (n >= cells) {
            if (!wraps) return -1;
            n %= cells;
        }
        return mirrored ? cells - 1 - n : n;
    }
};

// The maxima of blocks of 2^level cells, including kReach blocks beyond the last. Where the seam between periods cuts a
// block, a maximum may include cells slightly farther.
struct Blocks {
    int width = 0;
    int height = 0;
    std::vector<float> values;

    const float* row(int j) const { return values.data() + toSize(j) * toSize(width); }
    float* row(int j) { return values.data() + toSize(j) * toSize(width); }
};

class QuadrantCones {
  public:
    QuadrantCones(const FloatImage& cells, const DepthImage& depths, const PackedCones& map, bool wraps, int quadrant)
        : cells_(cells),
          depths_(depths),
          map_(map),
          x_{map.nx, wraps, (quadrant & 1) != 0},
          y_{map.ny, wraps, (quadrant & 2) != 0} {}

    void build(std::uint32_t* entries, Work& work);

  private:
    struct Scratch {
        std::vector<float> windows;
        std::vector<std::uint32_t> depths;
        std::vector<float> apex, slope;
        std::vector<std::uint32_t> own;
        std::array<std::vector<float>, kConeRings> planes;
        std::vector<std::uint32_t> entries = std::vector<std::uint32_t>(kTileWidth + kConePad);
    };

    void addLevel(Work& work);
    static std::vector<std::array<int, 3>> below(const QuadrantAxis& axis, int level, int belowCount, int count);
    void buildTile(int x0, int y0, Scratch& scratch, std::uint32_t* entries) const;
    void loadCells(int x0, int y0, const ConeTile& tile, Scratch& scratch) const;
    bool steepenByLevel(int level, int x0, int y0, const ConeTile& tile, Scratch& scratch) const;
    int blocksAcross(const QuadrantAxis& axis, int level) const { return ((axis.cells - 1) >> level) + 1; }

    const FloatImage& cells_;
    const DepthImage& depths_;
    const PackedCones& map_;
    QuadrantAxis x_;
    QuadrantAxis y_;
    std::vector<Blocks> levels_;  // level l at index l - 1
};

// For blocks 0 to count - 1, the blocks one level below (level 1: the cells) that they contain; -1: none.
std::vector<std::array<int, 3>> QuadrantCones::below(const QuadrantAxis& axis, int level, int belowCount, int count) {
    std::vector<std::array<int, 3>> all(toSize(count));
    for (int n = 0; n < count; ++n) {
        auto& from = all[toSize(n)];
        if (level == 1) {
            from = {axis.cellAt(2 * n), axis.cellAt(2 * n + 1), -1};
        } else if (2 * n + 1 < belowCount) {
            from = {2 * n, 2 * n + 1, -1};
        } else if (!axis.wraps) {
            from = {2 * n < belowCount ? 2 * n : -1, -1, -1};
        } else {
            // Reduced to the first period, where the seam may lie within a block.
            const auto start = static_cast<int>((static_cast<std::int64_t>(n) << level) % axis.cells);
            const int first = start >> (level - 1);
            const int last = (start + (1 << level) - 1) >> (level - 1);
            from = {first, first + 1, last};
        }
    }
    return all;
}

void QuadrantCones::addLevel(Work& work) {
    const int level = static_cast<int>(levels_.size()) + 1;
    Blocks blocks{blocksAcross(x_, level) + kReach, blocksAcross(y_, level) + kReach, {}};
    const Blocks* finer = levels_.empty() ? nullptr : &levels_.back();
    const auto columns = below(x_, level, finer ? finer->width : 0, blocks.width);
    const auto rows = below(y_, level, finer ? finer->height : 0, blocks.height);
    blocks.values.assign(toSize(blocks.width) * toSize(blocks.height), kEmpty);
    const auto fillRow = [&](int j) {
        float* to = blocks.row(j);
        for (const int row : rows[toSize(j)]) {
            if (row < 0) continue;
            const float* from = finer ? finer->row(row) : cells_.row(row).data();
            for (std::size_t i = 0; i < columns.size(); ++i) {
                const auto& [a, b, c] = columns[i];
                if (a >= 0) to[i] = std::max(to[i], from[a]);
                if (b >= 0) to[i] = std::max(to[i], from[b]);
                if (c >= 0) to[i] = std::max(to[i], from[c]);
            }
        }
    };
    constexpr int kGrain = 16;
    parallelFor(work, blocks.height, fillRow, kGrain);
    levels_.push_back(std::move(blocks));
}

// Loads the tile's cells and kReach more, mirrored and wrapped.
void QuadrantCones::loadCells(int x0, int y0, const ConeTile& tile, Scratch& scratch) const {
    const auto loadRow = [&](const auto& image, int n, int count, auto* to, std::size_t stride, auto empty) {
        const int y = y_.cellAt(y0 + n);
        int k = 0;
        while (y >= 0 && k < count) {
            const int x = x_.cellAt(x0 + k);
            if (x < 0) break;
            const auto* from = image.row(y).data() + x;
            const int run = std::min(count - k, x_.mirrored ? x + 1 : x_.cells - x);
            if (x_.mirrored) {
                for (int i = 0; i < run; ++i) to[k + i] = from[-i];
            } else {
                std::copy(from, from + run, to + k);
            }
            k += run;
        }
        std::fill(to + k, to + stride, empty);
    };
    for (int n = 0; n < tile.height + kReach; ++n) {
        loadRow(cells_, n, tile.width + kReach, scratch.windows.data() + toSize(n) * tile.stride, tile.stride, kEmpty);
    }
    for (int n = 0; n < tile.height + 1; ++n) {
        loadRow(depths_, n, tile.width + 1, scratch.depths.data() + toSize(n) * tile.stride, tile.stride, kConeDepths);
    }
}

// Raises the slopes by the rings of one level. Returns true if cells beyond these rings may still matter.
bool QuadrantCones::steepenByLevel(int level, int x0, int y0, const ConeTile& tile, Scratch& scratch) const {
    const Blocks& blocks = levels_[toSize(level - 1)];
    const int i0 = x0 >> level;
    const int j0 = y0 >> level;
    const int width = ((x0 + tile.width - 1) >> level) - i0 + 1;
    const int height = ((y0 + tile.height - 1) >> level) - j0 + 1;
    ConeRings rings;
    rings.stride = strideOf(width);
    rings.level = level;
    rings.x0 = x0 - (i0 << level);
    rings.y0 = y0 - (j0 << level);
    scratch.windows.resize(std::max(scratch.windows.size(), rings.stride * toSize(height + kReach)));
    for (int j = 0; j < height + kReach; ++j) {
        const float* from = blocks.row(j0 + j) + i0;
        float* to = scratch.windows.data() + toSize(j) * rings.stride;
        std::fill(std::copy(from, from + width + kReach, to), to + rings.stride, kEmpty);
    }
    int left = kReach;
    const auto grow = [&](int shift) {
        left -= shift;
        growWindows(scratch.windows.data(), rings.stride, width + left, height + left, shift);
    };
    // Windows of n + 1 blocks from the corner of a block contain all gaps below n blocks of its cells.
    for (const int shift : {1, 2, 4, 1}) grow(shift);
    for (std::size_t k = 0; k < kConeRings; ++k) {
        grow(1);
        auto& plane = scratch.planes[k];
        const auto begin = scratch.windows.begin();
        plane.assign(begin, begin + static_cast<std::ptrdiff_t>(rings.stride * toSize(height)));
        rings.planes[k] = plane.data();
        rings.inverseGaps[k] = 1.0F / static_cast<float>((kFirstBlocks + static_cast<int>(k)) << level);
    }
    const auto farther = static_cast<float>(2 * kFirstBlocks << level);
    return steepenByBlocks(rings, static_cast<float>(map_.highest), farther, tile) > 0;
}

void QuadrantCones::buildTile(int x0, int y0, Scratch& scratch, std::uint32_t* entries) const {
    ConeTile tile;
    tile.width = std::min(kTileWidth, x_.cells - x0);
    tile.height = std::min(kTileHeight, y_.cells - y0);
    tile.stride = strideOf(tile.width);
    const std::size_t room = tile.stride * toSize(tile.height + kReach + 1);
    scratch.windows.resize(std::max(scratch.windows.size(), room));
    scratch.depths.resize(room);
    scratch.apex.resize(room);
    scratch.slope.resize(room);
    scratch.own.resize(room);
    tile.apex = scratch.apex.data();
    tile.slope = scratch.slope.data();
    tile.depths = scratch.own.data();
    loadCells(x0, y0, tile, scratch);
    placeApexes(scratch.depths.data(), tile.stride, static_cast<float>(map_.highest), static_cast<float>(map_.unit),
                tile);
    growWindows(scratch.windows.data(), tile.stride, tile.width + kNearRings, tile.height + kNearRings, 1);
    for (int gap = 1; gap <= kNearRings; ++gap) {
        const int left = kNearRings - gap;
        growAndSteepen(scratch.windows.data(), tile.stride, tile.width + left, tile.height + left,
                       1.0F / static_cast<float>(gap), tile);
    }
    for (int level = 1; level <= static_cast<int>(levels_.size()); ++level) {
        if (!steepenByLevel(level, x0, y0, tile, scratch)) break;
    }
    for (int n = 0; n < tile.height; ++n) {
        packCones(tile, n, scratch.entries.data());
        std::uint32_t* row = entries + map_.index(0, y_.cellAt(y0 + n));
        const auto* from = scratch.entries.data();
        if (x_.mirrored) {
            std::reverse_copy(from, from + tile.width, row + (x_.cells - x0 - tile.width));
        } else {
            std::copy(from, from + tile.width, row + x0);
        }
    }
}

void QuadrantCones::build(std::uint32_t* entries, Work& work) {
    const int farthest = std::max(x_.cells, y_.cells) - 2;  // largest gap
    while (farthest >= kFirstBlocks << (levels_.size() + 1)) addLevel(work);
    const int across = (x_.cells + kTileWidth - 1) / kTileWidth;
    const int down = (y_.cells + kTileHeight - 1) / kTileHeight;
    ScratchPool<Scratch> scratch;
    parallelFor(work, across * down, [&](int n) {
        buildTile(n % across * kTileWidth, n / across * kTileHeight, *scratch.borrow(), entries);
        work.progress().advance();
    });
}

// The depths of the cells, rounded down.
DepthImage depthsOf(const FloatImage& cells, const PackedCones& map, Work& work) {
    DepthImage depths(cells.width(), cells.height());
    const double perUnit = map.unit > 0 ? 1 / map.unit : 0;
    constexpr double kRounding = 1e-6;  // of a unit; the comparison below decides
    parallelFor(work, cells.height(), [&](int y) {
        const auto from = cells.row(y);
        const auto to = depths.row(y);
        for (std::size_t x = 0; x < from.size(); ++x) {
            const double height = static_cast<double>(from[x]);
            auto depth = static_cast<int>((map.highest - height) * perUnit + kRounding);
            depth = std::min(depth, static_cast<int>(kConeDepths));
            depth -= map.highest - depth * map.unit < height ? 1 : 0;
            to[x] = static_cast<std::uint16_t>(depth);
        }
    });
    return depths;
}

// For each row of cells, pairs of nodes: the one before the row and the one after it.
UnfilledVector<float> nodesOf(const HeightField& field, const PackedCones& map, Work& work) {
    const CellGrid grid(field);
    const FloatImage& heights = *field.sharedHeights();
    UnfilledVector<float> nodes(2 * map.quadrantEntries(), 0.0F);
    parallelFor(work, map.ny, [&](int cy) {
        const auto before = heights.row(grid.y.nodeBefore(cy)), after = heights.row(grid.y.nodeAfter(cy));
        float* to = nodes.data() + 2 * map.index(0, cy);
        for (int cx = 0; cx <= map.nx; ++cx) {
            const int i = cx < map.nx ? grid.x.nodeBefore(cx) : grid.x.nodeAfter(map.nx - 1);
            *to++ = before[toSize(i)];
            *to++ = after[toSize(i)];
        }
    });
    return nodes;
}

}  // namespace

PackedCones buildPackedCones(const HeightField& field, Work& work) {
    const FloatImage cells = cellMaxima(field, work);
    PackedCones map;
    map.nx = cells.width();
    map.ny = cells.height();
    const auto [lowest, highest] = minMax<float>(work, cells.pixels());
    map.lowest = static_cast<double>(lowest);
    map.highest = static_cast<double>(highest);
    map.unit = (map.highest - map.lowest) / kConeDepths;
    const DepthImage depths = depthsOf(cells, map, work);
    const auto tiles = [](int size, int tile) { return (size + tile - 1) / tile; };
    work.progress().begin("map packed-cones", std::int64_t{4} * tiles(map.nx, kTileWidth) * tiles(map.ny, kTileHeight));
    map.stride = field.surface() == Surface::Bilinear ? map.nx + 1 : map.nx;
    if (map.quadrantEntries() >= kWideEntries) {
        constexpr int kUnit = 1 << kRowShift;
        map.stride = (map.stride + kUnit - 1) / kUnit * kUnit;
    }
    constexpr std::size_t kQuadrants = 4;
    map.entries.resize(kQuadrants * map.quadrantEntries(), 0U);
    for (std::size_t quadrant = 0; quadrant < kQuadrants; ++quadrant) {
        QuadrantCones cones(cells, depths, map, field.address() == Address::Repeat, static_cast<int>(quadrant));
        cones.build(map.entries.data() + quadrant * map.quadrantEntries(), work);
    }
    if (field.surface() == Surface::Bilinear) map.nodes = nodesOf(field, map, work);
    return map;
}

std::shared_ptr<const PackedCones> packedCones(const HeightField& field, MapCache& cache, Work& work) {
    // Clamp and border have the same cells, with no surface outside.
    std::string kind = "packed-cones/" + std::string(surfaceName(field.surface()));
    kind += field.address() == Address::Repeat ? "/repeat" : "/clamped";
    const CellGrid grid(field);
    const std::size_t entries = (toSize(grid.x.cells) + 1) * toSize(grid.y.cells);
    checkMapMemory("packed-cones", entries * (4 * sizeof(std::uint32_t) + 2 * sizeof(float)), cache);
    // Per texel: entries and nodes; cells, depths, and the levels of one quadrant during construction.
    constexpr std::uint64_t kBytes = 4 * sizeof(std::uint32_t) + 2 * sizeof(float) + 8;
    return cache.get<PackedCones>({kind, field.sharedHeights()}, bytesForTexels(field, kBytes), work,
                                  [&](Work& w) { return buildPackedCones(field, w); });
}

}  // namespace relief
