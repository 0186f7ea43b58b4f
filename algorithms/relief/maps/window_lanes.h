// Least values over windows of rows, each row dearer the farther off, and what goes with them: the inner loops of the
// Euclidean distance maps, in lanes; the same bits for any target.
#pragma once

#include <utility>

namespace relief {

// Rows are read and written up to the next multiple of this.
inline constexpr int kWindowPad = 32;

// out[i] = min over |o| <= reach of rows[o][i] + steps[|o|], 0 <= i < n. steps[0] = 0, none less than the one before.
// floor[i]: at most all of rows[o][i]; where nothing farther can be less, no more is looked at.
void leastOverWindows(const float* const* rows, const float* steps, int reach, const float* floor, int n, float* out);

// The least and the largest of n values, n > 0.
std::pair<float, float> extremesOf(const float* values, int n);

// out[i] = sqrt(squares[i]) * scale, 0 <= i < n, no more being written.
void rootsOf(const float* squares, int n, float scale, float* out);

}  // namespace relief
