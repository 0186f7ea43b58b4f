// flat: the picture on its polygon without relief, the baseline of all other methods.
//
// Frame, units, surfaces, failure mode, cost: top_plane.h.
// Model: the colour at the point where the ray enters, lit with the normal of the polygon.
#pragma once

#include "relief/methods/top_plane.h"

namespace relief {

class FlatTracer : public TopPlaneTracer {
  public:
    static std::string formNote() { return "The ray is not traced."; }
    static MethodDescription describe() {
        MethodDescription method = shading(ShadingNormal::Plane);
        method.name = "flat";
        method.title = "flat";
        method.help = "Plain texturing without relief; lighting uses the flat polygon.";
        return method;
    }
    static FlatTracer make(const HeightField& field, const Options&, MapCache&, Work&) { return FlatTracer(field); }

    using TopPlaneTracer::TopPlaneTracer;
};

}  // namespace relief
