// normal-map: as `bump`, with normals computed beforehand and looked up. Cohen et al. 1998.
//
// Frame, units, surfaces, failure mode, cost: top_plane.h.
// Model: the normal picture's normal where the ray enters, or, if none is given, that of a normal map baked from the
// heights in 8 bits a component (maps/baked_normals.h). Beside `bump` it shows what baking and rounding cost.
// The renderer looks the normal up, and bakes the map only where no picture is given.
#pragma once

#include "relief/methods/top_plane.h"

namespace relief {

class NormalMapTracer : public TopPlaneTracer {
  public:
    static MethodDescription describe() {
        MethodDescription method = shading(ShadingNormal::NormalMap);
        method.name = "normal-map";
        method.title = "normal mapping";
        method.help =
            "The picture stays flat; the light sees a normal map, the given one or one baked from the heights.";
        method.source = "Cohen et al. 1998";
        method.maps = {"normals"};
        return method;
    }
    static NormalMapTracer make(const HeightField& field, const Options&, MapCache&, Work&) {
        return NormalMapTracer(field);
    }

    using TopPlaneTracer::TopPlaneTracer;
};

}  // namespace relief
