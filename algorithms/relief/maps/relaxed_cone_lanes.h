// SIMD loop of relaxed_cones.cpp: the relaxed cones of a row of texels. Its reference is relaxedSlope()
// (cone_builders.h): the results are the same bits for any target.
#pragma once

#include <cstddef>
#include <vector>

namespace relief {

// A sample of a profile, for all texels of a row: `distance` texels along an azimuth.
struct ProfileSample {
    double across;       // its offset in x
    double downShare;    // bilinear: weight of the lower of the two rows between whose texels it lies
    const float* upper;  // the row of heights that contains it, or the upper one of two; [0] is column 0
    const float* lower;  // bilinear: the lower one
};

// A row of texels. Rows of heights must be readable from -(reach + kRelaxedMargin) to width + reach + kRelaxedMargin,
// with the field's addressing.
inline constexpr int kRelaxedMargin = 12;
struct RelaxedRow {
    int width;
    int azimuths;
    int reach;                           // samples of a profile after its apex
    bool bilinear;                       // else columns
    double least, most;                  // x coordinates are clamped to this range
    double highest;                      // no height that a profile reaches is greater
    const float* apexes;                 // the heights of the row's texels
    std::vector<ProfileSample> samples;  // of all azimuths, reach + 1 each
    std::vector<double> profiles;        // working memory of relaxedSlopes()
};

// Writes the slopes of the row's texels.
void relaxedSlopes(RelaxedRow& row, float* slopes);

}  // namespace relief
