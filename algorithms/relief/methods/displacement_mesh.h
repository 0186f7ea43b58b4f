// The mesh of displacement mapping, shared by the walk of a single ray and the rasteriser of whole frames.
//
// Vertices: `density` per side of the texture, the first at the centre of the first texel, with the height of the
// surface there (maps/mesh_heights.h). So with density = the map's size the vertices are the map's texels, and with
// multiples of it the texels are among the vertices. Quads lie between four neighbouring vertices and are numbered as
// the cells of a bilinear surface of that size (cell_grid.h): under repeat they wrap; under clamp and border the mesh
// is level outside the outermost vertices; under border there is no mesh outside the picture.
// Each quad is two triangles, split along the diagonal from its vertex (0, 0) to its vertex (1, 1).
// Unit of its ViewRays: mesh coordinates, vertex (i, j) at (i + 1/2, j + 1/2).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "relief/leaf.h"
#include "relief/maps/mesh_heights.h"
#include "relief/step_log.h"

namespace relief {

class DisplacementMesh {
  public:
    DisplacementMesh(const HeightField& field, std::shared_ptr<const MeshHeights> heights)
        : texture_(field),
          mesh_(std::shared_ptr<const FloatImage>(heights, &heights->heights), Surface::Bilinear, field.address(),
                field.reliefDepth()),
          grid_(mesh_),
          density_(heights->density),
          bytes_(heights->bytes()) {
        if (field.address() != Address::Border) return;
        grid_.x.low = meshPlace(0, texelsPerColumn()) + grid_.x.shift;
        grid_.x.high = meshPlace(texture_.width(), texelsPerColumn()) + grid_.x.shift;
        grid_.y.low = meshPlace(0, texelsPerRow()) + grid_.y.shift;
        grid_.y.high = meshPlace(texture_.height(), texelsPerRow()) + grid_.y.shift;
    }

    const HeightField& texture() const { return texture_; }
    // The heights of the vertices as a bilinear surface, whose cells are the quads.
    const HeightField& mesh() const { return mesh_; }
    const CellGrid& grid() const { return grid_; }
    std::size_t bytes() const { return bytes_; }
    // Size of a quad in texels.
    double texelsPerColumn() const { return static_cast<double>(texture_.width()) / density_; }
    double texelsPerRow() const { return static_cast<double>(texture_.height()) / density_; }
    // Conversion between texels and mesh coordinates on one axis. each: texels per quad.
    static double meshPlace(double texel, double each) { return (texel - 0.5) / each + 0.5; }
    static double texelPlace(double place, double each) { return (place - 0.5) * each + 0.5; }

    // The ray in mesh coordinates; under repeat its origin is reduced to the first period, so that distant rays keep
    // their precision.
    ViewRay inMesh(const ViewRay& ray) const {
        const auto reduced = [&](double x, double size) {
            if (texture_.address() != Address::Repeat) return x;
            const double rest = std::fmod(x, size);
            return rest < 0 ? rest + size : rest;
        };
        return {meshPlace(reduced(ray.s0, texture_.width()), texelsPerColumn()),
                meshPlace(reduced(ray.t0, texture_.height()), texelsPerRow()), ray.a / texelsPerColumn(),
                ray.b / texelsPerRow()};
    }

    // The quad as subject of a log record. The area beyond the outermost vertices counts as one more quad.
    subject::Quad quad(AxisCell cx, AxisCell cy, double highest) const {
        return {texelPlace(quadBegin(grid_.x, cx) - grid_.x.shift, texelsPerColumn()),
                texelPlace(quadBegin(grid_.y, cy) - grid_.y.shift, texelsPerRow()), texelsPerColumn(), texelsPerRow(),
                highest};
    }
    // Heights of a quad's vertices (0,0), (1,0), (0,1), (1,1).
    using Corners = std::array<double, 4>;
    Corners corners(AxisCell cx, AxisCell cy) const { return cellCorners(mesh_.heights(), grid_, cx.index, cy.index); }

    // Height of the two triangles at (u, v) in the quad, both in [0, 1]. Rounding cannot make it negative.
    static double height(const Corners& h, double u, double v) {
        const double z =
            u >= v ? h[0] + u * (h[1] - h[0]) + v * (h[3] - h[1]) : h[0] + v * (h[2] - h[0]) + u * (h[3] - h[2]);
        return std::max(z, 0.0);
    }

    // Lambda at which the ray first hits the quad's triangles, or std::nullopt.
    std::optional<double> quadHit(const GridRay& ray, AxisCell cx, AxisCell cy) const;

  private:
    static double quadBegin(const GridAxis& axis, AxisCell cell) {
        const double begin = axis.edge(cell.index, cell.base);
        return std::isfinite(begin) ? begin : axis.edge(1, cell.base) - 1;
    }
    HeightField texture_;
    HeightField mesh_;
    CellGrid grid_;
    int density_;
    std::size_t bytes_;
};

inline std::optional<double> DisplacementMesh::quadHit(const GridRay& ray, AxisCell cx, AxisCell cy) const {
    const CellInterval interval = cellInterval(grid_, ray, cx, cy);
    if (!(interval.in < interval.out)) return std::nullopt;
    const Corners h = corners(cx, cy);
    struct Place {
        double lambda, u, v, gap;  // gap: surface minus ray
    };
    const auto placeAt = [&](double lambda) {
        const double u = leaf_detail::within(ray.x, cx, lambda);
        const double v = leaf_detail::within(ray.y, cy, lambda);
        return Place{lambda, u, v, height(h, u, v) - (1 - lambda)};
    };
    // The first hit between two points within one triangle, where the gap is linear; `from` is above the surface.
    const auto between = [](const Place& from, const Place& to) -> std::optional<double> {
        if (!(to.gap >= 0)) return std::nullopt;
        const double share = from.gap / (from.gap - to.gap);
        return std::min(from.lambda + share * (to.lambda - from.lambda), to.lambda);
    };
    const Place in = placeAt(interval.in);
    if (!(in.gap < 0)) return interval.in;
    const Place out = placeAt(interval.out);
    const double before = in.u - in.v;
    const double after = out.u - out.v;
    if ((before < 0) == (after < 0)) return between(in, out);
    const Place diagonal = placeAt(interval.in + before / (before - after) * (interval.out - interval.in));
    if (const auto hit = between(in, diagonal)) return hit;
    return between(diagonal, out);
}

}  // namespace relief
