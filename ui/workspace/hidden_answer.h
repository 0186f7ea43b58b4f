// What is shown while the reader guesses where the ray hits.
#pragma once

#include <memory>

#include "workspace/snapshot.h"

namespace reliefui {

// Returns the snapshot without the steps and the hit of its ray, and without what depends on the hit. The exact hit
// stays, as the answer that a guess is compared with; views do not show it if PixelTrace::hidden.
std::shared_ptr<Snapshot> withoutAnswer(const Snapshot& snapshot);

}  // namespace reliefui
