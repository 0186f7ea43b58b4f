// displacement: the relief as a triangle mesh, as graphics cards tessellate it. Cook 1984.
//
// Frame and units: ray.h. Surfaces: bilinear, columns (whose walls become slopes one quad wide); any addressing.
// Model: a regular mesh of `density` quads along each side of the texture (displacement_mesh.h defines vertices and
// diagonal). There are two implementations, which the tests compare:
// - for a single ray (here), a walk over the quads that it crosses, two triangles each;
// - for a frame, rasterisation of the projected mesh with a depth buffer (rendering/mesh_raster.h), which traces no
// ray.
// The two differ in one respect: a rasterised polygon shows one texture, [0, W] x [0, H], and there is nothing where a
// view ray leaves it within the slab, whereas a traced ray continues into the repeated or clamped picture. Under border
// they agree.
// Guarantee: none. Failure mode: details smaller than a quad. Cost: four stored heights per quad crossed.
#pragma once

#include "relief/describe.h"
#include "relief/methods/displacement_mesh.h"
#include "relief/sampled_surface.h"

namespace relief {

class DisplacementTracer {
  public:
    struct Options {
        int density = 256;

        static std::vector<OptionField<Options>> fields() {
            return {{{"density",
                      OptionKind::Integer,
                      "quads",
                      1,
                      8192,
                      1,
                      {},
                      "number of quads along each side of the texture"},
                     &Options::density}};
        }
    };
    static std::string formNote() { return "Triangles are drawn instead of rays being traced."; }
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "displacement";
        method.title = "displacement mapping";
        method.help = "A triangle mesh whose vertices lie at the heights; frames rasterise it with a depth buffer.";
        method.source = "Cook 1984";
        method.kind = MethodKind::Mesh;
        method.guarantee = Guarantee::Approximate;
        method.maps = {"mesh"};
        return method;
    }
    static DisplacementTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        return {field, meshHeights(field, options.density, cache, work)};
    }

    DisplacementTracer(HeightField field, const std::shared_ptr<const MeshHeights>& heights)
        : field_(std::move(field)), mesh_(field_, heights) {}

    template <class Sink>
    Hit trace(const ViewRay& viewRay, Sink& sink) const;

    const HeightField& field() const { return field_; }
    const DisplacementMesh* mesh() const { return &mesh_; }
    std::size_t bytes() const { return mesh_.bytes(); }
    double stepBound(const ViewRay& ray) const { return GridRay(mesh_.grid(), mesh_.inMesh(ray)).cellBound() + 3; }

  private:
    HeightField field_;
    DisplacementMesh mesh_;
};

template <class Sink>
Hit DisplacementTracer::trace(const ViewRay& viewRay, Sink& sink) const {
    if (!viewRay.finite()) return Hit::none(Outcome::Miss);
    const CellGrid& grid = mesh_.grid();
    const GridRay ray(grid, mesh_.inMesh(viewRay));
    const SampledSurface surface(field_, viewRay);
    AxisCell cx = ray.x.startCell(grid.x);
    AxisCell cy = ray.y.startCell(grid.y);
    const auto record = [&](Decision decision, double in, double out, double after) {
        sink.step([&] {
            const auto h = mesh_.corners(cx, cy);
            const double highest = std::max({h[0], h[1], h[2], h[3]});
            const Phase phase = decision == Decision::Start ? Phase::Start : Phase::Search;
            Step step = surface.record(phase, decision, in, out, highest, after);
            step.subject = mesh_.quad(cx, cy, highest);
            return step;
        });
    };
    record(Decision::Start, 0, 0, 0);
    if (ray.entersOutside(grid)) {
        record(Decision::Miss, 0, 0, 0);
        return Hit::none(Outcome::Miss);
    }
    double lambda = 0;
    for (double left = ray.cellBound(); left > 0; --left) {
        const double outX = ray.x.leave(grid.x, cx.index, cx.index + 1, cx.base);
        const double outY = ray.y.leave(grid.y, cy.index, cy.index + 1, cy.base);
        const double out = std::min(outX, outY);
        sink.read(4);
        if (const auto hit = mesh_.quadHit(ray, cx, cy)) {
            record(Decision::Hit, lambda, std::min(out, 1.0), *hit);
            return Hit::at(viewRay, *hit);
        }
        record(Decision::Test, lambda, std::min(out, 1.0), std::min(out, 1.0));
        lambda = out;
        bool inside = out < 1;
        if (inside && outX <= outY) inside = stepCell(grid.x, ray.x.side, cx);
        if (inside && outY <= outX) inside = stepCell(grid.y, ray.y.side, cy);
        if (!inside) {
            lambda = std::min(out, 1.0);
            record(Decision::Miss, lambda, lambda, lambda);
            return Hit::none(Outcome::Miss);
        }
    }
    record(Decision::Limit, lambda, lambda, lambda);
    return Hit::none(Outcome::Limit);
}

}  // namespace relief
