// The max pyramid over the cells of a field that is read by tiles. The upper levels are kept in memory as depths of 16
// bits; nodes of the lower levels are looked up in the file's levels of maxima.
//
// Values are conservative: at least the largest height of the surface within the node. On level 0 they are exact. A
// node of a bilinear surface on level l needs the texels from its first cell's to the one after its last cell's, so on
// the fly it is the maximum of the 2 x 2 texels of level l that contain these.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "images/tiled_heights.h"
#include "relief/cell_grid.h"
#include "relief/work.h"

namespace relief {

inline constexpr int kMaxLevels = 32;
inline constexpr double kDepthUnit = 0x1p-16;

// The depth 1 - maximum in units of kDepthUnit, rounded down.
inline std::uint16_t depthOf(float maximum) {
    const double depth = (1 - static_cast<double>(maximum)) / kDepthUnit;
    return static_cast<std::uint16_t>(static_cast<int>(std::clamp(depth, 0.0, 65535.0)));
}

// Thread-safe.
class TiledPyramid {
  public:
    // Reads the maxima of a level of at most kSourceTexels texels in parallel. The field must be read by tiles. Throws
    // InputError, WorkError, Cancelled.
    TiledPyramid(const HeightField& field, Work& work);
    // Upper bound of bytes(): a third of the tiles' bound, so a quarter of both together.
    static std::size_t mostBytes(const TiledHeights& tiles) {
        return std::max<std::size_t>(tiles.residentLimit() / 3, kLeastBytes);
    }

    int top() const { return top_; }
    float highest() const { return highest_; }
    std::size_t bytes() const { return depths_.size() * sizeof(std::uint16_t); }

    // The levels kept in memory, from the lowest one up, and where each begins; those below are read from the file.
    // SIMD may load two entries more.
    int firstKept() const { return firstKept_; }
    const std::uint16_t* keptDepths() const { return depths_.data(); }
    std::size_t keptCount() const { return depths_.size() - kPadding; }
    std::size_t start(int level) const { return starts_[static_cast<std::size_t>(level)]; }

    const TiledHeights& tiles() const { return *tiles_; }

    float maximum(int level, int x, int y) const {
        if (level >= firstKept_) return static_cast<float>(1 - kept(level, x, y) * kDepthUnit);
        return lookedUp(level, x, y);
    }
    std::uint16_t depth(int level, int x, int y) const {
        return level >= firstKept_ ? kept(level, x, y) : depthOf(lookedUp(level, x, y));
    }

  private:
    // Texels of the level from which the upper levels are made: reading them takes about a second.
    static constexpr std::size_t kSourceTexels = std::size_t{1} << 26;
    static constexpr std::size_t kLeastBytes = 4096;
    static constexpr std::size_t kPadding = 2;

    // The part of the source level, on one axis, that contains the texels of nodes `node` of a level `by` higher. Under
    // repeat `last` may be the length of the level, which stands for texel 0.
    struct Span {
        int first, last;
    };
    static Span span(const GridAxis& axis, bool nodes, int texels, int by, int node) {
        const int begin = node << by, end = (node + 1) << by;
        if (!nodes) return {begin, std::min(end, texels) - 1};
        if (axis.wraps) return {begin, std::min(end, texels)};
        return {std::max(begin - 1, 0), std::min(end, texels) - 1};
    }
    int across(int level) const { return ((grid_.x.cells - 1) >> level) + 1; }
    int down(int level) const { return ((grid_.y.cells - 1) >> level) + 1; }
    std::uint16_t kept(int level, int x, int y) const {
        return depths_[starts_[static_cast<std::size_t>(level)] +
                       static_cast<std::size_t>(y) * static_cast<std::size_t>(across(level)) +
                       static_cast<std::size_t>(x)];
    }
    // Heights of the file's level that lie on both sides of a node, on one axis.
    static std::pair<int, int> around(const GridAxis& axis, int texels, int node) {
        if (axis.wraps) return {node, node + 1 < texels ? node + 1 : 0};
        return {std::max(node - 1, 0), std::min(node, texels - 1)};
    }
    float lookedUp(int level, int x, int y) const {
        const TiledHeights& tiles = *tiles_;
        if (!nodes_) return tiles.maximum(level, x, y);
        const auto [i0, i1] = around(grid_.x, tiles.width(level), x);
        const auto [j0, j1] = around(grid_.y, tiles.height(level), y);
        return tiles.highest(level, i0, i1, j0, j1);
    }
    // The largest value of the file's level `source` over the texels of a node of level `source + by`.
    float covered(int source, int by, int x, int y) const;
    void fillFirst(int source, Work& work);

    std::shared_ptr<const TiledHeights> tiles_;
    CellGrid grid_;
    bool nodes_;  // cells lie between texels
    int top_ = 0;
    int firstKept_ = 0;
    float highest_ = 0;
    std::array<std::size_t, kMaxLevels> starts_{};
    std::vector<std::uint16_t> depths_;
};

}  // namespace relief
