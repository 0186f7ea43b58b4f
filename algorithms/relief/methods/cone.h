// cone: steps along a conservative cone map. Dummer 2006, made safe for the interpolated surface (Ban et al. 2024).
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: if the ray leaves its cell above the cell's apex A, it cannot hit anything before it meets the cone of slope
// kappa that stands on A: t = t_exit + (z_exit - A) / (|dz| + kappa |dxy|). Below the apex the cell is skipped if the
// ray passes above the cell's highest point (packed layout only), otherwise the leaf tests it.
// Layouts: packed, four square cones per cell, one for each quadrant of directions, where |dxy| is the larger of |dx|
// and |dy| (maps/packed_cones.h; cone_walk.h, SIMD: simd/cone_walk-inl.h); texel, one round cone per cell or one per
// sector, as engines store them (maps/cone_map.h; the walk below, SIMD: simd/texel_cone_lanes-inl.h).
// Guarantee: exact, the same bits as `exact`. Failure mode: needle forests at grazing angles.
// Cost: one or two stored values per step, one leaf per cell near the surface; memory 16 bytes per cell (packed; 24 for
// bilinear surfaces), or 4 (1 + sectors) bytes.
#pragma once

#include <optional>

#include "relief/maps/cone_map.h"
#include "relief/maps/distance_map.h"
#include "relief/methods/cone_rays.h"
#include "relief/methods/cone_walk.h"
#include "relief/methods/lane_fallback.h"
#include "relief/methods/texel_cone_lanes.h"

namespace relief {

class ConeTracer {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "cone";
        method.title = "cone steps, conservative";
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::AnyRays;
        method.help =
            "Steps to the edge of the empty cone that the map stores above each cell. Below the cone's apex the cell "
            "is skipped if the ray stays above it, and tested otherwise.";
        method.source = "Dummer 2006; Ban et al. 2024";
        method.maps = {"cone"};
        return method;
    }
    struct Options {
        std::string layout = "packed";
        int sectors = 1;
        std::string precision = "float";

        // True for the texel layout, which alone has sectors and precisions.
        bool ofTexels() const {
            return layout == kStoredLayout || sectors != 1 || parsePrecision(precision) != Precision::Float;
        }

        static std::vector<OptionField<Options>> fields() {
            return {
                {{std::string(kLayoutOption),
                  OptionKind::Choice,
                  "",
                  0,
                  0,
                  0,
                  {"packed", std::string(kStoredLayout)},
                  "packed: four square cones per cell, compact and fast; texel: one round cone per cell, as game "
                  "engines store them. Using sectors, a precision or a map file selects texel"},
                 &Options::layout},
                {{"sectors",
                  OptionKind::Integer,
                  "sectors",
                  1,
                  8,
                  1,
                  {},
                  "number of azimuth sectors with separate slopes"},
                 &Options::sectors},
                {{"precision", OptionKind::Choice, "", 0, 0, 0, {"float", "u16", "u8"}, "storage format of the cones"},
                 &Options::precision}};
        }
    };
    // The map of the texel layout, which is the one that files store.
    static std::shared_ptr<const ConeMap> makeMap(const HeightField& field, const Options& options, MapCache& cache,
                                                  Work& work) {
        ConeParameters parameters;
        parameters.sectors = options.sectors;
        parameters.precision = parsePrecision(options.precision);
        return relief::coneMap(ConeKind::Conservative, parameters, field, cache, work);
    }
    static ConeTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        if (options.ofTexels()) return {field, makeMap(field, options, cache, work)};
        return {field, packedCones(field, cache, work)};
    }
    ConeTracer(HeightField field, std::shared_ptr<const ConeMap> map)
        : field_(std::move(field)), map_(std::move(map)), grid_(field_) {}
    ConeTracer(HeightField field, std::shared_ptr<const PackedCones> map)
        : field_(std::move(field)), grid_(field_), packed_(std::move(map)) {
        walk_.emplace(field_, *packed_);
    }

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        return walk_ ? walk_->trace(ray, sink) : run<true>(ray, {}, sink);
    }
    template <class Sink>
    Hit traceSegment(const ViewRay& ray, Segment segment, Sink& sink) const {
        return walk_ ? walk_->traceSegment(ray, segment, sink) : run<false>(ray, segment, sink);
    }
    void traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        std::vector<std::size_t> left;
        if (packed_) {
            traceByCones(field_, walk_->scene(), *packed_, rays, first, last, hits, left);
        } else {
            left = coneCellsSimd({field_, grid_, *map_}, rays, first, last, hits);
        }
        NullSink sink;
        for (const std::size_t i : left) hits.set(i, trace(rays[i], sink));
    }
    // The SIMD version of traceSegment() for blocks. Returns the indices of rays that traceSegment() has to trace.
    std::vector<std::size_t> traceSegmentsSimd(const RayBlock& rays, const std::vector<Segment>& segments,
                                               HitBlock& hits) const {
        if (packed_ || !hasSimdMap()) return allRays(0, rays.size());
        return coneCellsSimd({field_, grid_, *map_}, rays, 0, rays.size(), hits, segments.data());
    }
    static bool segmentsInSimd(const Options& options) { return options.ofTexels(); }

    const HeightField& field() const { return field_; }
    // Null for the packed layout.
    const std::shared_ptr<const ConeMap>& coneMap() const { return map_; }
    bool hasSimdMap() const { return packed_ || fitsLanes(map_->slopes); }
    std::size_t bytes() const { return packed_ ? packed_->bytes() : map_->bytes(); }
    // With packed cones, float and double may each walk through every cell once (cone_walk.h, AmbiguousPart).
    double stepBound(const ViewRay& ray) const { return (packed_ ? 2 : 1) * GridRay(grid_, ray).cellBound() + 6; }
    double segmentRecords() const { return 3; }

  private:
    template <bool kWhole, class Sink>
    Hit run(const ViewRay& viewRay, Segment segment, Sink& sink) const;

    HeightField field_;
    std::shared_ptr<const ConeMap> map_;
    CellGrid grid_;
    std::shared_ptr<const PackedCones> packed_;
    std::optional<ConeWalk> walk_;
};

