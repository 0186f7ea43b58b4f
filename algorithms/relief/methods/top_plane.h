// What the shading-only methods share: the ray stops on the top plane. They do not change texture coordinates; only
// lighting shows the relief, by a normal (MethodDescription::shading).
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: the hit is where the ray enters, lambda = 0; under border a ray that enters outside the picture is a miss.
// Guarantee: none. Failure mode: no parallax, no silhouettes, no occlusion. Cost: no stored values are fetched.
#pragma once

#include "relief/describe.h"
#include "relief/map_cache.h"
#include "relief/sampled_surface.h"

namespace relief {

class TopPlaneTracer {
  public:
    struct Options {
        static std::vector<OptionField<Options>> fields() { return {}; }
    };

    explicit TopPlaneTracer(HeightField field) : field_(std::move(field)) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        if (!ray.finite()) return Hit::none(Outcome::Miss);
        const SampledSurface surface(field_, ray);
        const bool inside = surface.inside(0);
        const auto record = [&](Phase phase, Decision decision) {
            sink.step([&] { return surface.record(phase, decision, 0, 0, 1, 0); });
        };
        record(Phase::Start, Decision::Start);
        record(Phase::Search, inside ? Decision::Hit : Decision::Miss);
        return inside ? Hit::at(ray, 0.0) : Hit::none(Outcome::Miss);
    }

    const HeightField& field() const { return field_; }
    std::size_t bytes() const { return 0; }
    double stepBound(const ViewRay&) const { return 2; }

  protected:
    static MethodDescription shading(ShadingNormal normal) {
        MethodDescription method;
        method.kind = MethodKind::Shading;
        method.guarantee = Guarantee::Approximate;
        method.rayClass = RayClass::AnyRays;
        method.shading = normal;
        return method;
    }

  private:
    HeightField field_;
};

}  // namespace relief
