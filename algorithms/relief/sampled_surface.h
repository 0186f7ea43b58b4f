// What methods that only sample the surface at points share: the height below a point of the ray, and whether the point
// is on the picture.
#pragma once

#include <algorithm>
#include <cmath>

#include "relief/cell_grid.h"
#include "relief/leaf.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace relief {

class SampledSurface {
  public:
    // Under repeat the origin is reduced to the first period, since distant coordinates would lose precision.
    SampledSurface(const HeightField& field, const ViewRay& ray) : field_(field), ray_(ray) {
        if (field.address() != Address::Repeat) return;
        ray_.s0 = reduceToPeriod(ray.s0, field.width());
        ray_.t0 = reduceToPeriod(ray.t0, field.height());
    }

    double heightAt(double lambda) const { return field_.at(ray_.s0 + lambda * ray_.a, ray_.t0 + lambda * ray_.b); }
    // Texel coordinates of the ray at lambda; under repeat relative to the period of its origin.
    std::pair<double, double> placeAt(double lambda) const {
        return {ray_.s0 + lambda * ray_.a, ray_.t0 + lambda * ray_.b};
    }
    // Surface minus ray, in heights: 0 or more where the ray has reached the surface.
    double gapAt(double lambda) const { return heightAt(lambda) - (1 - lambda); }
    // Whether the point at lambda counts: under border only points over the picture do.
    bool inside(double lambda) const {
        if (field_.address() != Address::Border) return true;
        const double s = ray_.s0 + lambda * ray_.a;
        const double t = ray_.t0 + lambda * ray_.b;
        return s >= 0 && s <= field_.width() && t >= 0 && t <= field_.height();
    }
    std::uint32_t readsEach() const { return leafReads(field_.surface()); }

    // A record of the surface height `value` sampled at lambda = out, with the texel below the ray there.
    Step record(Phase phase, Decision decision, double in, double out, double value, double after) const {
        Step step;
        step.phase = phase;
        step.decision = decision;
        step.subject = subject::Point{value};
        const double s = std::floor(ray_.s0 + out * ray_.a);
        const double t = std::floor(ray_.t0 + out * ray_.b);
        const double w = field_.width();
        const double h = field_.height();
        if (field_.address() == Address::Repeat) {
            step.periodX = periods(s, w);
            step.periodY = periods(t, h);
            step.i = static_cast<std::int64_t>(s - static_cast<double>(step.periodX) * w);
            step.j = static_cast<std::int64_t>(t - static_cast<double>(step.periodY) * h);
        } else {
            step.i = static_cast<std::int64_t>(std::clamp(s, 0.0, w - 1));
            step.j = static_cast<std::int64_t>(std::clamp(t, 0.0, h - 1));
        }
        step.lambdaIn = in;
        step.lambdaOut = out;
        step.value = value;
        step.lambdaAfter = after;
        return step;
    }

    // The sphere of the given radius, in texels, around the point at lambda.
    subject::Sphere sphereAt(double lambda, double radius) const {
        const auto [s, t] = placeAt(lambda);
        return {s, t, 1 - lambda, radius};
    }

  private:
    // 0 where the index is so large that doubles cannot represent its period.
    static std::int64_t periods(double index, double size) {
        const double n = std::floor(index / size);
        return std::abs(n) < 0x1p53 ? static_cast<std::int64_t>(n) : 0;
    }

    const HeightField& field_;
    ViewRay ray_;
};

}  // namespace relief
