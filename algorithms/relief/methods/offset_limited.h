// offset-limited: as `offset`, without the division by V_z, so that the shift never exceeds the depth of the relief.
// Welsh 2004 ([DIST17] uses this name for the formula of `offset`).
//
// Frame and units: ray.h. Surfaces: bilinear, columns; any addressing.
// Model: (a, b) is replaced by (a, b) D / sqrt(a^2 + b^2 + D^2), D = relief_depth * W texels.
// Guarantee: none. Failure mode: grazing rays look flat instead of swimming.
// Cost: one height.
#pragma once

#include "relief/methods/offset.h"
#include "relief/ray_length.h"

namespace relief {

class OffsetLimitedTracer {
  public:
    struct Options {
        static std::vector<OptionField<Options>> fields() { return {}; }
    };
    static MethodDescription describe() {
        MethodDescription method;
        method.name = "offset-limited";
        method.title = "parallax offset, limited";
        method.guarantee = Guarantee::Approximate;
        method.tiled = true;
        method.help = "One sample, with the shift limited to the depth of the relief.";
        method.source = "Welsh 2004";
        return method;
    }
    static OffsetLimitedTracer make(const HeightField& field, const Options&, MapCache&, Work&) {
        return OffsetLimitedTracer(field);
    }

    explicit OffsetLimitedTracer(HeightField field) : field_(std::move(field)) {}

    template <class Sink>
    Hit trace(const ViewRay& ray, Sink& sink) const {
        return OffsetTracer::shifted(field_, ray, share(ray), sink);
    }
    template <class Sink>
    Hit traceSegment(const ViewRay& ray, Segment segment, Sink& sink) const {
        return OffsetTracer::shiftedWithin(field_, ray, segment, share(ray), sink);
    }
    // The SIMD version, with the same results: sets hits for the rays first to last - 1.
    void traceSimd(const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits) const {
        NullSink sink;
        for (const std::size_t i : offsetSimd({field_, true}, rays, first, last, hits)) {
            hits.set(i, trace(rays[i], sink));
        }
    }
    double segmentRecords() const { return 3; }

    const HeightField& field() const { return field_; }
    std::size_t bytes() const { return 0; }
    double stepBound(const ViewRay&) const { return 2; }

  private:
    double share(const ViewRay& ray) const {
        const double length = texelsPerLambda(ray.a, ray.b, field_.slabTexels());
        // For a vertical ray through a slab without thickness there is nothing to limit.
        return length > 0 ? field_.slabTexels() / length : 1.0;
    }

    HeightField field_;
};

}  // namespace relief
