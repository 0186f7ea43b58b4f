// The visible part of a polygon: clipping at the near plane and at the screen's edges, facing, and the pixels of each
// row.
//
// Sources: Sutherland and Hodgman 1974 (polygon clipping); [PERSP] (rows on which q changes sign are clipped to the
// valid interval before evaluation).
//
// Frames and units: projected points (x Z, y Z, Z) as returned by PinholeCamera::project (pixels times depth, depth);
// texture coordinates in texels; screen points in pixels, y down. Both kinds of clipping are linear in the projected
// point. Texture coordinates are linear in it too (though not on the screen), so clipped vertices keep exact texture
// coordinates.
//
// Guarantees: convex polygons remain convex. A vertex made by clipping depends on the edge and not on its direction, so
// polygons with a common edge still share it, bit for bit. Every pixel centre of an area tiled edge to edge is in the
// rowSpan of exactly one polygon (only rounding that turns a sliver of 1e-13 pixels inside out exactly at a pixel
// centre could break that). Errors: none on finite input; violated preconditions (NaN, fewer than 3 points) assert.
// Cost: O(points) per clip and per row. Thread-safe.
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

    // Pixel coordinates. Precondition: depth > 0, so clip with clipToNear first.
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

// Projects the polygon with these texel corners (in order around it) on the plane, without clipping.
ClipPolygon projectPolygon(const PinholeCamera& camera, const TexturedPlane& plane,
                           std::span<const glm::dvec2> texelCorners);

// Returns the part of the polygon at a depth of nearDepth (> 0) or more; empty if all of it is nearer or behind the
// eye.
ClipPolygon clipToNear(std::span<const ClipVertex> polygon, double nearDepth);

// Returns the part of the polygon on the screen 0 <= x <= width, 0 <= y <= height (pixels). The polygon must have been
// clipped at the near plane.
ClipPolygon clipToScreen(std::span<const ClipVertex> polygon, double width, double height);

// Pixel coordinates of the vertices of a polygon that was clipped at the near plane.
std::vector<glm::dvec2> screenPoints(std::span<const ClipVertex> polygon);

// Tests for back faces. For a plane: returns false if the eye is strictly in front of it. For a map: by the sign of the
// determinant (valid for pixels in front of the eye). For screen points in the order of their texels (0,0), (W,0),
// (W,H), (0,H): by the sign of their area. Edge-on counts as back-facing, because there is nothing to draw.
bool isBackFacing(const TexturedPlane& plane, const glm::dvec3& eye);
bool isBackFacing(const Homography& map);
bool isBackFacing(std::span<const glm::dvec2> screen);

// The rows [begin, end) in [0, height) whose centre line y = row + 1/2 meets the convex polygon, including its top but
// not its bottom.
PixelSpan rowRange(std::span<const glm::dvec2> screen, std::int64_t height);

// The pixels of that row in [0, width) whose centres lie in the convex polygon. A centre on a left edge or a top vertex
// is inside, one on a right edge or a bottom vertex is outside. This fill rule gives each pixel of a tiling to one
// polygon.
PixelSpan rowSpan(std::span<const glm::dvec2> screen, std::int64_t row, std::int64_t width);

// The smallest denominator at which pixels are evaluated, for maps normalised as described in homography.h.
inline constexpr double kHorizonQ = 1e-9;

// The part of a span in front of the horizon: pixels at whose centres map.denominator returns at least minQ.
PixelSpan clipRowToHorizon(const Homography& map, std::int64_t row, PixelSpan span, double minQ = kHorizonQ);

}  // namespace relief
