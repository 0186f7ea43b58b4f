// Colouring of the steps in the 3-D trace, and its legend.
#pragma once

#include <string>
#include <vector>

#include "painting/style.h"
#include "relief/ray.h"

namespace reliefui {

enum class StepColors : std::uint8_t { Decision, Level, Phase };
// Names of the colourings.
const std::vector<std::string>& tracePaneColors();
StepColors stepColors(const std::string& name);

// levels: of the pyramid over the relief; each has the colour of its plateaus in the profile.
struct StepPaint {
    StepColors by = StepColors::Decision;
    int levels = 1;

    Rgba color(const relief::Step& step, const Style& style) const;
};

// Legend of what occurs in the steps. exact: first hit of the ray. width: in points.
Drawing traceLegend(const std::vector<relief::Step>& steps, const relief::ViewRay& ray, const relief::Hit& hit,
                    const relief::Hit& exact, const StepPaint& paint, double width, relief::Language language);

}  // namespace reliefui
