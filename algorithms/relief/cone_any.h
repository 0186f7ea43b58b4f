// cone-any: is anything in the way of a segment? By the conservative cone map.
//
// Frame and units: any_ray.h. Surfaces: bilinear, columns; any addressing. Guarantee: exact.
#pragma once

#include "relief/cone.h"
#include "relief/jump_any.h"

namespace relief {

class ConeAnyHit {
  public:
    static constexpr RayClass kRays = RayClass::AnyRays;
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "cone-any";
        method.title = "the conservative cone map, any hit";
        method.kind = MethodKind::AnyHit;
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::AnyRays;
        method.help =
            "Jumps to the edge of the cone that the map promises to be empty above each cell; looks at the cells in "
            "which the "
            "segment is below the apex.";
        method.source = "Dummer 2006; Ban et al. 2024";
        method.maps = {"cone"};
        return method;
    }
    using Options = ConeTracer::Options;
    static ConeAnyHit make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        return {field, ConeTracer::makeMap(field, options, cache, work)};
    }
    ConeAnyHit(HeightField field, std::shared_ptr<const ConeMap> map)
        : field_(std::move(field)), map_(std::move(map)), grid_(field_) {}

    template <class Sink>
    Sight look(const AnyRay& ray, Sink& sink) const {
        const double run = std::hypot(ray.ds, ray.dt);
        const int sector = azimuthSector(ray.ds, ray.dt, map_->parameters.sectors);
        return lookByJumps(field_, grid_, ray, 1, stepBound(ray), sink,
                           [&](const AnyRay& segment, const GridRay&, AxisCell cx, AxisCell cy, double mu, double out) {
                               const double apex = static_cast<double>(map_->apex(cx.index, cy.index, 0));
                               const double zOut = segment.heightAt(out);
                               if (!(std::min(segment.heightAt(mu), zOut) > apex)) return mu;
                               const double kappa = static_cast<double>(map_->slopes(cx.index, cy.index, sector));
                               const double closing = kappa * run - segment.dz;
                               if (closing <= 0) return 2.0;  // it rises faster than the cone
                               return std::max(out, mu) + (zOut - apex) / closing * (1 - 1e-9);
                           });
    }

    const HeightField& field() const { return field_; }
    std::size_t bytes() const { return map_->bytes(); }
    double stepBound(const AnyRay& ray) const { return 2 * GridRay(grid_, ray.course()).cellBound() + 6; }

  private:
    HeightField field_;
    std::shared_ptr<const ConeMap> map_;
    CellGrid grid_;
};

}  // namespace relief
