// How far apart two pictures are: RMSE, PSNR and FLIP.
//
// All three compare what a screen shows: linear colours are sRGB-encoded and clamped to [0, 1] first. RMSE and PSNR
// weigh the three channels alike. FLIP is the LDR difference evaluator of Andersson et al. 2020 (HPG), an error map in
// [0, 1] of what a viewer notices who flips between the two; `flip` is its mean.
#pragma once

#include "relief/image.h"
#include "relief/work.h"

namespace relief {

// Pixels a degree of the viewer's field: 0.7 m from a screen 0.7 m and 3840 pixels wide, FLIP's own default.
inline constexpr double kPixelsPerDegree = 67.0;

struct PictureError {
    double rmse = 0;
    double psnr = 0;  // decibel, 20 log10(1 / rmse); infinite for equal pictures
    double flip = 0;
};

// Both of one size, not empty, no NaN (infinite values are clamped like others).
PictureError pictureError(const ColorImage& reference, const ColorImage& test, double pixelsPerDegree,
                          FloatImage& flipMap, Work& work);

}  // namespace relief
