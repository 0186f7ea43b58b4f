// cone-robust: cone steps from the surface below the ray, over cones that are safe for the interpolated surface. Dummer
// 2006, as corrected by Ban, Valasek, Balint, Vad, Robust Cone Step Mapping (EGSR 2024).
//
// Frame and units: ray.h. Surfaces: bilinear (above the walls of columns every cone holds a part of the surface); any
// addressing.
// Model: cone_march.h over the cones of maps/surface_cones.h, which keep their promise at every point between texels
// and in every interpolation. It is the loop of shaders, one fetch a step, where `cone` steps from cell to cell.
// Guarantee: conservative, up to rounding; proven value by value (certify). None under border, where a ray that enters
// on the map's very rim may miss. Failure mode: steps end above the surface: next to it they become short, and at
// grazing angles `iterations` of them do not reach it. Cost: one height and one slope per step; memory 2 W H values.
#pragma once

#include "relief/methods/cone_march.h"

namespace relief {

class ConeRobustTracer : public ConeMarch {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "cone-robust";
        method.title = "cone steps, corrected";
        method.guarantee = Guarantee::Conservative;
        method.rayClass = RayClass::AnyRays;
        method.help =
            "Steps to the edge of the interpolated cone a fixed number of times, over cones that are safe between "
            "texels, too.";
        method.source = "Ban et al. 2024";
        method.surfaces = {Surface::Bilinear};
        method.maps = {"cone-robust"};
        return method;
    }
    struct Options {
        int iterations = 64;
        std::string precision = "float";

        static std::vector<OptionField<Options>> fields() { return coneFields<Options>(); }
    };
    static ConeRobustTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        return {field, relief::coneMap(ConeKind::Robust, coneParameters(options), field, cache, work),
                options.iterations, 0};
    }

    using ConeMarch::ConeMarch;

    Guarantee guarantee() const {
        return field().address() == Address::Border ? Guarantee::Approximate : Guarantee::Conservative;
    }
};

}  // namespace relief
