// Measures the effect of base=auto on a view: error and rate at the view's base level compared with level 0.
#pragma once

#include <optional>

#include "measuring/bench/bench_tracers.h"
#include "rendering/base_level.h"

namespace relief {

struct BaseLevelMeasure {
    FootprintLevel footprint;
    BenchRow based;  // the method at the view's level; errors relative to `exact` on level 0
    BenchRow whole;  // the same method at level 0
};
// Measures a method with base=auto of its own on up to 4096 rays of the view. Returns std::nullopt for any other
// method, and if no polygon is visible. Throws Cancelled, InputError.
std::optional<BaseLevelMeasure> measureBaseLevel(const FrameRequest& request, const MethodChoice& method,
                                                 MapCache& maps, Work& work);
// Returns the measurement as one sentence.
Message baseLevelSentence(const BaseLevelMeasure& measure);

}  // namespace relief
