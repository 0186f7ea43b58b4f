// relaxed-cone: wider cones, within which a ray crosses the surface at most once, then bisection. Policarpo & Oliveira
// 2007 (GPU Gems 3, ch. 18).
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing. View rays from above only.
// Guarantee: none. Failure mode: as cone-dummer; in addition, cones are measured along sampled azimuths and for rays
// that come from above the apex, so other rays may cross twice and return the far crossing.
// Cost: one height and one slope per step, one height per halving; memory 2 W H values.
#pragma once

#include "relief/methods/cone_march.h"

namespace relief {

class RelaxedConeTracer : public ConeMarch {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "relaxed-cone";
        method.title = "relaxed cone steps";
        method.guarantee = Guarantee::Approximate;
        method.rayClass = RayClass::ViewRays;
        method.help =
            "Steps to the edge of wider cones, in which a ray crosses the surface at most once; then bisects the last "
            "step.";
        method.source = "Policarpo & Oliveira 2007";
        method.maps = {"relaxed-cone"};
        return method;
    }
    struct Options {
        int iterations = 15;
        int bisections = 8;
        int radius = 64;
        int directions = 16;
        std::string precision = "float";

        static std::vector<OptionField<Options>> fields() { return coneFields<Options>(); }
    };
    static RelaxedConeTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        return {field, relief::coneMap(ConeKind::Relaxed, coneParameters(options), field, cache, work),
                options.iterations, options.bisections};
    }

    using ConeMarch::ConeMarch;
};

}  // namespace relief
