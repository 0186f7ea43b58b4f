#include "rendering/mesh_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "rendering/frame.h"

namespace relief {

namespace {

// Side of a block, in quads.
constexpr int kBlock = 16;
// Near plane, world units, as for polygons: nothing nearer is drawn.
constexpr double kNear = 1e-4;

using Triangle = std::array<ClipVertex, 3>;

// Returns the nine coefficients of the homography onto the triangle's own plane, with q = 1 / depth, in pixels relative
// to `origin`. An origin near the triangle preserves precision for small triangles far from the screen's corner.
// Returns std::nullopt for triangles that face away or are edge-on.
std::optional<Homography> rowsOf(const Triangle& triangle, glm::dvec2 origin) {
    std::array<glm::dvec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
        p[k] = triangle[k].projected - triangle[k].projected.z * glm::dvec3(origin, 0);
    }
    const double determinant = glm::dot(p[0], glm::cross(p[1], p[2]));
    if (!(determinant > 0)) return std::nullopt;
    glm::dvec3 s(0);
    glm::dvec3 t(0);
    glm::dvec3 q(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 weight = glm::cross(p[(k + 1) % 3], p[(k + 2) % 3]) / determinant;
        s += triangle[k].texel.x * weight;
        t += triangle[k].texel.y * weight;
        q += weight;
    }
    return Homography{s.x, s.y, s.z, t.x, t.y, t.z, q.x, q.y, q.z};
}

}  // namespace

// The pixels and depths of one area, and the number of triangles drawn there.
struct MeshRaster::Target {
    const PixelArea& area;
    const RayStage& rays;
    HitBlock& hits;
    std::vector<double> inverseDepth;
    std::int64_t triangles = 0;
    int width = 0;
    int firstRow = 0;

    // A quad of the mesh: its position and the heights of its vertices.
    struct Quad {
        const DisplacementMesh& mesh;
        const TexturedQuad& surface;
        std::uint8_t number;
        int i, j;
        DisplacementMesh::Corners heights;
    };

    void draw(const Quad& quad, const Triangle& triangle);
    void drawRow(const Quad& quad, const Homography& rows, glm::dvec2 origin, int y, PixelSpan span);
};

void MeshRaster::Target::draw(const Quad& quad, const Triangle& triangle) {
    const bool near =
        std::any_of(triangle.begin(), triangle.end(), [](const auto& v) { return v.projected.z < kNear; });
    std::array<glm::dvec2, 3> corners;
    std::vector<glm::dvec2> cut;
    std::span<const glm::dvec2> screen;
    if (near) {
        cut = screenPoints(clipToNear(triangle, kNear));
        screen = cut;
    } else {
        for (std::size_t k = 0; k < 3; ++k) corners[k] = triangle[k].screen();
        screen = corners;
    }
    const PixelSpan rows = rowRange(screen, area.y1);
    const int first = static_cast<int>(std::max<std::int64_t>(rows.begin, area.y0));
    if (first >= rows.end) return;
    const glm::dvec2 origin = glm::floor(screen[0]);
    const auto map = rowsOf(triangle, origin);
    if (!map) return;
    ++triangles;
    for (int y = first; y < rows.end; ++y) {
        PixelSpan span = rowSpan(screen, y, area.x1);
        span.begin = std::max<std::int64_t>(span.begin, area.x0);
        if (!span.empty()) drawRow(quad, *map, origin, y, span);
    }
}

void MeshRaster::Target::drawRow(const Quad& quad, const Homography& rows, glm::dvec2 origin, int y, PixelSpan span) {
    const HeightField& texture = quad.mesh.texture();
    const bool bounded = texture.address() == Address::Border;
    const double right = bounded ? std::min(quad.surface.width, texture.width()) : quad.surface.width;
    const double bottom = bounded ? std::min(quad.surface.height, texture.height()) : quad.surface.height;
    const auto inside = [&](double s, double t) { return s >= 0 && s <= right && t >= 0 && t <= bottom; };
    for (auto x = static_cast<int>(span.begin); x < span.end; ++x) {
        const std::size_t pixel =
            static_cast<std::size_t>(y - firstRow) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
        if (rays.polygon[pixel] != quad.number || !inside(rays.rays.s0[pixel], rays.rays.t0[pixel])) continue;
        const TexelPoint at = rows.at(x + 0.5 - origin.x, y + 0.5 - origin.y);
        // Position in the quad, clamped because rounding can move a pixel centre on an edge out of it.
        const double u = std::clamp((at.s - 0.5) / quad.mesh.texelsPerColumn() - quad.i, 0.0, 1.0);
        const double v = std::clamp((at.t - 0.5) / quad.mesh.texelsPerRow() - quad.j, 0.0, 1.0);
        const double s = 0.5 + (quad.i + u) * quad.mesh.texelsPerColumn();
        const double t = 0.5 + (quad.j + v) * quad.mesh.texelsPerRow();
        if (!inside(s, t)) continue;
        ++hits.steps[pixel];
        double& nearest =
            inverseDepth[static_cast<std::size_t>(y - area.y0) * static_cast<std::size_t>(area.x1 - area.x0) +
                         static_cast<std::size_t>(x - area.x0)];
        if (!(at.q > nearest)) continue;
        nearest = at.q;
        hits.set(pixel, {Outcome::Hit, 1 - DisplacementMesh::height(quad.heights, u, v), s, t});
    }
}

