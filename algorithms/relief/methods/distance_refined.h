// distance-refined: distance-conservative with a map of larger distances, which hold only for rays that come from above
// and have not hit anything before. [DIST17] figs. 5 to 8, [TEX], in a form that is safe for whole voxels.
//
// Frame and units: ray.h. Surfaces: bilinear, columns; repeat and border (refused under clamp, for which safety is not
// proven).
// Model: "exit + D" (distance_walk.h) with the bounds of maps/refined.h. `rule=classic`: "t + D".
// Guarantee: exact, the same bits as `exact`, for view rays. Failure mode: rays flatter than `flattest` walk every
// cell. Cost: as distance-conservative; slightly fewer steps in deep pits and between walls, as many on smooth relief.
#pragma once

#include "relief/methods/distance_options.h"
#include "relief/methods/distance_walk.h"

namespace relief {

class DistanceRefinedTracer : public DistanceWalk {
  public:
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "distance-refined";
        method.title = "refined distance map";
        method.guarantee = Guarantee::Exact;
        method.rayClass = RayClass::ViewRays;
        method.addresses = {Address::Repeat, Address::Border};
        method.help =
            "Sphere tracing with the larger distances that are valid for rays from above; safe for whole voxels.";
        method.source = "[DIST17]; [TEX]";
        method.maps = {"refined"};
        return method;
    }
    struct Options {
        int footprint = 4;
        int layers = 16;
        std::string precision = "float";
        double flattest = 10;
        int horizons = 16;
        int sectors = 1;
        std::string rule = "exit";

        static std::vector<OptionField<Options>> fields() { return distanceFields<Options>(); }
        void check(const std::string& subject) const { checkTogether(*this, subject); }
    };
    static DistanceRefinedTracer make(const HeightField& field, const Options& options, MapCache& cache, Work& work) {
        return {field, distanceMapOf(DistanceKind::Refined, options, field, cache, work), stepRule(options)};
    }

    using DistanceWalk::DistanceWalk;
};

}  // namespace relief
