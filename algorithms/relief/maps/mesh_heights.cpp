#include "relief/maps/mesh_heights.h"

#include <cassert>

#include "base/parallel.h"
#include "relief/describe.h"
#include "relief/maps/map_memory.h"

namespace relief {

std::shared_ptr<const MeshHeights> meshHeights(const HeightField& field, int density, MapCache& cache, Work& work) {
    assert(density >= 1);
    const std::string kind = "mesh/" + std::to_string(density) + "/" + std::string(surfaceName(field.surface())) + "/" +
                             (field.address() == Address::Repeat ? "repeat" : "clamped");
    const auto side = static_cast<std::uint64_t>(density);
    return cache.get<MeshHeights>(
        {kind, field.sharedHeights()}, byteProduct({side, side, sizeof(float)}), work, [&](Work& w) {
            MeshHeights mesh{FloatImage(density, density)};
            const double perColumn = static_cast<double>(field.width()) / density;
            const double perRow = static_cast<double>(field.height()) / density;
            parallelFor(w, density, [&](int j) {
                for (int i = 0; i < density; ++i) {
                    mesh.heights(i, j) = static_cast<float>(field.at((i + 0.5) * perColumn, (j + 0.5) * perRow));
                }
            });
            return mesh;
        });
}

}  // namespace relief
