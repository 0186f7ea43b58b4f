#include "mapping/clipping.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace relief {

namespace {

// Keeps the part of the polygon where distance(vertex) >= 0; distance is linear in the projected point. onto(vertex)
// moves a point of the cut exactly onto the plane, which interpolation reaches only up to rounding.
template <typename Distance, typename Onto>
ClipPolygon cut(std::span<const ClipVertex> polygon, const Distance& distance, const Onto& onto) {
    ClipPolygon kept;
    kept.reserve(polygon.size() + 1);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const ClipVertex& here = polygon[k];
        const ClipVertex& next = polygon[(k + 1) % polygon.size()];
        const double dHere = distance(here);
        const double dNext = distance(next);
        if (dHere >= 0.0) kept.push_back(here);
        if ((dHere > 0.0 && dNext < 0.0) || (dHere < 0.0 && dNext > 0.0)) {
            // Interpolates from the inner to the outer vertex always, so that both polygons at an edge get the same
            // point.
            const bool leaving = dHere > 0.0;
            const ClipVertex& in = leaving ? here : next;
            const ClipVertex& out = leaving ? next : here;
            const double dIn = leaving ? dHere : dNext;
            const double dOut = leaving ? dNext : dHere;
            const double part = dIn / (dIn - dOut);
            ClipVertex made{in.projected + part * (out.projected - in.projected),
                            in.texel + part * (out.texel - in.texel)};
            onto(made);
            kept.push_back(made);
        }
    }
    if (kept.size() < 3) kept.clear();  // touches the plane in a point or an edge
    return kept;
}

// The first pixel in [0, count] whose centre is at or after coordinate `at`.
std::int64_t firstCentre(double at, std::int64_t count) {
    const double pixel = std::ceil(at - 0.5);
    if (!(pixel > 0.0)) return 0;
    return pixel < static_cast<double>(count) ? static_cast<std::int64_t>(pixel) : count;
}

}  // namespace

ClipPolygon projectPolygon(const PinholeCamera& camera, const TexturedPlane& plane,
                           std::span<const glm::dvec2> texelCorners) {
    ClipPolygon polygon;
    polygon.reserve(texelCorners.size());
    for (const glm::dvec2& texel : texelCorners) {
        polygon.push_back({camera.project(plane.at(texel.x, texel.y)), texel});
    }
    return polygon;
}

ClipPolygon clipToNear(std::span<const ClipVertex> polygon, double nearDepth) {
    assert(nearDepth > 0.0);
    return cut(
        polygon, [nearDepth](const ClipVertex& v) { return v.projected.z - nearDepth; },
        [nearDepth](ClipVertex& v) { v.projected.z = nearDepth; });
}

ClipPolygon clipToScreen(std::span<const ClipVertex> polygon, double width, double height) {
    ClipPolygon kept = cut(
        polygon, [](const ClipVertex& v) { return v.projected.x; }, [](ClipVertex& v) { v.projected.x = 0.0; });
    kept = cut(
        kept, [width](const ClipVertex& v) { return width * v.projected.z - v.projected.x; },
        [width](ClipVertex& v) { v.projected.x = width * v.projected.z; });
    kept = cut(
        kept, [](const ClipVertex& v) { return v.projected.y; }, [](ClipVertex& v) { v.projected.y = 0.0; });
    return cut(
        kept, [height](const ClipVertex& v) { return height * v.projected.z - v.projected.y; },
        [height](ClipVertex& v) { v.projected.y = height * v.projected.z; });
}

std::vector<glm::dvec2> screenPoints(std::span<const ClipVertex> polygon) {
    std::vector<glm::dvec2> points;
    points.reserve(polygon.size());
    for (const ClipVertex& vertex : polygon) {
        assert(vertex.projected.z > 0.0);
        points.push_back(vertex.screen());
    }
    return points;
}

bool isBackFacing(const TexturedPlane& plane, const glm::dvec3& eye) {
    return !(glm::dot(plane.frontNormal(), eye - plane.origin) > 0.0);
}

bool isBackFacing(const Homography& map) {
    return !(map.determinant() > 0.0);
}

bool isBackFacing(std::span<const glm::dvec2> screen) {
    double area = 0.0;
    for (std::size_t k = 2; k < screen.size(); ++k) {
        const glm::dvec2 a = screen[k - 1] - screen[0];
        const glm::dvec2 b = screen[k] - screen[0];
        area += a.x * b.y - a.y * b.x;
    }
    return !(area > 0.0);
}

PixelSpan rowRange(std::span<const glm::dvec2> screen, std::int64_t height) {
    if (screen.size() < 3) return {};
    const auto [low, high] = std::minmax_element(screen.begin(), screen.end(),
                                                 [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; });
    return {firstCentre(low->y, height), firstCentre(high->y, height)};
}

PixelSpan rowSpan(std::span<const glm::dvec2> screen, std::int64_t row, std::int64_t width) {
    const double y = static_cast<double>(row) + 0.5;
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t k = 0; k < screen.size(); ++k) {
        const glm::dvec2& a = screen[k];
        const glm::dvec2& b = screen[(k + 1) % screen.size()];
        assert(std::isfinite(a.x) && std::isfinite(a.y));
        // Interpolates from the upper end to the lower always, so that both polygons at an edge get the same crossing.
        const glm::dvec2& top = a.y < b.y ? a : b;
        const glm::dvec2& bottom = a.y < b.y ? b : a;
        if (!(top.y <= y && y < bottom.y)) continue;
        const double part = (y - top.y) / (bottom.y - top.y);
        const double x =
            std::clamp(top.x + part * (bottom.x - top.x), std::min(top.x, bottom.x), std::max(top.x, bottom.x));
        left = std::min(left, x);
        right = std::max(right, x);
    }
    if (!(left <= right)) return {};
    const PixelSpan span{firstCentre(left, width), firstCentre(right, width)};
    return span.empty() ? PixelSpan{} : span;
}

PixelSpan clipRowToHorizon(const Homography& map, std::int64_t row, PixelSpan span, double minQ) {
    if (span.empty()) return {};
    const double y = static_cast<double>(row) + 0.5;
    const auto inFront = [&](std::int64_t pixel) {
        return map.denominator(static_cast<double>(pixel) + 0.5, y) >= minQ;
    };
    const bool first = inFront(span.begin);
    const bool last = inFront(span.end - 1);
    if (first && last) return span;
    if (!first && !last) return {};
    // q is monotone along the row, also in floating point, so bisection finds the pixel at which the comparison
    // changes.
    std::int64_t before = span.begin;
    std::int64_t after = span.end - 1;
    while (after - before > 1) {
        const std::int64_t middle = before + (after - before) / 2;
        (inFront(middle) == first ? before : after) = middle;
    }
    return first ? PixelSpan{span.begin, after} : PixelSpan{after, span.end};
}

}  // namespace relief
