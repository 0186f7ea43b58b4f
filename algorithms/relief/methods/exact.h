// exact: visits every cell in order, with an exact intersection. The ground truth of all tests.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Guarantee: the first hit, to the rounding of the leaf (double). Failure mode: none within the domain; slow.
// Cost: one leaf per cell crossed, at most |a| + |b| + 2 of them.
// Source: Amanatides & Woo 1987 for the walk.
#pragma once

#include "relief/cell_record.h"
#include "relief/describe.h"
#include "relief/map_cache.h"

namespace relief {

class ExactTracer {
  public:
    static std::string formNote() { return "It is the reference to which all exact methods are compared."; }
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "exact";
        method.title = "every cell";
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::ViewRays;
        method.help = "Tests every cell that the ray crosses, in order; the reference for all other methods.";
        method.source = "Amanatides & Woo 1987";
        method.maps = {};
        method.tiled = true;
        return method;
    }
    struct Options {
        static std::vector<OptionField<Options>> fields() { return {}; }
    };
    static ExactTracer make(const HeightField& field, const Options&, MapCache&, Work&) { return ExactTracer(field); }

    explicit ExactTracer(HeightField field) : field_(std::move(field)), grid_(field_) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        return walkOf<true>(ray, {}, sink);
    }
    // Visits the cells of a segment that begins and ends on their borders.
    template <class Sink>
    Hit traceSegment(const ViewRay& ray, Segment segment, Sink& sink) const {
        return walkOf<false>(ray, segment, sink);
    }
    double segmentRecords() const { return 3; }

    const HeightField& field() const { return field_; }
    std::size_t bytes() const { return 0; }
    // Upper bound of the number of records; stress tests assert it.
    double stepBound(const ViewRay& ray) const { return GridRay(grid_, ray).cellBound() + 3; }

  private:
    // kWhole: traces the whole ray, with records of its start and of a miss.
    template <bool kWhole, class Sink>
    Hit walkOf(const ViewRay& ray, Segment segment, Sink& sink) const {
        return withHeights(field_, [&](const auto& heights) {
            return field_.surface() == Surface::Bilinear ? walk<Surface::Bilinear, kWhole>(heights, ray, segment, sink)
                                                         : walk<Surface::Columns, kWhole>(heights, ray, segment, sink);
        });
    }
    template <Surface kSurface, bool kWhole, class Heights, class Sink>
    Hit walk(const Heights& heights, const ViewRay& viewRay, Segment segment, Sink& sink) const;

    HeightField field_;
    CellGrid grid_;
};

template <Surface kSurface, bool kWhole, class Heights, class Sink>
Hit ExactTracer::walk(const Heights& heights, const ViewRay& viewRay, Segment segment, Sink& sink) const {
    if (!viewRay.finite()) return Hit::none(Outcome::Miss);
    const GridRay ray(grid_, viewRay);
    AxisCell cx = ray.x.cellAt(grid_.x, segment.in);
    AxisCell cy = ray.y.cellAt(grid_.y, segment.in);
    const auto record = [&](Decision decision, double in, double out, double after) {
        return [&, decision, in, out, after] {
            const double maximum = cellMaximum<kSurface>(heights, grid_, cx.index, cy.index);
            return cellRecord(field_, grid_, cx, cy, decision, in, out, maximum, after);
        };
    };
    if constexpr (kWhole) {
        sink.step(record(Decision::Start, 0, 0, 0));
        if (ray.entersOutside(grid_)) {
            sink.step(record(Decision::Miss, 0, 0, 0));
            return Hit::none(Outcome::Miss);
        }
    }
    double lambda = segment.in;
    for (double left = ray.cellBound(); left > 0; --left) {
        const double outX = ray.x.leave(grid_.x, cx.index, cx.index + 1, cx.base);
        const double outY = ray.y.leave(grid_.y, cy.index, cy.index + 1, cy.base);
        const double out = std::min(outX, outY);
        sink.read(leafReads(kSurface));
        if (const auto hit = leafHit<kSurface>(heights, grid_, ray, cx, cy)) {
            sink.step(record(Decision::Hit, lambda, std::min(out, 1.0), *hit));
            return Hit::at(viewRay, *hit);
        }
        sink.step(record(Decision::Test, lambda, std::min(out, 1.0), std::min(out, 1.0)));
        lambda = out;
        const AxisCell lastX = cx;
        const AxisCell lastY = cy;
        bool inside = out < segment.out;
        if (inside && outX <= outY) inside = stepCell(grid_.x, ray.x.side, cx);
        if (inside && outY <= outX) inside = stepCell(grid_.y, ray.y.side, cy);
        if (!inside) {
            cx = lastX;
            cy = lastY;
            const double end = std::min(out, 1.0);
            if constexpr (kWhole) sink.step(record(Decision::Miss, end, end, end));
            return Hit::none(Outcome::Miss);
        }
    }
    sink.step(record(Decision::Limit, lambda, lambda, lambda));
    return Hit::none(Outcome::Limit);
}

}  // namespace relief
