// What base=auto costs and gains on a view: error and rate of the view's base level against level 0.
#pragma once

#include <optional>

#include "measuring/bench/bench_tracers.h"
#include "rendering/base_level.h"

namespace relief {

struct BaseLevelMeasure {
    FootprintLevel footprint;
    BenchRow based;  // the method at the view's level; errors against `exact` on level 0
    BenchRow whole;  // the same method at level 0
};
// asked: a method with base=auto of its own; nothing for any other, and where no polygon is seen. Up to 4096 rays of
// the view. Throws Cancelled, InputError.
std::optional<BaseLevelMeasure> measureBaseLevel(const FrameRequest& request, const MethodChoice& asked, MapCache& maps,
                                                 Work& work);
// In one sentence.
Message baseLevelSentence(const BaseLevelMeasure& measure);

}  // namespace relief