// The walk through the texel layout.
template <bool kWhole, class Sink>
Hit ConeTracer::run(const ViewRay& viewRay, Segment segment, Sink& sink) const {
    if (!viewRay.finite()) return Hit::none(Outcome::Miss);
    const GridRay ray(grid_, viewRay);
    const double runLength = std::hypot(ray.x.run, ray.y.run);
    const int sector = azimuthSector(ray.x.run, ray.y.run, map_->parameters.sectors);
    const double end = std::min(segment.out, ray.end(grid_));
    AxisCell cx = ray.x.cellAt(grid_.x, segment.in);
    AxisCell cy = ray.y.cellAt(grid_.y, segment.in);
    // The cell's cone, which stands below the point at which the ray leaves the cell.
    const auto cone = [&](double out, double apex, double slope) {
        const double s = ray.x.start + out * ray.x.run - grid_.x.shift;
        const double t = ray.y.start + out * ray.y.run - grid_.y.shift;
        return subject::Cone{s, t, apex, slope, sector, map_->parameters.sectors, true};
    };
    const auto note = [&](Decision decision, double in, double out, double value, double after) {
        return [&, decision, in, out, value, after] {
            return cellRecord(field_, grid_, cx, cy, decision, in, out, value, after);
        };
    };
    const auto noteCone = [&](Decision decision, double in, double out, double apex, double slope, double after) {
        return [&, decision, in, out, apex, slope, after] {
            const double value = decision == Decision::Advance ? slope : apex;
            Step step = cellRecord(field_, grid_, cx, cy, decision, in, out, value, after);
            step.subject = cone(out, apex, slope);
            return step;
        };
    };
    if constexpr (kWhole) {
        sink.step(note(Decision::Start, 0, 0, 1, 0));
        if (ray.entersOutside(grid_)) {
            sink.step(note(Decision::Miss, 0, 0, 0, 0));
            return Hit::none(Outcome::Miss);
        }
    }
    double lambda = segment.in;
    for (double left = ray.cellBound() + 2; left > 0; --left) {
        cx = ray.x.cellAt(grid_.x, lambda);
        cy = ray.y.cellAt(grid_.y, lambda);
        const double out = std::max(cellInterval(grid_, ray, cx, cy).out, lambda);
        const double apex = static_cast<double>(map_->apex(cx.index, cy.index, 0));
        double after = out;
        sink.read(1);
        if (1 - out > apex) {
            const double kappa = static_cast<double>(map_->slopes(cx.index, cy.index, sector));
            sink.read(1);
            const double free = (1 - out - apex) / (1 + kappa * runLength) * kShorterShare;
            after = out + std::max(0.0, free - kExclusionMargin);
            sink.step(noteCone(Decision::Advance, lambda, out, apex, kappa, std::min(after, segment.out)));
        } else {
            sink.read(leafReads(field_.surface()));
            const auto hit = leafHit(field_, grid_, ray, cx, cy);
            if (hit) {
                sink.step(noteCone(Decision::Hit, lambda, out, apex, 0, *hit));
                return Hit::at(viewRay, *hit);
            }
            sink.step(noteCone(Decision::Test, lambda, out, apex, 0, out));
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
