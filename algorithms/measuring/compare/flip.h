// FLIP, the LDR difference evaluator. P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astrom, M. D.
// Fairchild: "FLIP: A Difference Evaluator for Alternating Images", HPG 2020. Section numbers below refer to this
// paper.
//
// Symmetric except for rounding: reference and test are treated alike. Cost: O(pixels x filter radius), because the
// filters are separable.
#pragma once

#include "relief/image.h"
#include "relief/work.h"

namespace relief {

// Returns the error of each pixel in [0, 1]. Colours are linear and clamped to [0, 1]. Both pictures must have the same
// size; pixelsPerDegree > 0. Throws MemoryError, Cancelled.
FloatImage flipErrors(const ColorImage& reference, const ColorImage& test, double pixelsPerDegree, Work& work);

}  // namespace relief
