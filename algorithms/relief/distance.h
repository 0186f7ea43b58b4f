// distance: sphere tracing in a distance map of the slab, as published: trilinear look-up, a fixed number of steps.
// Donnelly 2005 (GPU Gems 2, ch. 8); [DIST17] figs. 3 and 4.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Guarantee: none. Failure mode: grazing rays do not arrive; at edges the interpolated distance cuts through them.
// Cost: eight stored distances a step; memory W H L / F^2.
#pragma once

#include "relief/distance_fixed.h"
#include "relief/distance_options.h"

namespace relief {

class DistanceTracer : public DistanceFixed {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "distance";
        method.title = "distance map";
        method.guarantee = Guarantee::Approximate;
        method.rayClass = RayClass::AnyRays;
        method.help = "Sphere tracing as published: trilinear distances, a fixed number of steps.";
        method.source = "Donnelly 2005; [DIST17]";
        method.maps = {"euclidean"};
        return method;
    }
    struct Options {
        int footprint = 1;
        int layers = 32;
        std::string precision = "float";
        int iterations = 32;

        static std::vector<OptionField<Options>> fields() { return distanceFields<Options>(); }
    };
    static DistanceTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        return {field, relief::distanceMap(DistanceKind::Euclidean, distanceParameters(options), field, cache, work),
                options.iterations};
    }

    using DistanceFixed::DistanceFixed;
};

}  // namespace relief
