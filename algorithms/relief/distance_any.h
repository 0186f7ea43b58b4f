// distance-any: is anything in the way of a segment? By the conservative distance map.
//
// Frame and units: any_ray.h. Surfaces: bilinear, columns; any addressing. Guarantee: exact.
#pragma once

#include "relief/distance_options.h"
#include "relief/jump_any.h"

namespace relief {

class DistanceAnyHit {
  public:
    static constexpr RayClass kRays = RayClass::AnyRays;
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "distance-any";
        method.title = "the conservative distance map, any hit";
        method.kind = MethodKind::AnyHit;
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::AnyRays;
        method.help = "Jumps by distances that hold for whole voxels; looks at the cells of surface voxels.";
        method.source = "Donnelly 2005; [DIST17]";
        method.maps = {"euclidean-conservative"};
        return method;
    }
    struct Options {
        int footprint = 1;
        int layers = 32;
        std::string precision = "float";

        static std::vector<OptionField<Options>> fields() { return distanceFields<Options>(); }
    };
    static DistanceAnyHit make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        constexpr auto kKind = DistanceKind::EuclideanConservative;
        return DistanceAnyHit(DistanceWalk(field, distanceMapOf(kKind, options, field, cache, work)));
    }
    explicit DistanceAnyHit(const DistanceWalk& walk) : field_(walk.field()), map_(walk.distanceMap()), grid_(field_) {}

    template <class Sink>
    Sight look(const AnyRay& ray, Sink& sink) const {
        const double perMu = std::hypot(std::hypot(ray.ds, ray.dt), ray.dz * map_->slabTexels);
        return lookByJumps(field_, grid_, ray, 1, stepBound(ray), sink,
                           [&](const AnyRay& segment, const GridRay& course, AxisCell cx, AxisCell cy, double mu,
                               double) { return jump(segment, course, cx, cy, mu, perMu); });
    }

    const HeightField& field() const { return field_; }
    std::size_t bytes() const { return map_->bytes(); }
    // A step leaves a cell, or a voxel through its side, floor or ceiling.
    double stepBound(const AnyRay& ray) const {
        return 2 * GridRay(grid_, ray.course()).cellBound() + map_->layers() + 6;
    }

  private:
    // A free voxel is empty all over, and its distance holds for all its points: out of it, then on by the distance.
    double jump(const AnyRay& ray, const GridRay& course, AxisCell cx, AxisCell cy, double mu, double perMu) const {
        const double z = ray.heightAt(mu);
        const int layers = map_->layers();
        // On the border between two layers the segment is in the one that it moves into.
        const double k = ray.dz < 0 ? std::ceil(z * layers) - 1 : std::floor(z * layers);
        if (!(k >= 0 && k < layers)) return mu;
        const int f = map_->parameters.footprint;
        const int bx = cx.index / f;
        const int by = cy.index / f;
        const double distance = static_cast<double>(map_->at(bx, by, static_cast<int>(k), 0));
        if (distance < 0) return mu;
        const double face = (ray.dz > 0 ? k + 1 : k) / layers;
        double out = ray.dz != 0 ? (face - ray.z) / ray.dz : 1.0;
        out = std::min({out, course.x.leave(grid_.x, bx * f, std::min((bx + 1) * f, grid_.x.cells), cx.base),
                        course.y.leave(grid_.y, by * f, std::min((by + 1) * f, grid_.y.cells), cy.base)});
        return std::max(out, mu) + (perMu > 0 ? distance / perMu * (1 - 1e-9) : 0.0);  // 0: a relief of no depth
    }

    HeightField field_;
    std::shared_ptr<const DistanceMap> map_;
    CellGrid grid_;
};

}  // namespace relief
