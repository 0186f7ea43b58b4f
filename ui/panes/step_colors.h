// By what the steps of the 3-D trace are coloured, and what their colours mean.
#pragma once

#include <string>
#include <vector>

#include "painting/style.h"
#include "relief/ray.h"

namespace reliefui {

enum class StepColors : std::uint8_t { Decision, Level, Phase };
// Their names.
const std::vector<std::string>& tracePaneColors();
StepColors stepColors(const std::string& name);

// levels: of the pyramid over the relief; each has a colour of its own, the same as its plateaus in the profile.
struct StepPaint {
    StepColors by = StepColors::Decision;
    int levels = 1;

    Rgba color(const relief::Step& step, const Style& style) const;
};

// Of what occurs in the steps. exact: the ray's first hit. width: points.
Drawing traceLegend(const std::vector<relief::Step>& steps, const relief::ViewRay& ray, const relief::Hit& hit,
                    const relief::Hit& exact, const StepPaint& paint, double width, relief::Language language);

}  // namespace reliefui
