// The same view in another size, as figures show it.
#pragma once

#include <memory>

#include "workspace/snapshot.h"

namespace reliefui {

// The snapshot with a picture `width` pixels wide, of the same shape: frame, picture and layer are rendered anew, the
// chosen pixel is the one at the same place; its ray stays the one that was traced. The snapshot itself where it is of
// that width. Throws MemoryError before it is taken, InputError, Cancelled. Any thread.
std::shared_ptr<const Snapshot> resized(const std::shared_ptr<const Snapshot>& snapshot, int width, relief::Work& work);

}  // namespace reliefui
