#include "rendering/flat_ground.h"

#include <algorithm>
#include <cmath>

namespace relief {

namespace {

// Margin around a reach, texels: larger than the rounding error of coordinates up to 10^6.
constexpr double kRounding = 1e-6;

struct Box {
    double s0 = std::numeric_limits<double>::infinity();
    double t0 = std::numeric_limits<double>::infinity();
    double s1 = -std::numeric_limits<double>::infinity();
    double t1 = -std::numeric_limits<double>::infinity();

    void add(double s, double t) {
        s0 = std::min(s0, s);
        s1 = std::max(s1, s);
        t0 = std::min(t0, t);
        t1 = std::max(t1, t);
    }
};

}  // namespace

std::shared_ptr<const HeightBoundsMap> groundBounds(const HeightField& field, Work& work) {
    int shift = 0;
    while ((std::max(field.width(), field.height()) >> shift) > kGroundBlocks) ++shift;
    return std::make_shared<const HeightBoundsMap>(coarseHeightBounds(field, shift, work));
}

FlatGround::FlatGround(HeightField field, std::shared_ptr<const HeightBoundsMap> bounds, bool flat, double bound)
    : field_(std::move(field)), bounds_(std::move(bounds)), leaf_(field_), flat_(flat), bound_(bound) {
    all_ = {bounds_->lowest.level(bounds_->lowest.levels() - 1)(0, 0),
            bounds_->highest.level(bounds_->highest.levels() - 1)(0, 0)};
    const double least = bounds_->smallestRange;
    never_ = !(flat_ && least <= 0) && !(bound_ > 0 && parallaxError(0, {0, least}) <= bound_);
}

std::optional<HeightBounds> FlatGround::reach(const RayBlock& rays, std::span<const std::size_t> which) const {
    HeightBounds reached = all_;
    for (int pass = 0; pass < 2; ++pass) {
        // The path is a straight line, so its two ends bound it.
        const double first = 1 - reached.high;
        const double last = 1 - reached.low;
        Box box;
        for (const std::size_t i : which) {
            const ViewRay ray = rays[i];
            // The limit is below the run up to which tracers are exact, and the comparison is false for NaN.
            if (!(ray.a * ray.a + ray.b * ray.b <= 0.99 * kMaxRun * kMaxRun)) return std::nullopt;
            box.add(ray.s0 + first * ray.a, ray.t0 + first * ray.b);
            box.add(ray.s0 + last * ray.a, ray.t0 + last * ray.b);
        }
        const bool leaves = box.s0 < 0 || box.t0 < 0 || box.s1 > field_.width() || box.t1 > field_.height();
        if (leaves && field_.address() == Address::Border) return std::nullopt;
        reached = heightBounds(*bounds_, field_, box.s0 - kRounding, box.t0 - kRounding, box.s1 + kRounding,
                               box.t1 + kRounding);
    }
    return reached;
}

Ground FlatGround::ground(const RayBlock& rays, std::span<const std::size_t> which, const HeightBounds& reached) const {
    if (flat_ && !(reached.low < reached.high)) return Ground::Flat;
    if (!(bound_ > 0)) return Ground::Search;
    double run = 0;
    for (const std::size_t i : which) run = std::max(run, std::hypot(rays.a[i], rays.b[i]));
    return parallaxError(run, reached) <= bound_ ? Ground::LittleParallax : Ground::Search;
}

Hit FlatGround::flatHit(const ViewRay& ray, double height) const {
    NullSink sink;
    // The search starts just above the ground, by the margin within which the leaf's rounding may still report a hit,
    // as in the pyramid tracers.
    const double start = std::max(0.0, 1 - height - kExclusionMargin);
    return leaf_.traceSegment(ray, {start, 1}, sink);
}

}  // namespace relief
