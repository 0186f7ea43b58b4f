// Renders the current view at another size, for figures.
#pragma once

#include <memory>

#include "workspace/snapshot.h"

namespace reliefui {

// Changes the size of the scenario's picture and moves the chosen pixel to the same relative position.
relief::Scenario inSize(relief::Scenario scenario, int width, int height);

// Renders the snapshot's frame, picture and layer again, `width` pixels wide with the same aspect ratio, see inSize().
// The trace of the chosen pixel's ray is not repeated. Returns the snapshot itself if it already has this width. Throws
// MemoryError before allocating, InputError, Cancelled. May be called on any thread.
std::shared_ptr<const Snapshot> resized(const std::shared_ptr<const Snapshot>& snapshot, int width, relief::Work& work);

}  // namespace reliefui
