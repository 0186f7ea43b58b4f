#include "rendering/base_level.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "images/pyramid.h"
#include "mapping/footprint.h"
#include "relief/maps/mean_levels_map.h"
#include "rendering/visible_polygons.h"

namespace relief {

namespace {

constexpr int kPlaces = 32;  // number of sampled rows of the picture, and of sampled pixels per row

double narrowest(const VisiblePolygon& polygon, PixelSpan span, int y) {
    double texels = std::numeric_limits<double>::infinity();
    const auto step = std::max<std::int64_t>((span.end - span.begin) / kPlaces, 1);
    const auto look = [&](std::int64_t x) {
        const double minor =
            ellipseOf(jacobianAt(polygon.texelFromScreen, static_cast<double>(x) + 0.5, y + 0.5)).semiAxes().minor;
        if (std::isfinite(minor)) texels = std::min(texels, minor);
    };
    for (std::int64_t x = span.begin; x < span.end; x += step) look(x);
    if (span.end > span.begin) look(span.end - 1);
    return texels;
}

}  // namespace

FootprintLevel footprintLevel(const FrameRequest& request) {
    const VisiblePolygons visible =
        visiblePolygons(makeScene(request.scene, request.field.width(), request.field.height()), requestCamera(request),
                        request.width, request.height, request.field.reliefDepth());
    double texels = std::numeric_limits<double>::infinity();
    const int step = std::max(request.height / kPlaces, 1);
    for (const VisiblePolygon& polygon : visible.polygons) {
        const auto row = [&](int y) {
            texels = std::min(texels, narrowest(polygon, polygon.span(y, request.width), y));
        };
        for (int y = 0; y < request.height; y += step) row(y);
        row(request.height - 1);
    }
    if (!std::isfinite(texels)) return {};
    const int last = Pyramid::levelCount(request.field.width(), request.field.height()) - 1;
    return {std::clamp(texels >= 1 ? static_cast<int>(std::floor(std::log2(texels))) : 0, 0, last), texels};
}

MethodChoice methodOfView(const FrameRequest& request, MethodChoice method) {
    std::optional<int> level;  // computed at most once, and only if an option needs it
    for (auto& [name, text] : method.options) {
        if (text != kBaseAuto || !name.ends_with(kBaseOption)) continue;
        if (!level) level = footprintLevel(request).level;
        text = std::to_string(*level);
    }
    return method;
}

}  // namespace relief
