#include "relief/maps/mesh_heights.h"

#include <algorithm>
#include <cassert>

#include "base/parallel.h"
#include "relief/describe.h"
#include "relief/maps/map_memory.h"

namespace relief {

namespace {

// Number of vertices along a side of `texels` texels.
int vertices(int texels, int density, const HeightField& field) {
    if (field.address() == Address::Repeat) return density;
    const std::int64_t quads = (static_cast<std::int64_t>(texels - 1) * density + texels - 1) / texels;
    return static_cast<int>(std::min<std::int64_t>(density, quads + 1));
}

}  // namespace

std::shared_ptr<const MeshHeights> meshHeights(const HeightField& field, int density, MapCache& cache, Work& work) {
    assert(density >= 1);
    const std::string kind = "mesh/" + std::to_string(density) + "/" + std::string(surfaceName(field.surface())) + "/" +
                             (field.address() == Address::Repeat ? "repeat" : "clamped");
    const auto side = static_cast<std::uint64_t>(density);
    return cache.get<MeshHeights>(
        {kind, field.sharedHeights()}, byteProduct({side, side, sizeof(float)}), work, [&](Work& w) {
            MeshHeights mesh{
                FloatImage(vertices(field.width(), density, field), vertices(field.height(), density, field)), density};
            const double perColumn = static_cast<double>(field.width()) / density;
            const double perRow = static_cast<double>(field.height()) / density;
            parallelFor(w, mesh.heights.height(), [&](int j) {
                for (int i = 0; i < mesh.heights.width(); ++i) {
                    mesh.heights(i, j) = static_cast<float>(field.at(0.5 + i * perColumn, 0.5 + j * perRow));
                }
            });
            return mesh;
        });
}

}  // namespace relief
