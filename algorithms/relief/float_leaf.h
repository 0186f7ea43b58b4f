// The exclusion test within a cell, in float: is the surface certainly below the ray over the ray's whole interval in
// the cell? Reference of simd/lane_leaf-inl.h. Where the test is not certain, the leaf decides in double (leaf.h).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "relief/float_margins.h"

namespace relief {

// One axis of a ray in a cell. The position within the cell along the ray's direction is (lambda - base) * run - n, in
// [0, 1].
struct FloatCellAxis {
    float n = 0;
    float base = 0;
    float run = 0;
    bool back = false;

    // Position within the cell along the axis, [0, 1], whichever way the ray runs.
    float within(float lambda) const {
        const float along = std::min(std::max((lambda - base) * run - n, 0.0F), 1.0F);
        return back ? 1 - along : along;
    }
};

// Returns true if the bilinear surface with corner heights h is certainly below the ray. h: (before, before), (after,
// before), (before, after), (after, after) in (x, y). The ray's interval in the cell lies within [in, out]: `in` is
// early by at most one tie, `out` late by at most half a tie.
inline bool patchBelow(const std::array<float, 4>& h, const FloatCellAxis& x, const FloatCellAxis& y, float in,
                       float out, float tie) {
    const auto [h00, h10, h01, h11] = h;
    const float alongTop = h10 - h00, alongBottom = h11 - h01;
    const auto heightAt = [&](float u, float v) {
        const float top = u * alongTop + h00, bottom = u * alongBottom + h01;
        return v * (bottom - top) + top;
    };
    const float uIn = x.within(in), vIn = y.within(in), uOut = x.within(out), vOut = y.within(out);
    const float fIn = heightAt(uIn, vIn) - (1 - in), fOut = heightAt(uOut, vOut) - (1 - out);
    const float c = (uOut - uIn) * (vOut - vIn) * (alongBottom - alongTop);
    // The vertex of the parabola, if it is a maximum inside the interval.
    const float slope = fOut - fIn - c;
    const bool arched = c < 0 && slope > 0 && slope < -2.0F * c;
    // Rounded upwards, because the SIMD version uses an approximate reciprocal.
    const float vertex = fIn - slope * (0.25F * (1 + 2 * kReciprocalError)) * (slope * (1 / (arched ? c : 1.0F)));
    const float highest = std::max(std::max(fIn, fOut), arched ? vertex : fIn);
    // Positions are off by at most twice the crossing margin times the run, and heights by that times the cell's
    // slopes. Of the two ties, one and a half cover `in` and `out`; the rest, at least 16 units of 2^-24, covers the
    // rounding of heights.
    const auto blur = [](float run, float steepest) {
        return steepest * (run * (2 * kCrossingMargin) + 2 * kCrossingMargin);
    };
    const float slopeX = std::max(std::abs(alongTop), std::abs(alongBottom));
    const float slopeY = std::max(std::abs(h01 - h00), std::abs(h11 - h10));
    return highest < -(blur(x.run, slopeX) + blur(y.run, slopeY) + 2 * tie);
}

// Returns true if a column of this height is below the ray up to `out`. Needs no margin: `out` is late, heights are
// exact, and rounding preserves the order.
inline bool columnBelow(float height, float out) {
    return height < 1 - out;
}

}  // namespace relief
