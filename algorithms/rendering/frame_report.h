// What a frame reports of its making: stages and counters. Inside the renderer, not for others.
#pragma once

#include "rendering/tile_worker.h"

namespace relief {

// Fills the frame's stages and counters. counted: totals have steps and reads of the rays.
void report(Frame& frame, const FrameRequest& request, const VisiblePolygons& visible, const FrameTotals& totals,
            std::uint32_t stale, bool counted);
// Of steps and reads alone.
void reportCounts(Frame& frame, const FrameTotals& totals);

}  // namespace relief
