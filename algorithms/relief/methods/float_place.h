// The start of a ray on one axis, converted to float, for the reference walks (cone_walk.h, depth_walk.h). SIMD
// version: setUpPlaces() in simd/lane_trace-inl.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "relief/float_margins.h"
#include "relief/methods/float_scene.h"

namespace relief {

// Whether float can follow a ray. Gone: under border it has left the map before its walk begins.
enum class FloatFit : std::uint8_t { Fit, Gone, Unfit };

// Of both axes.
inline FloatFit bothFit(FloatFit x, FloatFit y) {
    return x == FloatFit::Unfit || y == FloatFit::Unfit ? FloatFit::Unfit : std::max(x, y);
}

// Unfit rays get the axis of one that stands still in cell 0: nobody walks along it.
struct FloatPlace {
    FloatFit fit = FloatFit::Fit;
    bool back = false;  // it runs towards lower indices
    double line = 0;    // the grid line at or before the start, the way the ray runs
    double share = 0;   // from that line to the start, cells
    float run = 0;      // its size
    float inverse = 0;
    float margin = 0;  // of a crossing

    // At lambda `begin`: nothing is met before.
    FloatPlace(const FloatScene& scene, const GridAxis& axis, const RayAxis& ray, double begin) {
        const double place = ray.start + begin * ray.run;
        back = ray.run < 0;
        const double behind = back ? std::ceil(place) : std::floor(place);
        const double part = back ? behind - place : place - behind;
        const double size = std::abs(ray.run);
        const double alongLine = back ? scene.mirror - behind : behind;
        bool good = std::abs(alongLine) < kFloatPlaces && size <= kFloatRun && (size >= 1e-30 || size == 0);
        // Hardly moving and next to a line: the walk could begin on the wrong side of it.
        good = good && !(begin > 0 && size < kLeastRun && part < kLeastRun);
        if (scene.address == Address::Border) {
            const auto inside = [&](double at) { return at > axis.low && at < axis.high; };
            const bool left = place < axis.low || place > axis.high;
            if (inside(ray.start) && left) fit = FloatFit::Gone;
            good = good && inside(ray.start) && (left || inside(place));
        }
        if (good) line = behind, share = part, run = static_cast<float>(size);
        if (!good) fit = FloatFit::Unfit;
        inverse = 1 / std::max(run, 1e-30F);
        margin = kCrossingMargin * (inverse + 1);
    }
};

}  // namespace relief
