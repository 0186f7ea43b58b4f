// elliptical-visible: the elliptical filter without the texels that the relief hides from the viewer. [ANISO17]. Its
// forms, with errors and cost: by tracing texels back (filtering/elliptical_visible.h), by rays through parts of the
// pixel (filtering/elliptical_rays.h), by points that neighbouring pixels share (filtering/elliptical_grid.h).
#pragma once

#include "filtering/elliptical_visible.h"
#include "filtering/texture_filter.h"

namespace relief {

struct EllipticalVisible {
    using Options = VisibleOptions;
    static FilterDescription describe() {
        FilterDescription filter;
        filter.name = "elliptical-visible";
        filter.title = "elliptical, visible";
        filter.help = "the elliptical filter without the texels that the relief hides from the viewer";
        filter.source = "[ANISO17] (form=plane)";
        filter.footprint = filter.ellipse = filter.visible = true;
        return filter;
    }
    static std::vector<std::string> benched() { return {"form=plane", "form=position", "form=position-area", ""}; }
    static std::vector<std::string> advised() { return {"", "form=position-area"}; }
    static std::unique_ptr<const TextureFilter> make(const Options& options, const FilterTools& tools, MapCache& maps,
                                                     Work& work);
};

}  // namespace relief
