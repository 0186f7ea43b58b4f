// Minima over windows of rows, to which a cost that grows with the distance is added, and related loops: the SIMD loops
// of the Euclidean distance maps. The results are the same bits for any target.
#pragma once

#include <utility>

namespace relief {

// Rows are read and written up to the next multiple of this number.
inline constexpr int kWindowPad = 32;

// out[i] = min over |o| <= reach of rows[o][i] + steps[|o|], 0 <= i < n. steps must not decrease, steps[0] = 0.
// floor[i]: a lower bound of all rows[o][i]; the search ends where nothing farther can be smaller.
void leastOverWindows(const float* const* rows, const float* steps, int reach, const float* floor, int n, float* out);

// The smallest and the largest of n values, n > 0.
std::pair<float, float> extremesOf(const float* values, int n);

// out[i] = sqrt(squares[i]) * scale, 0 <= i < n; writes nothing beyond.
void rootsOf(const float* squares, int n, float scale, float* out);

}  // namespace relief
