// normal-map: as `bump`, with precomputed normals from a normal map. Cohen et al. 1998.
//
// Frame, units, surfaces, failure mode, cost: top_plane.h.
// Model: the normal of the given normal picture at the point where the ray enters, or without one, that of a normal map
// baked from the heights with 8 bits per component (maps/baked_normals.h). The comparison with `bump` shows the cost of
// baking and rounding. The renderer samples the normal, and bakes the map only if no picture is given.
#pragma once

#include "relief/methods/top_plane.h"

namespace relief {

class NormalMapTracer : public TopPlaneTracer {
  public:
    static std::string formNote() { return "The ray is not traced."; }
    static MethodDescription describe() {
        MethodDescription method = shading(ShadingNormal::NormalMap);
        method.name = "normal-map";
        method.title = "normal mapping";
        method.help = "The surface stays flat; lighting uses a normal map, either given or computed from the heights.";
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
