// Fills in a frame's report: stages and counters. Internal to the renderer.
#pragma once

#include "rendering/tile_worker.h"

namespace relief {

// Sets the frame's stages and counters. counted: whether totals contain the steps and reads of the rays.
void report(Frame& frame, const FrameRequest& request, const VisiblePolygons& visible, const FrameTotals& totals,
            std::uint32_t stale, bool counted);
// Sets only the counters of steps, reads and rays that start at the highest height. totals.traced: the traced rays of
// which these are the counts.
void reportCounts(Frame& frame, const FrameTotals& totals);

}  // namespace relief
