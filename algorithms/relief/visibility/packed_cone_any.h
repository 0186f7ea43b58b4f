// packed-cone-any: is anything in the way of a segment? By the packed cones of its quadrant.
//
// Frame and units: any_ray.h. Surfaces: bilinear, columns; any addressing. Guarantee: exact.
// Model: a cell is looked at only if the segment falls below its highest point there; from where the segment leaves a
// cell above the apex it is free up to where it meets the cone, for ever if it rises faster.
// Cost: one word a step; rising segments (shadows, footprints) take a few. Memory 16 bytes a cell.
#pragma once

#include "relief/cell_record.h"
#include "relief/maps/packed_cones.h"
#include "relief/visibility/any_leaf.h"

namespace relief {

class PackedConeAnyHit {
  public:
    static constexpr RayClass kRays = PackedCones::kRays;
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "packed-cone-any";
        method.title = "packed cones, any hit";
        method.kind = MethodKind::AnyHit;
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::AnyRays;
        method.help =
            "Jumps to the edge of the cone that the map promises to be empty above each cell, one of four for the "
            "segment's quadrant.";
        method.source = "Dummer 2006; Ban et al. 2024";
        method.maps = {"packed-cones"};
        return method;
    }
    struct Options {
        static std::vector<OptionField<Options>> fields() { return {}; }
    };
    static PackedConeAnyHit make(const HeightField& field, const Options&, MapCache& cache, Work& work) {
        return {field, packedCones(field, cache, work)};
    }
    PackedConeAnyHit(HeightField field, std::shared_ptr<const PackedCones> map)
        : field_(std::move(field)), map_(std::move(map)), grid_(field_) {}

    template <class Sink>
    Sight look(const AnyRay& ray, Sink& sink) const;
    // The same answers in lanes (packed_cone_any_lanes-inl.h): segments first to last - 1.
    void lookLanes(const AnyRayBlock& rays, std::size_t first, std::size_t last, SightBlock& sights) const;

    const HeightField& field() const { return field_; }
    const CellGrid& grid() const { return grid_; }
    const PackedCones& map() const { return *map_; }
    double stepBound(const AnyRay& ray) const { return 2 * GridRay(grid_, ray.course()).cellBound() + 6; }

  private:
    double freeUpTo(const AnyRay& ray, const GridRay& course, AxisCell cx, AxisCell cy, double mu, double out) const;

    HeightField field_;
    std::shared_ptr<const PackedCones> map_;
    CellGrid grid_;
};

// Up to which mu the segment is free, given that it is in that cell at mu and leaves it at out; mu itself: the cell
// must be looked at.
inline double PackedConeAnyHit::freeUpTo(const AnyRay& ray, const GridRay& course, AxisCell cx, AxisCell cy, double mu,
                                         double out) const {
    const std::uint32_t word = map_->quadrant(quadrantOf(course))[map_->index(cx.index, cy.index)];
    const double zOut = ray.heightAt(out);
    if (!(std::min(ray.heightAt(mu), zOut) > map_->heightAt(coneOwnDepth(word)))) return mu;
    const double room = zOut - map_->heightAt(coneApexDepth(word));
    if (!(room > 0)) return out;
    const double run = std::max(std::abs(course.x.run), std::abs(course.y.run));
    const double closing = static_cast<double>(coneSlope(word)) * run - ray.dz;
    if (closing <= 0) return 2;  // it rises faster than the cone
    return out + room / closing * kShorterShare;
}

template <class Sink>
Sight PackedConeAnyHit::look(const AnyRay& ray, Sink& sink) const {
    if (!ray.finite()) return Sight::Clear;
    const GridRay course(grid_, ray.course());
    const double end = endBelow(ray, map_->highest);
    AxisCell cx = course.x.startCell(grid_.x);
    AxisCell cy = course.y.startCell(grid_.y);
    const auto note = [&](Decision decision, double in, double out) {
        return [&, decision, in, out] {
            const double lambdaOut = 1 - ray.heightAt(out);
            return cellRecord(field_, grid_, cx, cy, decision, 1 - ray.heightAt(in), lambdaOut, 0, lambdaOut);
        };
    };
    sink.step(note(Decision::Start, 0, 0));
    if (!(end > 0) || runsOutside(grid_, course)) {
        sink.step(note(Decision::Miss, 0, 0));
        return Sight::Clear;
    }
    double mu = 0;
    // Two records besides: the start and the end.
    for (double left = stepBound(ray) - 2; left > 0; --left) {
        cx = course.x.cellAt(grid_.x, mu);
        cy = course.y.cellAt(grid_.y, mu);
        const Stay stay = cellStay(grid_, course, cx, cy);
        const double leave = std::min(course.x.leave(grid_.x, cx.index, cx.index + 1, cx.base),
                                      course.y.leave(grid_.y, cy.index, cy.index + 1, cy.base));
        const double out = std::clamp(stay.out, mu, end);
        const double jump = freeUpTo(ray, course, cx, cy, mu, out);
        sink.read(1);
        if (jump > mu) {
            sink.step(note(Decision::Advance, mu, std::min(jump, end)));
            mu = jump;
        } else {
            sink.read(leafReads(field_.surface()));
            if (cellBlocks(field_, grid_, ray, course, cx, cy, end)) {
                sink.step(note(Decision::Hit, mu, out));
                return Sight::Blocked;
            }
            sink.step(note(Decision::Test, mu, out));
            mu = std::max(leave, mu);
        }
        const bool leaves = grid_.bounded && (course.x.leave(grid_.x, 0, grid_.x.cells, 0) <= mu ||
                                              course.y.leave(grid_.y, 0, grid_.y.cells, 0) <= mu);
        if (mu >= end || leaves) {
            sink.step(note(Decision::Miss, std::min(mu, end), std::min(mu, end)));
            return Sight::Clear;
        }
    }
    sink.step(note(Decision::Limit, mu, mu));
    return Sight::Limit;
}

}  // namespace relief
