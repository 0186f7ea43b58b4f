// relaxed-cone-robust: relaxed-cone over cones that end at falling edges. Ban, Valasek, Balint, Vad, Robust Cone Step
// Mapping (EGSR 2024), after Policarpo & Oliveira 2007.
//
// Frame and units: ray.h. Surfaces: bilinear; any addressing. View rays from above only.
// Model: cone_march.h over the cones of maps/robust_cones.h: all directions instead of sampled azimuths.
// Guarantee: none. Failure mode: cones are compared with texels, as published, and not with points between them, so
// that some rays still cross the surface twice in a step (certify refutes it on `spikes`).
// Cost: one height and one slope per step, one height per halving; memory 2 W H values.
#pragma once

#include "relief/methods/cone_march.h"

namespace relief {

class RelaxedConeRobustTracer : public ConeMarch {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "relaxed-cone-robust";
        method.title = "relaxed cone steps, corrected";
        method.guarantee = Guarantee::Approximate;
        method.rayClass = RayClass::ViewRays;
        method.help =
            "Steps to the edge of relaxed cones that no texel behind which the surface falls stands in; then bisects "
            "the last step.";
        method.source = "Ban et al. 2024";
        method.surfaces = {Surface::Bilinear};
        method.maps = {"relaxed-cone-robust"};
        return method;
    }
    struct Options {
        int iterations = 32;
        int bisections = 8;
        int radius = 64;
        std::string precision = "float";

        static std::vector<OptionField<Options>> fields() { return coneFields<Options>(); }
    };
    static RelaxedConeRobustTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        return {field, relief::coneMap(ConeKind::RelaxedRobust, coneParameters(options), field, cache, work),
                options.iterations, options.bisections};
    }

    using ConeMarch::ConeMarch;
};

}  // namespace relief
