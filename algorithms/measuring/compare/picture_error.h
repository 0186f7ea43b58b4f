// The difference between two pictures: RMSE, PSNR and FLIP.
//
// All three compare what a screen shows: linear colours are clamped to [0, 1] and sRGB-encoded first. RMSE and PSNR
// weight the three channels equally. FLIP is the LDR difference evaluator of Andersson et al. 2020 (HPG): a map in [0,
// 1] of the differences that a viewer notices when flipping between the two pictures; `flip` is its mean.
#pragma once

#include "relief/image.h"
#include "relief/work.h"

namespace relief {

// Pixels per degree of the viewer's field of view: 0.7 m from a screen 0.7 m and 3840 pixels wide, the default of FLIP.
inline constexpr double kPixelsPerDegree = 67.0;

struct PictureError {
    double rmse = 0;
    double psnr = 0;  // decibels, 20 log10(1 / rmse); infinite for equal pictures
    double flip = 0;
};

// Both pictures must have the same size, must not be empty and must contain no NaN (infinite values are clamped like
// others). Throws MemoryError, Cancelled.
PictureError pictureError(const ColorImage& reference, const ColorImage& test, double pixelsPerDegree,
                          FloatImage& flipMap, Work& work);

}  // namespace relief
