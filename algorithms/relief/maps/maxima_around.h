// The largest of 3 x 3 values, for maps whose values are interpolated.
#pragma once

#include "relief/addressing.h"
#include "relief/image.h"
#include "relief/work.h"

namespace relief {

// Returns for each value the largest of the 3 x 3 values around it, itself included. address: of values outside; border
// is as clamp. In parallel. Throws Cancelled.
FloatImage maximaAround(const FloatImage& values, Address address, Work& work);

}  // namespace relief
