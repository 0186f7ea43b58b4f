#include "rendering/pixel_coefficients.h"

#include "rendering/visible_polygons.h"

namespace relief {

std::optional<PixelCoefficients> pixelCoefficients(const FrameRequest& request, int x, int y) {
    if (!pixelRay(request, x, y)) return std::nullopt;  // also throws for pixels outside the picture
    const VisiblePolygons visible =
        visiblePolygons(makeScene(request.scene, request.field.width(), request.field.height()), requestCamera(request),
                        request.width, request.height, request.field.reliefDepth());
    return pixelCoefficients(visible.at(x, y, request.width)->texelFromScreen, x + 0.5, y + 0.5);
}

}  // namespace relief
