// What of a polygon can be seen: cut at the near plane and at the screen's edges, facing, and the pixels of each row.
//
// Source: Sutherland and Hodgman 1974 (polygon clipping) ("rows on which q changes sign are clipped
// to the valid interval first"); [PERSP].
//
// Frames and units: projected points (x Z, y Z, Z) as PinholeCamera::project gives them (pixels times depth, depth);
// texels; screen points in pixels, y down. Both kinds of cut are linear in the projected point, and texture coordinates
// are linear in it too (not on the screen!), so what is cut keeps its exact texture coordinates.
//
// Guarantees: polygons that are convex stay convex; a point made by a cut depends on the edge and not on its direction,
// so polygons with a common edge still share it, bit for bit. Every pixel centre of an area tiled edge to edge is in
// the rowSpan of exactly one polygon (only rounding that turns a sliver of 1e-13 pixels inside out exactly at a pixel
// centre could break that). Failure mode: none on finite input; programmer mistakes (NaN, fewer than 3 points) assert.
// Cost: O(points) a cut and a row.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "homography.h"

namespace relief {

struct ClipVertex {
    glm::dvec3 projected{0.0, 0.0, 1.0};  // x Z and y Z in pixels times depth, Z = depth along forward
    glm::dvec2 texel{0.0, 0.0};           // s, t

    // Pixel coordinates; only with depth > 0, that is after clipToNear.
    glm::dvec2 screen() const { return {projected.x / projected.z, projected.y / projected.z}; }
};

using ClipPolygon = std::vector<ClipVertex>;

// Half-open [begin, end) of pixel columns or rows.
struct PixelSpan {
    std::int64_t begin = 0;
    std::int64_t end = 0;

    bool empty() const { return begin >= end; }
    std::int64_t size() const { return empty() ? 0 : end - begin; }
    bool operator==(const PixelSpan&) const = default;
};

// The polygon of these texel corners (in order round it) on the plane, projected but not yet cut.
ClipPolygon projectPolygon(const PinholeCamera& camera, const TexturedPlane& plane,
                           std::span<const glm::dvec2> texelCorners);

// What lies at a depth of nearDepth (> 0) or more. Empty if nothing does (wholly behind the eye).
ClipPolygon clipToNear(std::span<const ClipVertex> polygon, double nearDepth);

// What lies on the screen 0 <= x <= width, 0 <= y <= height (pixels). The polygon must have been cut at the near plane.
ClipPolygon clipToScreen(std::span<const ClipVertex> polygon, double width, double height);

// Pixel coordinates of the points of a polygon cut at the near plane.
std::vector<glm::dvec2> screenPoints(std::span<const ClipVertex> polygon);

// Facing. Of a plane: whether the eye is strictly behind or in it. Of a map: the determinant's sign (pixels in front of
// the eye only). Of screen points in the order (0,0), (W,0), (W,H), (0,H) of their texels: the sign of their area.
// Edge-on counts as back-facing: there is nothing to draw.
bool isBackFacing(const TexturedPlane& plane, const glm::dvec3& eye);
bool isBackFacing(const Homography& map);
bool isBackFacing(std::span<const glm::dvec2> screen);

// The rows [begin, end) in [0, height) whose centre line y = row + 1/2 meets the convex polygon (top included, bottom
// not).
PixelSpan rowRange(std::span<const glm::dvec2> screen, std::int64_t height);

// The pixels of that row in [0, width) whose centres lie in the convex polygon; a centre on a left edge or a top vertex
// is in, on a right edge or a bottom one is out: the fill rule that gives each pixel of a tiling to one polygon.
PixelSpan rowSpan(std::span<const glm::dvec2> screen, std::int64_t row, std::int64_t width);

// The smallest denominator at which pixels are still evaluated, for maps scaled as homography.h says.
inline constexpr double kHorizonQ = 1e-9;

// The part of a span on which q >= minQ as evaluated by map.denominator at pixel centres: what is before the horizon.
PixelSpan clipRowToHorizon(const Homography& map, std::int64_t row, PixelSpan span, double minQ = kHorizonQ);

}  // namespace relief
