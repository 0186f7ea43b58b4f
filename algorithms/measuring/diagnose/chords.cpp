#include "measuring/diagnose/chords.h"

#include <algorithm>
#include <cmath>

#include "relief/sampled_surface.h"

namespace relief {

std::vector<Chord> solidChords(const HeightField& field, const ViewRay& ray, double first) {
    const SampledSurface surface(field, ray);
    constexpr double kPerTexel = 16;
    constexpr double kLeast = 64, kMost = 65536;
    const double step = 1 / std::clamp(kPerTexel * std::hypot(ray.a, ray.b), kLeast, kMost);
    // The border of solid and air between two points, of which the second is solid if `solid`.
    const auto border = [&](double low, double high, bool solid) {
        for (int n = 0; n < 40; ++n) {
            const double middle = 0.5 * (low + high);
            ((surface.gapAt(middle) >= 0) == solid ? high : low) = middle;
        }
        return high;
    };
    std::vector<Chord> chords{{first, 1, 0}};
    bool solid = true;
    double at = first;
    // A thin first chord is left soon: the first steps are short.
    double stride = step / 4096;
    while (at < 1) {
        const double next = std::min(at + stride, 1.0);
        const double gap = surface.gapAt(next);
        if (solid) chords.back().depth = std::max(chords.back().depth, gap);
        if ((gap >= 0) != solid) {
            const double edge = border(at, next, !solid);
            if (solid) {
                chords.back().out = edge;
            } else {
                chords.push_back({edge, 1, gap});
            }
            solid = !solid;
        }
        at = next;
        stride = std::min(stride * 2, step);
    }
    return chords;
}

bool barelyTouches(const HeightField& field, const ViewRay& ray, const std::vector<Chord>& chords, const Hit& answer,
                   double run) {
    if (answer.outcome != Outcome::Hit && answer.outcome != Outcome::Miss) return false;
    const double to = answer.outcome == Outcome::Hit ? answer.lambda : 1.0;
    for (const Chord& chord : chords) {
        if (std::abs(chord.in - to) * run <= kRightTexels) return true;
        if (chord.in > to) return false;
        if (chord.depth <= kTouchDepth) continue;
        // Behind the way in, where the ray is nearly parallel to the surface.
        constexpr double kNear = 0.125;  // texels
        return answer.outcome == Outcome::Hit && to <= chord.out && (to - chord.in) * run <= kNear &&
               SampledSurface(field, ray).gapAt(to) <= kTouchDepth / 4;
    }
    return false;
}

}  // namespace relief