MeshRaster::MeshRaster(const DisplacementMesh& mesh, const VisiblePolygons& visible, const PinholeCamera& camera,
                       int width, Work& work)
    : mesh_(mesh), camera_(camera), width_(width) {
    for (const VisiblePolygon& polygon : visible.polygons) {
        // The columns run from the last vertex at or before the polygon's edge to the first at or behind the opposite
        // edge.
        const auto first = [](double each) { return static_cast<int>(std::floor(-0.5 / each)); };
        const auto last = [](double size, double each) { return static_cast<int>(std::ceil((size - 0.5) / each)); };
        Part part{&polygon, first(mesh.texelsPerColumn()), first(mesh.texelsPerRow())};
        part.columns = last(polygon.quad.width, mesh.texelsPerColumn()) - part.firstColumn;
        part.rows = last(polygon.quad.height, mesh.texelsPerRow()) - part.firstRow;
        const double thickness =
            mesh.texture().reliefDepth() * glm::length(polygon.quad.plane.perS) * polygon.quad.width;
        part.slab = -thickness * polygon.quad.normal;
        part.blocksAcross = (part.columns + kBlock - 1) / kBlock;
        part.blocksDown = (part.rows + kBlock - 1) / kBlock;
        part.boxes.resize(static_cast<std::size_t>(part.blocksAcross) * static_cast<std::size_t>(part.blocksDown));
        parallelFor(work, part.blocksDown, [&](int j) {
            for (int i = 0; i < part.blocksAcross; ++i) {
                part.boxes[static_cast<std::size_t>(j * part.blocksAcross + i)] = boxOf(part, i, j);
            }
        });
        parts_.push_back(std::move(part));
    }
}

// Vertex (i, j) of the mesh, for any integers, on this polygon.
ClipVertex MeshRaster::vertex(const Part& part, int i, int j) const {
    const TexturedPlane& plane = part.polygon->quad.plane;
    const glm::dvec2 texel{0.5 + i * mesh_.texelsPerColumn(), 0.5 + j * mesh_.texelsPerRow()};
    const glm::dvec3 down = (1.0 - mesh_.mesh().texel(i, j)) * part.slab;
    return {camera_.project(plane.at(texel.x, texel.y) + down), texel};
}

MeshRaster::Box MeshRaster::boxOf(const Part& part, int blockX, int blockY) const {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Box box{kInfinity, kInfinity, -kInfinity, -kInfinity};
    const int lastX = std::min((blockX + 1) * kBlock, part.columns);
    const int lastY = std::min((blockY + 1) * kBlock, part.rows);
    for (int j = blockY * kBlock; j <= lastY; ++j) {
        for (int i = blockX * kBlock; i <= lastX; ++i) {
            const ClipVertex v = vertex(part, part.firstColumn + i, part.firstRow + j);
            if (v.projected.z < kNear) return {-kInfinity, -kInfinity, kInfinity, kInfinity};
            const glm::vec2 at(v.screen());
            box = {std::min(box.x0, at.x), std::min(box.y0, at.y), std::max(box.x1, at.x), std::max(box.y1, at.y)};
        }
    }
    // One more pixel on every side, because the box is rounded to float.
    return {box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1};
}

void MeshRaster::drawBlock(const Part& part, int blockX, int blockY, Target& target) const {
    const int columns = std::min(kBlock, part.columns - blockX * kBlock);
    const int rows = std::min(kBlock, part.rows - blockY * kBlock);
    const int firstI = part.firstColumn + blockX * kBlock;
    const int firstJ = part.firstRow + blockY * kBlock;
    std::array<ClipVertex, (kBlock + 1) * (kBlock + 1)> vertices;
    const auto at = [&](int i, int j) -> ClipVertex& {
        return vertices[static_cast<std::size_t>(j * (kBlock + 1) + i)];
    };
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) at(i, j) = vertex(part, firstI + i, firstJ + j);
    }
    const HeightField& mesh = mesh_.mesh();
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int qi = firstI + i;
            const int qj = firstJ + j;
            const Target::Quad quad{
                mesh_,
                part.polygon->quad,
                part.polygon->number,
                qi,
                qj,
                {mesh.texel(qi, qj), mesh.texel(qi + 1, qj), mesh.texel(qi, qj + 1), mesh.texel(qi + 1, qj + 1)}};
            target.draw(quad, {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            target.draw(quad, {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
}

std::int64_t MeshRaster::draw(const PixelArea& area, const RayStage& rays, HitBlock& hits, int firstRow) const {
    const auto pixels = static_cast<std::size_t>(area.x1 - area.x0) * static_cast<std::size_t>(area.y1 - area.y0);
    std::array<bool, 256> seen{};
    for (int y = area.y0; y < area.y1; ++y) {
        for (int x = area.x0; x < area.x1; ++x) {
            const std::size_t pixel =
                static_cast<std::size_t>(y - firstRow) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
            seen[rays.polygon[pixel]] = true;
            hits.steps[pixel] = 0;
            if (rays.polygon[pixel] != kNoPolygon) hits.set(pixel, Hit::none(Outcome::Miss));
        }
    }
    Target target{area, rays, hits, std::vector<double>(pixels, 0.0), 0, width_, firstRow};
    for (const Part& part : parts_) {
        if (!seen[part.polygon->number]) continue;
        for (int j = 0; j < part.blocksDown; ++j) {
            for (int i = 0; i < part.blocksAcross; ++i) {
                const Box& box = part.boxes[static_cast<std::size_t>(j * part.blocksAcross + i)];
                const bool apart = box.x1 < static_cast<float>(area.x0) || box.x0 > static_cast<float>(area.x1) ||
                                   box.y1 < static_cast<float>(area.y0) || box.y0 > static_cast<float>(area.y1);
                if (!apart) drawBlock(part, i, j, target);
            }
        }
    }
    return target.triangles;
}

}  // namespace relief
