#include "rendering/visible_polygons.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace relief {

namespace {

// Near plane, world units: nothing nearer to the eye is drawn.
constexpr double kNear = 1e-4;

void placeEye(VisiblePolygon& polygon, const PinholeCamera& camera, double reliefDepth) {
    const TexturedPlane& plane = polygon.quad.plane;
    const glm::dvec3 eye = camera.eye - plane.origin;
    const double height = glm::dot(eye, polygon.quad.normal);
    polygon.sEye = glm::dot(eye, plane.perS) / glm::dot(plane.perS, plane.perS);
    polygon.tEye = glm::dot(eye, plane.perT) / glm::dot(plane.perT, plane.perT);
    const double thickness = reliefDepth * glm::length(plane.perS) * polygon.quad.width;
    polygon.runPerTexel = thickness / height;
}

// 1 / depth and q are both linear on the screen and zero on the horizon, so they differ by a constant factor.
double inverseDepthPerQ(const VisiblePolygon& polygon, const ClipPolygon& clipped) {
    double best = 0;
    double factor = 0;
    for (const ClipVertex& vertex : clipped) {
        const glm::dvec2 p = vertex.screen();
        const double q = polygon.texelFromScreen.denominator(p.x, p.y);
        if (q <= best) continue;
        best = q;
        factor = 1 / (vertex.projected.z * q);
    }
    return factor;
}

}  // namespace

VisiblePolygon::Entry VisiblePolygon::entry(int x, int y) const {
    Entry entry;
    // The mapping direct needs no row.
    entries(y, mapping == kDirectRows ? PixelSpan{} : span(y, screenWidth), x, x + 1, &entry);
    return entry;
}

double VisiblePolygon::entries(int y, PixelSpan span, int first, int last, Entry* out) const {
    const auto depth = [&](const TexelPoint& texel) { return static_cast<float>(texel.q * inverseDepthPerQ); };
    if (mapping == kDirectRows) {
        for (int x = first; x < last; ++x) {
            const TexelPoint texel = texelFromScreen.at(x + 0.5, y + 0.5);
            out[x - first] = {ray(texel), depth(texel)};
        }
        return 0;
    }
    // The whole row is evaluated, because its ends determine the coordinates of affine and opposed rows and the drift
    // of the other mappings.
    thread_local std::vector<float> u, v;
    const auto count = static_cast<std::size_t>(span.end - span.begin);
    u.resize(count), v.resize(count);
    const PixelSpan made = evaluateRow<float>(texelFromScreen, y + 0.5, span, mapping, u.data(), v.data());
    double off = 0;
    for (int x = first; x < last; ++x) {
        TexelPoint texel = texelFromScreen.at(x + 0.5, y + 0.5);
        const float seen = depth(texel);
        // Rows in float are cut short next to the horizon, where direct mapping is used.
        if (x >= made.begin && x < made.end) {
            const auto n = static_cast<std::size_t>(x - span.begin);
            off = std::max(off, std::hypot(u[n] - texel.s, v[n] - texel.t));
            texel.s = u[n], texel.t = v[n];
        }
        out[x - first] = {ray(texel), seen};
    }
    return off;
}

float VisiblePolygon::inverseDepth(int x, int y) const {
    return static_cast<float>(texelFromScreen.denominator(x + 0.5, y + 0.5) * inverseDepthPerQ);
}

PixelSpan VisiblePolygon::span(int y, int width) const {
    return clipRowToHorizon(texelFromScreen, y, rowSpan(screen, y, width));
}

const VisiblePolygon* VisiblePolygons::at(int x, int y, int width) const {
    const VisiblePolygon* nearest = nullptr;
    float best = 0;
    for (const VisiblePolygon& polygon : polygons) {
        const PixelSpan span = polygon.span(y, width);
        if (x < span.begin || x >= span.end) continue;
        const float inverseDepth = polygon.inverseDepth(x, y);
        if (inverseDepth <= best) continue;
        best = inverseDepth;
        nearest = &polygon;
    }
    return nearest;
}

VisiblePolygons visiblePolygons(const std::vector<TexturedQuad>& scene, const PinholeCamera& camera, int width,
                                int height, double reliefDepth, const RowOptions& mapping) {
    VisiblePolygons visible;
    visible.total = static_cast<int>(scene.size());
    for (std::size_t n = 0; n < scene.size(); ++n) {
        VisiblePolygon polygon;
        polygon.quad = scene[n];
        polygon.mapping = mapping;
        polygon.screenWidth = width;
        polygon.width = scene[n].width;
        polygon.height = scene[n].height;
        polygon.number = static_cast<std::uint8_t>(n);
        const TexturedPlane& plane = polygon.quad.plane;
        // A view from within the plane sees only a line, which is not drawn.
        const double above = glm::dot(camera.eye - plane.origin, polygon.quad.normal);
        if (isBackFacing(plane, camera.eye) || above <= kNear) {
            ++visible.backFacing;
            continue;
        }
        const double w = polygon.quad.width;
        const double h = polygon.quad.height;
        const std::array<glm::dvec2, 4> corners{{{0, 0}, {w, 0}, {w, h}, {0, h}}};
        const ClipPolygon clipped =
            clipToScreen(clipToNear(projectPolygon(camera, plane, corners), kNear), width, height);
        if (clipped.size() < 3) {
            ++visible.offScreen;
            continue;
        }
        polygon.screen = screenPoints(clipped);
        polygon.texelFromScreen = fromCameraAndPlane(camera, plane);
        polygon.inverseDepthPerQ = inverseDepthPerQ(polygon, clipped);
        placeEye(polygon, camera, reliefDepth);
        visible.polygons.push_back(std::move(polygon));
    }
    return visible;
}

}  // namespace relief
