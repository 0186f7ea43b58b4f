// distance: sphere tracing in a distance map of the slab. Each step advances by the trilinearly interpolated distance,
// until the ray reaches the surface. Donnelly 2005 (GPU Gems 2, ch. 8); [DIST17] figs. 3 and 4.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: distance_march.h. `map=refined-sampled`: the refined map of [DIST17] in the unchanged tracer. `stop=never`: a
// fixed number of steps, as in Donnelly's shader; `to=voxel`: distances between the centres of voxels, as in his
// volume.
// Guarantee: none. Failure mode: at edges the interpolated distance reaches through the surface; grazing rays run out
// of steps. Cost: eight stored distances and the surface's height per step; memory W H L / F^2.
#pragma once

#include "relief/methods/distance_options.h"

namespace relief {

class DistanceTracer : public DistanceMarch {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "distance";
        method.title = "distance map";
        method.guarantee = Guarantee::Approximate;
        method.rayClass = RayClass::AnyRays;
        method.help = "Sphere tracing with trilinearly interpolated distances until the ray reaches the surface.";
        method.source = "Donnelly 2005; [DIST17]";
        method.maps = {"euclidean"};
        method.otherMaps = {"refined-sampled"};
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
        std::string to = "surface";
        std::string map = "euclidean";

        static std::vector<std::string> maps() { return {"euclidean", "refined-sampled"}; }
        static std::vector<OptionField<Options>> fields() { return distanceFields<Options>(); }
    };
    static DistanceTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        const auto kind = options.map == "euclidean" ? DistanceKind::Euclidean : DistanceKind::RefinedSampled;
        return {field, distanceMapOf(kind, options, field, cache, work), options.iterations, marchEnd(options)};
    }

    using DistanceMarch::DistanceMarch;
};

}  // namespace relief
