// The start of a ray on one axis, converted to float, for the reference walks (cone_walk.h, depth_walk.h). SIMD
// version: setUpPlaces() in simd/lane_trace-inl.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "relief/float_margins.h"
#include "relief/methods/float_scene.h"

namespace relief {

// Whether float can follow a ray. Gone: under border the ray has left the map before its walk begins.
enum class FloatFit : std::uint8_t { Fit, Gone, Unfit };

// The result for a ray from those of its two axes.
inline FloatFit bothFit(FloatFit x, FloatFit y) {
    return x == FloatFit::Unfit || y == FloatFit::Unfit ? FloatFit::Unfit : std::max(x, y);
}

// Start of a ray on one axis. An unfit ray gets a resting axis in cell 0, along which no walk is made.
struct FloatPlace {
    FloatFit fit = FloatFit::Fit;
    bool back = false;  // the ray runs towards lower indices
    double line = 0;    // the grid line at or before the start in the direction of the ray
    double share = 0;   // cells from that line to the start
    float run = 0;      // absolute value of the run, cells
    float inverse = 0;
    float margin = 0;  // largest error of a crossing, in lambda

    // The start at lambda `begin`, before which the ray does not meet the surface.
    FloatPlace(const FloatScene& scene, const GridAxis& axis, const RayAxis& ray, double begin) {
        const double place = ray.start + begin * ray.run;
        back = ray.run < 0;
        const double behind = back ? std::ceil(place) : std::floor(place);
        const double part = back ? behind - place : place - behind;
        const double size = std::abs(ray.run);
        const double alongLine = back ? scene.mirror - behind : behind;
        bool good = std::abs(alongLine) < kFloatPlaces && size <= kFloatRun && (size >= 1e-30 || size == 0);
        // A ray that hardly moves and begins next to a line could begin on the wrong side of it.
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
