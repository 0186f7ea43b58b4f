// Which methods trace height maps that are read by tiles, and whether what they read is right.
#pragma once

#include <string>

#include "relief/tracers.h"

namespace relief {

class TiledHeights;

// False also with a base level, for which the heights would be read as a whole.
bool tracesTiles(const MethodChoice& choice);
// Throws InputError naming the file and the methods that can, if this one cannot.
void requireTiles(const MethodChoice& choice, const TiledHeights& tiles);
// For results that were computed from the field's heights: throws what TiledHeights::requireWhole() throws.
void requireHeights(const HeightField& field);

}  // namespace relief
