// FLIP, the LDR difference evaluator. P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astrom,
// M. D. Fairchild: "FLIP: A Difference Evaluator for Alternating Images", HPG 2020. Section numbers below are theirs.
//
// Symmetric only almost: reference and test enter alike, so swapping them changes nothing but rounding.
// Cost: O(pixels x filter radius), the filters are separated.
#pragma once

#include "relief/image.h"
#include "relief/work.h"

namespace relief {

// Error of each pixel in [0, 1]. Colours linear; clamped to [0, 1]. Both of one size; pixelsPerDegree > 0.
FloatImage flipErrors(const ColorImage& reference, const ColorImage& test, double pixelsPerDegree, Work& work);

}  // namespace relief
