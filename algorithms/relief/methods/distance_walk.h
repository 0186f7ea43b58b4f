// What both conservative distance tracers share: the walk by the rule "exit + D", or by the classic rule "t + D".
//
// Frame and units: ray.h; those of the map: distance_map.h.
// Exit: in a free voxel the ray advances to where it leaves the voxel, and from there by the voxel's distance, which
// holds for every point of the box including the exit. In a surface voxel the leaf tests the cell, and the ray advances
// to the next cell. There is no interpolation, no over-relaxation and no epsilon to stop at. A ray flatter than those
// that the map serves treats every voxel as a surface voxel.
// Classic: the ray advances from its position by the distance, as in sphere tracing. Steps become very short near the
// surface: where a step would be shorter than kShortestClassic, the cell is tested as in a surface voxel.
#pragma once

#include <optional>

#include "relief/cell_record.h"
#include "relief/maps/distance_map.h"
#include "relief/methods/distance_walk_lanes.h"
#include "relief/ray_length.h"

namespace relief {

// Exit: leave the voxel, then advance by its distance. Classic: advance by the distance from the current point.
enum class StepRule : std::uint8_t { Exit, Classic };

class DistanceWalk {
  public:
    static constexpr double kShortestClassic = 1.0 / 64;  // texels

    DistanceWalk(HeightField field, std::shared_ptr<const DistanceMap> map, StepRule rule = StepRule::Exit)
        : field_(std::move(field)), map_(std::move(map)), grid_(field_), rule_(rule) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        return run<true>(ray, {}, sink);
    }
    template <class Sink>
    Hit traceSegment(const ViewRay& ray, Segment segment, Sink& sink) const {
        return run<false>(ray, segment, sink);
    }
    // The SIMD version, with the same results: sets hits for the rays first to last - 1.
    void traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        NullSink sink;
        for (const std::size_t i : walkSimd(*this, rays, first, last, hits)) hits.set(i, trace(rays[i], sink));
    }

    // The SIMD version of traceSegment() for blocks. Returns the indices of rays that traceSegment() has to trace.
    std::vector<std::size_t> traceSegmentsSimd(const RayBlock& rays, const std::vector<Segment>& segments,
                                               HitBlock& hits) const {
        return walkSimd(*this, rays, 0, rays.size(), hits, segments.data());
    }

    const HeightField& field() const { return field_; }
    const std::shared_ptr<const DistanceMap>& distanceMap() const { return map_; }
    const CellGrid& grid() const { return grid_; }
    StepRule rule() const { return rule_; }
    std::size_t bytes() const { return map_->bytes(); }
    // Upper bound of the number of records: a step leaves a cell, or a voxel through its side or its floor.
    double stepBound(const ViewRay& ray) const { return records(GridRay(grid_, ray)) + 3; }
    double segmentRecords() const { return 3; }

    // Returns true if the map is valid for the ray.
    bool serves(const GridRay& ray) const { return std::hypot(ray.x.run, ray.y.run) <= map_->maxRun && ray.inDomain(); }
    // Texels of the map's metric per unit of lambda.
    double perLambda(const GridRay& ray) const { return texelsPerLambda(ray.x.run, ray.y.run, map_->slabTexels); }
    // Number of steps after which the walk ends with Outcome::Limit.
    double records(const GridRay& ray) const {
        const double walked = 2 * ray.cellBound() + map_->layers() + 4;
        // Half of the shortest distance: the exclusion margin subtracts less than the other half.
        return rule_ == StepRule::Exit || !ray.inDomain() ? walked : walked + 2 * perLambda(ray) / kShortestClassic;
    }

  private:
    struct Voxel {
        int bx;
        int by;
        int layer;
    };
    Voxel voxelAt(AxisCell cx, AxisCell cy, double lambda) const {
        const int f = map_->parameters.footprint;
        // On the floor of a layer the descending ray is in the layer below. The comparison uses the lambda that
        // leaveVoxel() returns; otherwise the ray could stop there where the distance is 0.
        const double guess = std::ceil((1 - lambda) * map_->layers()) - 1;
        int layer = static_cast<int>(std::clamp(guess, 0.0, map_->layers() - 1.0));
        if (layer > 0 && floorOf(layer) <= lambda) --layer;
        return {cx.index / f, cy.index / f, layer};
    }
    // Lambda at the floor of a layer.
    double floorOf(int layer) const { return 1 - static_cast<double>(layer) / map_->layers(); }

    double leaveVoxel(const GridRay& ray, const Voxel& voxel, AxisCell cx, AxisCell cy) const {
        const int f = map_->parameters.footprint;
        const double x = ray.x.leave(grid_.x, voxel.bx * f, std::min((voxel.bx + 1) * f, grid_.x.cells), cx.base);
        const double y = ray.y.leave(grid_.y, voxel.by * f, std::min((voxel.by + 1) * f, grid_.y.cells), cy.base);
        return std::min({x, y, floorOf(voxel.layer)});
    }

    Step record(Decision decision, const Voxel& voxel, AxisCell cx, AxisCell cy, double in, double out, double value,
                double after) const {
        Step step = cellRecord(field_, grid_, cx, cy, decision, in, out, value, after);
        step.k = voxel.layer;
        if (!step.tests() && decision != Decision::Advance) return step;
        step.subject = subject::Voxel{voxel.bx,       voxel.by, voxel.layer,    map_->parameters.footprint,
                                      map_->layers(), value,    map_->refined()};
        if (!step.tests()) step.i = voxel.bx, step.j = voxel.by;
        return step;
    }

    template <bool kWhole, class Sink>
    Hit run(const ViewRay& viewRay, Segment segment, Sink& sink) const;

    HeightField field_;
    std::shared_ptr<const DistanceMap> map_;
    CellGrid grid_;
    StepRule rule_;
};

