// distance-refined-sampled: the refined distance map as the papers define it. Each voxel stores the smallest distance
// to the first hit over sampled rays that reach its centre unobstructed. [DIST17] figs. 5 to 8, [TEX].
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: distance_march.h; `distance` with map=refined-sampled is the same. Guarantee: none. Failure mode: overshoots
// at walls, which more directions do not cure (reasons: maps/refined.h). Rays flatter than `flattest` are not served:
// they walk every cell. Cost: as `distance`; building the map traces `directions` rays per voxel.
#pragma once

#include "relief/methods/distance_options.h"

namespace relief {

class DistanceRefinedSampledTracer : public DistanceMarch {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "distance-refined-sampled";
        method.title = "refined distance map, sampled";
        method.guarantee = Guarantee::Approximate;
        method.rayClass = RayClass::ViewRays;
        method.help = "The refined map as published, computed from sampled rays; can overshoot at walls.";
        method.source = "[DIST17]; [TEX]";
        method.maps = {"refined-sampled"};
        return method;
    }
    struct Options {
        int footprint = 1;
        int layers = 32;
        std::string precision = "float";
        double flattest = 10;
        int directions = 64;
        std::string stop = "surface";
        double within = 0.05;
        int iterations = 256;

        static std::vector<OptionField<Options>> fields() { return distanceFields<Options>(); }
    };
    static DistanceRefinedSampledTracer make(const HeightField& field, const Options& options, MapCache& cache,
                                             Work& work) {
        return {field, distanceMapOf(DistanceKind::RefinedSampled, options, field, cache, work), options.iterations,
                marchEnd(options)};
    }

    using DistanceMarch::DistanceMarch;
};

}  // namespace relief
