// Relaxed cones. Policarpo & Oliveira 2007 (GPU Gems 3, ch. 18), along sampled azimuths.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "relief/maps/cone_builders.h"

namespace relief {

namespace {

// Upper limit of slopes: wider cones have no benefit, and a limit keeps the resolution of the codes high.
constexpr double kSteepest = 8.0;

// The slope kappa (height per texel) of the widest cone with its apex at h[0] of a profile h[0], h[1], ... such that a
// ray from above the apex (at the top of the slab) that enters the surface at sample j leaves it only outside of the
// cone.
double relaxedSlope(const std::vector<double>& h) {
    double kappa = 0;
    const auto count = static_cast<int>(h.size());
    for (int j = 1; j < count; ++j) {
        // The ray leaves the surface no nearer than j and no higher than h[j].
        if (h[static_cast<std::size_t>(j)] - h.front() <= kappa * j) continue;
        // The ray from (0, 1) to (j, h[j]); it leaves where it is above the profile again.
        const double slope = (h[static_cast<std::size_t>(j)] - 1) / j;
        bool inside = false;
        for (int k = j; k < count; ++k) {
            const double ray = 1 + slope * k;
            if (ray < h[static_cast<std::size_t>(k)]) inside = true;
            if (!inside || ray < h[static_cast<std::size_t>(k)]) continue;
            const double rise = ray - h.front();
            if (rise > 0) kappa = std::max(kappa, rise / k);
            break;
        }
    }
    return kappa;
}

}  // namespace

void relaxedCones(const HeightField& field, int directions, int radius, std::vector<float>& slopes, Work& work) {
    const int reach = std::min(radius, std::max(field.width(), field.height()));
    work.progress().begin("map relaxed-cone", field.height());
    parallelFor(work, field.height(), [&](int y) {
        std::vector<double> profile(static_cast<std::size_t>(reach) + 1);
        for (int x = 0; x < field.width(); ++x) {
            double kappa = 0;
            for (int n = 0; n < directions; ++n) {
                const double angle = 2 * std::numbers::pi * n / directions;
                for (int r = 0; r <= reach; ++r) {
                    profile[static_cast<std::size_t>(r)] =
                        field.at(x + 0.5 + r * std::cos(angle), y + 0.5 + r * std::sin(angle));
                }
                kappa = std::max(kappa, relaxedSlope(profile));
            }
            slopes[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.width()) +
                   static_cast<std::size_t>(x)] = static_cast<float>(std::min(kappa, kSteepest));
        }
        work.progress().advance();
    });
}

}  // namespace relief
