#include "relief/maps/tiled_pyramid.h"

#include "base/parallel.h"
#include "images/pyramid.h"

namespace relief {

TiledPyramid::TiledPyramid(const HeightField& field, Work& work)
    : tiles_(field.sharedTiles()), grid_(field), nodes_(field.surface() == Surface::Bilinear) {
    const TiledHeights& tiles = *tiles_;
    top_ = Pyramid::levelCount(grid_.x.cells, grid_.y.cells) - 1;
    highest_ = tiles.maximum(tiles.levels() - 1, 0, 0);
    const auto texels = [&](int level) {
        return static_cast<std::size_t>(tiles.width(level)) * static_cast<std::size_t>(tiles.height(level));
    };
    const auto nodesFrom = [&](int level) {
        std::size_t count = 0;
        for (int l = level; l <= top_; ++l) {
            count += static_cast<std::size_t>(across(l)) * static_cast<std::size_t>(down(l));
        }
        return count;
    };
    int source = 0;
    while (texels(source) > kSourceTexels && source + 1 < tiles.levels()) ++source;
    firstKept_ = source;
    const std::size_t most = mostBytes(tiles) / sizeof(std::uint16_t) - kPadding;
    while (nodesFrom(firstKept_) > most && firstKept_ + 1 < tiles.levels()) ++firstKept_;
    depths_.resize(nodesFrom(firstKept_) + kPadding);
    std::size_t start = 0;
    for (int l = firstKept_; l <= top_; ++l) {
        starts_[static_cast<std::size_t>(l)] = start;
        start += static_cast<std::size_t>(across(l)) * static_cast<std::size_t>(down(l));
    }
    fillFirst(source, work);
    for (int l = firstKept_ + 1; l <= top_; ++l) {
        const int width = across(l - 1), height = down(l - 1);
        std::uint16_t* const to = depths_.data() + starts_[static_cast<std::size_t>(l)];
        parallelFor(work, down(l), [&](int y) {
            std::uint16_t* const row = to + static_cast<std::size_t>(y) * static_cast<std::size_t>(across(l));
            for (int x = 0; x < across(l); ++x) {
                const int x1 = std::min(2 * x + 1, width - 1), y1 = std::min(2 * y + 1, height - 1);
                row[x] = std::min(
                    {kept(l - 1, 2 * x, 2 * y), kept(l - 1, x1, 2 * y), kept(l - 1, 2 * x, y1), kept(l - 1, x1, y1)});
            }
        });
    }
}

float TiledPyramid::covered(int source, int by, int x, int y) const {
    if (by == 0) return lookedUp(source, x, y);
    const TiledHeights& tiles = *tiles_;
    const int width = tiles.width(source), height = tiles.height(source);
    const Span across = span(grid_.x, nodes_, width, by, x), down = span(grid_.y, nodes_, height, by, y);
    float highest = 0;
    for (int j = down.first; j <= down.last; ++j) {
        const int row = j == height ? 0 : j;
        for (int i = across.first; i <= across.last; ++i) {
            highest = std::max(highest, tiles.maximum(source, i == width ? 0 : i, row));
        }
    }
    return highest;
}

// Goes through the file by blocks about as large as a tile, so that few tiles are read twice.
void TiledPyramid::fillFirst(int source, Work& work) {
    const int by = firstKept_ - source;
    const int side = std::max(kTileSide >> by, 1);
    const int width = across(firstKept_), height = down(firstKept_);
    parallelFor(work, (height + side - 1) / side, [&](int block) {
        const int bottom = std::min((block + 1) * side, height);
        for (int left = 0; left < width; left += side) {
            for (int y = block * side; y < bottom; ++y) {
                std::uint16_t* const row =
                    depths_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
                for (int x = left; x < std::min(left + side, width); ++x) row[x] = depthOf(covered(source, by, x, y));
            }
        }
    });
}

}  // namespace relief
