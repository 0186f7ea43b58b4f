// Exact distance transforms of sampled functions: by SIMD in windows as wide as a nearer sample can be, or by lower
// envelopes of parabolas (Felzenszwalb & Huttenlocher 2012), which take linear time, where such windows are very wide.
// Each value is the smallest of the sums, rounded to float.
#pragma once

#include <vector>

#include "relief/image.h"

namespace relief {

// The buffers of one thread.
struct EnvelopeScratch {
    std::vector<float> line;
    std::vector<float> out;
    std::vector<int> apex;
    std::vector<double> border;
    std::vector<float> plane;
    std::vector<float> floor;
    std::vector<float> steps;
    std::vector<const float*> rows;
};

// In place: f(x, y) becomes min over (i, j) of f(i, j) + (x - i)^2 dx^2 + (y - j)^2 dy^2, where dx and dy are the
// spacing of samples. wraps: the function is periodic. Values are squared lengths, finite.
void envelope2D(FloatImage& f, double dx, double dy, bool wraps, EnvelopeScratch& scratch);

// The same with the gap between unit boxes, max(|x - i| - 1, 0), instead of the distance between their centres.
void gapEnvelope2D(FloatImage& f, bool wraps, EnvelopeScratch& scratch);

}  // namespace relief
