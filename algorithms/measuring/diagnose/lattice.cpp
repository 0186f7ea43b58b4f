#include "measuring/diagnose/lattice.h"

#include <algorithm>
#include <cmath>

namespace relief {

Lattice latticeOf(const AnsweredRays& given) {
    constexpr double kEnd = 1e-6;
    constexpr double kMostError = 0.03;  // layers
    std::vector<double> places;
    for (const Hit& hit : given.answers) {
        // The ends of the ray are multiples of every layer.
        if (hit.outcome == Outcome::Hit && hit.lambda > kEnd && hit.lambda < 1 - kEnd) places.push_back(hit.lambda);
    }
    if (places.size() < 8) return {};
    for (int n = 2; n <= kMostLayers; ++n) {
        // The phase of most of the answers: that of one of some, which nearly all others share.
        for (std::size_t k = 0; k < 3; ++k) {
            const double phase = k == 0 ? 0 : places[places.size() * k / 3] * n;
            std::size_t on = 0;
            for (const double place : places) {
                const double at = place * n - phase;
                if (std::abs(at - std::round(at)) <= std::min(kFloatError * n * n, kMostError)) ++on;
            }
            if (on * 100 >= places.size() * 97) return {n, (phase - std::floor(phase)) / n};
        }
    }
    return {};
}

}  // namespace relief
