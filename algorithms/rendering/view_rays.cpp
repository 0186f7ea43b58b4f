#include "rendering/view_rays.h"

#include "relief/memory.h"

namespace relief {

ViewRays viewRays(const FrameRequest& request) {
    constexpr std::uint64_t kBytes = RayBlock::kBytes + 2 * sizeof(std::int32_t) + 1;
    requireMemory(
        byteProduct({static_cast<std::uint64_t>(request.width), static_cast<std::uint64_t>(request.height), kBytes}),
        "--size");
    VisiblePolygons visible =
        visiblePolygons(makeScene(request.scene, request.field.width(), request.field.height()), requestCamera(request),
                        request.width, request.height, request.field.reliefDepth(), request.mapping);
    ViewRays view;
    for (int y = 0; y < request.height; ++y) {
        for (int x = 0; x < request.width; ++x) {
            const VisiblePolygon* const polygon = visible.at(x, y, request.width);
            if (polygon == nullptr) continue;
            view.rays.push(polygon->entry(x, y).ray);
            view.x.push_back(x);
            view.y.push_back(y);
            view.polygon.push_back(static_cast<std::uint8_t>(polygon - visible.polygons.data()));
        }
    }
    view.polygons = std::move(visible.polygons);
    return view;
}

}  // namespace relief
