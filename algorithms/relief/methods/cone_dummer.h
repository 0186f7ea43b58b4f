// cone-dummer: cone steps as published. Dummer 2006.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: from each point the ray advances to the edge of the cone there. Height and slope are interpolated between
// texel centres, where the cones were measured.
// Guarantee: none. Failure mode: between texel centres neither the heights nor the slopes are those of the cones, so
// steps cut through walls and spikes; at grazing angles a fixed number of steps does not reach the surface.
// Cost: one height and one slope per step; memory 2 W H values.
#pragma once

#include "relief/methods/cone_march.h"

namespace relief {

class ConeDummerTracer : public ConeMarch {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "cone-dummer";
        method.title = "cone steps, as published";
        method.guarantee = Guarantee::Approximate;
        method.rayClass = RayClass::AnyRays;
        method.help = "Steps to the edge of the interpolated cone a fixed number of times.";
        method.source = "Dummer 2006";
        method.maps = {"cone-dummer"};
        return method;
    }
    struct Options {
        int iterations = 32;
        std::string precision = "float";

        static std::vector<OptionField<Options>> fields() { return coneFields<Options>(); }
    };
    static ConeDummerTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        return {field, relief::coneMap(ConeKind::Dummer, coneParameters(options), field, cache, work),
                options.iterations, 0};
    }

    using ConeMarch::ConeMarch;
};

}  // namespace relief
