#include "relief/maps/max_pyramid_map.h"

#include "base/parallel.h"
#include "relief/leaf.h"
#include "relief/maps/map_memory.h"

namespace relief {

FloatImage cellMaxima(const HeightField& field, Work& work) {
    if (field.surface() == Surface::Columns) return field.heights();
    const CellGrid grid(field);
    FloatImage maxima(grid.x.cells, grid.y.cells);
    parallelFor(work, grid.y.cells, [&](int cy) {
        const auto row = maxima.row(cy);
        for (int cx = 0; cx < grid.x.cells; ++cx) {
            row[static_cast<std::size_t>(cx)] = cellMaximum<Surface::Bilinear>(field.heights(), grid, cx, cy);
        }
    });
    return maxima;
}

std::shared_ptr<const MaxPyramidMap> maxPyramidMap(const HeightField& field, MapCache& cache, Work& work,
                                                   const MaxPyramidMap* before) {
    // Clamp and border have the same cells; for columns all addressing modes do.
    std::string kind = "max-pyramid/columns";
    if (field.surface() == Surface::Bilinear) {
        kind = field.address() == Address::Repeat ? "max-pyramid/bilinear/repeat" : "max-pyramid/bilinear/clamped";
    }
    constexpr std::uint64_t kBytes = 6;  // per texel: cells, and a third of them on the levels above
    const bool tiled = field.tiles() != nullptr;
    const std::uint64_t need = tiled ? TiledPyramid::mostBytes(*field.tiles()) : bytesForTexels(field, kBytes);
    if (tiled) kind = kTiledKind + kind;
    return cache.get<MaxPyramidMap>({kind, field.identity()}, need, work, [&](Work& w) {
        if (tiled) return MaxPyramidMap{{}, std::make_shared<const TiledPyramid>(field, w)};
        const CellGrid grid(field);
        const bool edit = before != nullptr && before->pyramid.level(0).width() == grid.x.cells &&
                          before->pyramid.level(0).height() == grid.y.cells;
        // The largest height of a column is its own.
        if (field.surface() == Surface::Columns) {
            if (edit) return MaxPyramidMap{Pyramid::edited(before->pyramid, field.sharedHeights())};
            return MaxPyramidMap{Pyramid(PyramidKind::Max, field.sharedHeights(), w)};
        }
        if (edit) return MaxPyramidMap{Pyramid::edited(before->pyramid, cellMaxima(field, w))};
        return MaxPyramidMap{Pyramid(PyramidKind::Max, cellMaxima(field, w), w)};
    });
}

}  // namespace relief
