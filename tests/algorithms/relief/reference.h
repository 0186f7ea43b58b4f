// An independent truth in long double that shares no code with the library. It floors positions, sorts the crossings of
// grid lines, and finds roots by a dense search for sign changes including the vertex of each parabola, whereas the
// library increments integers and solves equations.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief::reference {

using Real = long double;

struct Answer {
    bool hit = false;
    Real lambda = 0;
    // The smallest |surface - ray| at a near miss before the hit, or at a hit that was nearly a miss: on rays with a
    // tiny clearance different results are due to rounding.
    Real clearance = 1;
};

inline long long nodeIndex(long long i, int size, Address address) {
    if (address == Address::Repeat) return ((i % size) + size) % size;
    return std::clamp<long long>(i, 0, size - 1);
}

// Returns the surface height at any position.
inline Real surfaceAt(const HeightField& field, Real s, Real t, long long ci, long long cj) {
    const auto& h = field.heights();
    const auto texel = [&](long long i, long long j) {
        return static_cast<Real>(h(static_cast<int>(nodeIndex(i, field.width(), field.address())),
                                   static_cast<int>(nodeIndex(j, field.height(), field.address()))));
    };
    if (field.surface() == Surface::Columns) return texel(ci, cj);
    const Real u = s - 0.5L - static_cast<Real>(ci);
    const Real v = t - 0.5L - static_cast<Real>(cj);
    const Real top = texel(ci, cj) * (1 - u) + texel(ci + 1, cj) * u;
    const Real bottom = texel(ci, cj + 1) * (1 - u) + texel(ci + 1, cj + 1) * u;
    return top * (1 - v) + bottom * v;
}

// Adds the lambdas in (0, end) at which x0 + lambda d is an integer.
inline void addCrossings(std::vector<Real>& crossings, Real x0, Real d, Real end) {
    if (d == 0) return;
    const Real x1 = x0 + end * d;
    const auto first = static_cast<long long>(std::ceil(std::min(x0, x1)));
    const auto last = static_cast<long long>(std::floor(std::max(x0, x1)));
    for (long long k = first; k <= last; ++k) {
        const Real lambda = (static_cast<Real>(k) - x0) / d;
        if (lambda > 0 && lambda < end) crossings.push_back(lambda);
    }
}

// Returns the first hit of the ray. The origin is not reduced to the picture; addressing is applied to texel look-ups
// only.
inline Answer trace(const HeightField& field, const ViewRay& ray) {
    const Real s0 = ray.s0;
    const Real t0 = ray.t0;
    const Real a = ray.a;
    const Real b = ray.b;
    const Real shift = field.surface() == Surface::Bilinear ? 0.5L : 0.0L;
    Real end = 1;
    Answer answer;
    if (field.address() == Address::Border) {
        const Real w = field.width();
        const Real h = field.height();
        if (s0 < 0 || s0 > w || t0 < 0 || t0 > h) return answer;
        if (a > 0) end = std::min(end, (w - s0) / a);
        if (a < 0) end = std::min(end, -s0 / a);
        if (b > 0) end = std::min(end, (h - t0) / b);
        if (b < 0) end = std::min(end, -t0 / b);
    }
    std::vector<Real> crossings{0};
    addCrossings(crossings, s0 - shift, a, end);
    addCrossings(crossings, t0 - shift, b, end);
    crossings.push_back(end);
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t n = 0; n + 1 < crossings.size(); ++n) {
        const Real in = crossings[n];
        const Real out = crossings[n + 1];
        if (!(in < out)) continue;
        const Real middle = (in + out) / 2;
        const auto ci = static_cast<long long>(std::floor(s0 + middle * a - shift));
        const auto cj = static_cast<long long>(std::floor(t0 + middle * b - shift));
        const auto gap = [&](Real lambda) {
            return surfaceAt(field, s0 + lambda * a, t0 + lambda * b, ci, cj) - (1 - lambda);
        };
        if (gap(in) >= 0) {
            answer.hit = true;
            answer.lambda = in;
            answer.clearance = std::min(answer.clearance, n == 0 ? 1 : std::abs(gap(in)));
            return answer;
        }
        answer.clearance = std::min(answer.clearance, std::abs(gap(in)));
        // f(in + x) = f0 + p x + q x^2 from three samples; its highest point, if it lies inside.
        const Real f0 = gap(in);
        const Real f1 = gap(middle);
        const Real f2 = gap(out);
        const Real half = (out - in) / 2;
        const Real q = (f0 - 2 * f1 + f2) / (2 * half * half);
        const Real p = (f1 - f0) / half - q * half;
        Real high = out;
        if (q < 0) {
            const Real vertex = -p / (2 * q);
            if (vertex > 0 && vertex < 2 * half) high = in + vertex;
        }
        const Real fHigh = gap(high);
        answer.clearance = std::min(answer.clearance, std::abs(fHigh));
        if (fHigh < 0 && !(out >= 1 && high == out)) continue;
        Real low = in;
        for (int i = 0; i < 80; ++i) {
            const Real x = (low + high) / 2;
            (gap(x) >= 0 ? high : low) = x;
        }
        answer.hit = true;
        answer.lambda = high;
        return answer;
    }
    return answer;
}

}  // namespace relief::reference
