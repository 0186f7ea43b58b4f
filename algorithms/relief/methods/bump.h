// bump: bump mapping. The picture is not displaced; lighting uses the slope of the heights. Blinn 1978.
//
// Frame, units, surfaces, failure mode, cost: top_plane.h.
// Model: the normal is n - D (dh/ds) e_s - D (dh/dt) e_t, D = relief_depth * W texels, from the derivatives of the
// heights (HeightField::slope) at the point where the ray enters.
#pragma once

#include "relief/methods/top_plane.h"

namespace relief {

class BumpTracer : public TopPlaneTracer {
  public:
    static std::string formNote() { return "The ray is not traced."; }
    static MethodDescription describe() {
        MethodDescription method = shading(ShadingNormal::Heights);
        method.name = "bump";
        method.title = "bump mapping";
        method.help = "The surface stays flat; lighting uses the slopes of the heights.";
        method.source = "Blinn 1978";
        return method;
    }
    static BumpTracer make(const HeightField& field, const Options&, MapCache&, Work&) { return BumpTracer(field); }

    using TopPlaneTracer::TopPlaneTracer;
};

}  // namespace relief
