// The exclusion leaf: whether the surface is surely below a ray all along its stay in a cell, in float. Reference of
// simd/lane_leaf-inl.h. Where it is not sure, the one leaf decides (leaf.h).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "relief/float_margins.h"

namespace relief {

// One axis of the stay: the cell's place along it is (lambda - base) * run - n, in [0, 1], counted the way the ray
// runs.
struct FloatCellAxis {
    float n = 0;
    float base = 0;
    float run = 0;
    bool back = false;

    // Place in the cell as the heights have it.
    float within(float lambda) const {
        const float along = std::min(std::max((lambda - base) * run - n, 0.0F), 1.0F);
        return back ? 1 - along : along;
    }
};

// h: (before, before), (after, before), (before, after), (after, after) in (x, y). The stay is within [in, out]: `in`
// is early by at most a tie, `out` late by at most half of one.
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
    // The vertex of the parabola, where it is inside and a maximum.
    const float slope = fOut - fIn - c;
    const bool arched = c < 0 && slope > 0 && slope < -2.0F * c;
    // A little too high: lanes take an approximate reciprocal.
    const float vertex = fIn - slope * (0.25F * (1 + 2 * kReciprocalError)) * (slope * (1 / (arched ? c : 1.0F)));
    const float highest = std::max(std::max(fIn, fOut), arched ? vertex : fIn);
    // Places are off by at most twice the crossing margin times the run, heights by that times the cell's slopes. Of
    // the two ties one and a half cover `in` and `out`, the rest, at least 16 units of 2^-24, the rounding of heights.
    const auto blur = [](float run, float steepest) {
        return steepest * (run * (2 * kCrossingMargin) + 2 * kCrossingMargin);
    };
    const float slopeX = std::max(std::abs(alongTop), std::abs(alongBottom));
    const float slopeY = std::max(std::abs(h01 - h00), std::abs(h11 - h10));
    return highest < -(blur(x.run, slopeX) + blur(y.run, slopeY) + 2 * tie);
}

// No margin: `out` is late, heights are exact, and rounding keeps the order.
inline bool columnBelow(float height, float out) {
    return height < 1 - out;
}

}  // namespace relief
