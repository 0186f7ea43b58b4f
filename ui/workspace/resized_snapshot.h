// The same view in another size, as figures show it.
#pragma once

#include <memory>

#include "workspace/snapshot.h"

namespace reliefui {

// The scenario with a picture of another size; the chosen pixel is the one at the same place of it.
relief::Scenario inSize(relief::Scenario scenario, int width, int height);

// The snapshot with a picture `width` pixels wide, of the same shape, see inSize(): frame, picture and layer are
// rendered anew; the chosen pixel's ray stays the one that was traced. The snapshot itself where it is of
// that width. Throws MemoryError before it is taken, InputError, Cancelled. Any thread.
std::shared_ptr<const Snapshot> resized(const std::shared_ptr<const Snapshot>& snapshot, int width, relief::Work& work);

}  // namespace reliefui
