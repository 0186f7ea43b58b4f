// distance-conservative: sphere tracing in a distance map whose distances hold for every point of each voxel. Donnelly
// 2005 made safe; [DIST17].
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: "exit + D" (distance_walk.h): leave the voxel, then advance by its distance; cells of surface voxels are
// tested. `rule=classic`: "t + D". `map=refined`: the refined map in the unchanged tracer.
// Guarantee: exact, the same bits as `exact`. Failure mode: many steps along walls; memory W H L / F^2. Cost: one
// distance per step, one leaf per cell near the surface.
#pragma once

#include "relief/methods/distance_options.h"
#include "relief/methods/distance_walk.h"

namespace relief {

class DistanceConservativeTracer : public DistanceWalk {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "distance-conservative";
        method.title = "distance map, conservative";
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::AnyRays;
        method.help =
            "Sphere tracing with distances that are safe for whole voxels; near the surface the cells themselves are "
            "tested.";
        method.source = "Donnelly 2005; [DIST17]";
        method.maps = {"euclidean-conservative"};
        method.otherMaps = {"refined"};
        return method;
    }
    struct Options {
        int footprint = 1;
        int layers = 32;
        std::string precision = "float";
        double flattest = 10;
        int horizons = 16;
        int sectors = 1;
        std::string rule = "exit";
        std::string map = "euclidean-conservative";

        static std::vector<std::string> maps() { return {"euclidean-conservative", "refined"}; }
        static std::vector<OptionField<Options>> fields() { return distanceFields<Options>(); }
        void check(const std::string& subject) const { checkTogether(*this, subject); }
    };
    static DistanceConservativeTracer make(const HeightField& field, const Options& options, MapCache& cache,
                                           Work& work) {
        const bool refined = options.map == "refined";
        const auto kind = refined ? DistanceKind::Refined : DistanceKind::EuclideanConservative;
        return {field, distanceMapOf(kind, options, field, cache, work), stepRule(options)};
    }

    using DistanceWalk::DistanceWalk;
};

}  // namespace relief