template <bool kWhole, class Sink>
Hit DistanceWalk::run(const ViewRay& viewRay, Segment segment, Sink& sink) const {
    if (!viewRay.finite()) return Hit::none(Outcome::Miss);
    const GridRay ray(grid_, viewRay);
    const bool served = serves(ray);
    const double metric = perLambda(ray);
    const double nearest = rule_ == StepRule::Classic ? kShortestClassic : 0;
    const int sector = azimuthSector(ray.x.run, ray.y.run, map_->parameters.sectors);
    const double end = std::min(segment.out, ray.end(grid_));
    AxisCell cx = ray.x.cellAt(grid_.x, segment.in);
    AxisCell cy = ray.y.cellAt(grid_.y, segment.in);
    Voxel voxel = voxelAt(cx, cy, segment.in);
    const auto note = [&](Decision decision, double in, double out, double value, double after) {
        return [&, decision, in, out, value, after] { return record(decision, voxel, cx, cy, in, out, value, after); };
    };
    if constexpr (kWhole) {
        sink.step(note(Decision::Start, 0, 0, 1, 0));
        if (ray.entersOutside(grid_)) {
            sink.step(note(Decision::Miss, 0, 0, 0, 0));
            return Hit::none(Outcome::Miss);
        }
    }
    double lambda = segment.in;
    for (double left = records(ray); left > 0; --left) {
        cx = ray.x.cellAt(grid_.x, lambda);
        cy = ray.y.cellAt(grid_.y, lambda);
        voxel = voxelAt(cx, cy, lambda);
        const double distance =
            served ? static_cast<double>(map_->at(voxel.bx, voxel.by, voxel.layer, sector)) : StoredValues::kSurface;
        sink.read(1);
        double after = 0;
        if (distance < nearest) {
            after = std::max(cellInterval(grid_, ray, cx, cy).out, lambda);
            sink.read(leafReads(field_.surface()));
            if (const auto hit = leafHit(field_, grid_, ray, cx, cy)) {
                sink.step(note(Decision::Hit, lambda, after, distance, *hit));
                return Hit::at(viewRay, *hit);
            }
            sink.step(note(Decision::Test, lambda, after, distance, after));
        } else {
            const double out = rule_ == StepRule::Classic ? lambda : std::max(leaveVoxel(ray, voxel, cx, cy), lambda);
            // The exclusion margin covers hits that are within the rounding of the leaf.
            after = out + std::max(0.0, distance / metric - kExclusionMargin);
            sink.step(note(Decision::Advance, lambda, out, distance, std::min(after, segment.out)));
        }
        lambda = after;
        if (!(lambda < end)) {
            lambda = std::min(lambda, 1.0);
            if constexpr (kWhole) sink.step(note(Decision::Miss, lambda, lambda, 0, lambda));
            return Hit::none(Outcome::Miss);
        }
    }
    sink.step(note(Decision::Limit, lambda, lambda, 0, lambda));
    return Hit::none(Outcome::Limit);
}

}  // namespace relief
