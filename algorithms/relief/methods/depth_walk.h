// The walk down and up the pyramid of depths for one ray: the reference of simd/pyramid_lanes-inl.h. Both use the same
// precision and the same margins (margins.md), so that they visit the same nodes, except where fused multiply-adds
// round to another decision (DepthNodes). Float only excludes nodes and cells; the leaf decides where a ray hits the
// surface in a cell.
//
// Frame: float_scene.h. Node k of level l begins with cell k << l; cells are mirrored where the ray runs towards lower
// indices. The line before cell c is crossed at lambda = (c + offset) * inverse + base, which is at or after the true
// crossing, later by no more than `tie` for both axes together.
#pragma once

#include <bit>

#include "relief/float_leaf.h"
#include "relief/maps/depth_pyramid.h"
#include "relief/methods/float_place.h"
#include "relief/methods/pyramid_walk.h"

namespace relief {

// Number of levels below the smallest level whose nodes exceed the ray's run along its longer axis at which a walk
// starts. Chosen, not tuned.
inline constexpr int kStartBelow = 2;
inline int startLevel(float run, int top) {
    return std::clamp(static_cast<int>(std::bit_width(static_cast<unsigned>(run))) - kStartBelow, 0, top);
}

// One axis of a ray.
struct DepthAxis {
    bool back = false;
    int mirror = 0;  // node k of the walk is node k ^ (mirror >> level) of the map
    int k = 0;
    int offset = 0;
    int first = 0;  // cell of the ray's start, mirrored, before addressing is applied
    int low = 0;    // the map's first cell, mirrored
    int high = 0;   // one past the map's last cell, mirrored
    float run = 0, inverse = 0, base = 0;
    float rim = 0;  // border: lambda at which the ray leaves the map

    // The axis on level 0, at lambda `begin`.
    DepthAxis(const FloatScene& scene, const GridAxis& axis, const RayAxis& ray, const FloatPlace& place, double begin)
        : back(place.back),
          mirror(place.back ? scene.mirror - 1 : 0),
          first(static_cast<int>(place.back ? scene.mirror - place.line : place.line)),
          low(place.back ? scene.mirror - axis.cells : 0),
          high(low + axis.cells),
          run(place.run),
          inverse(place.inverse) {
        base = (static_cast<float>(begin) - static_cast<float>(place.share) * inverse) + place.margin;
        k = std::clamp(first, low, high - 1);
        if (scene.address == Address::Repeat) {
            const int along = (first - low) % axis.cells;
            k = low + (along < 0 ? along + axis.cells : along);
        }
        offset = scene.address == Address::Repeat ? -k : -first;
        if (scene.address != Address::Border) return;
        const double toRim = back ? ray.start - axis.low : axis.high - ray.start;
        rim = inverse * kCrossingMargin + (std::min(static_cast<float>(toRim) * inverse, 1e30F) + kCrossingMargin);
    }

    float lambdaAt(int line) const { return static_cast<float>(line + offset) * inverse + base; }
    // The node of the map, and the period that contains it.
    AxisCell node(int level) const { return {k ^ (mirror >> level), back ? -(offset + first) : offset + first}; }

    struct Crossing {
        float lambda;
        bool last;  // the line is the edge of the map or of its period
    };
    Crossing crossing(Address address, int level) const {
        const int edge = std::min((k + 1) << level, high);
        const bool last = edge == high;
        constexpr float kNever = 1e30F;
        if (last && address == Address::Clamp) return {kNever, last};
        return {last && address == Address::Border ? rim : lambdaAt(edge), last};
    }
    void toChild(int below, float certain) {
        const int middle = (2 * k + 1) << below;
        // The line through the start and those before it are behind the ray, however slowly it moves.
        const bool far = middle + offset <= 0 || certain >= lambdaAt(middle);
        k = 2 * k + ((far || middle <= low) && middle < high ? 1 : 0);
    }
    // Moves to the next node.
    void advance(Address address, const Crossing& crossing, int level) {
        if (!crossing.last || address != Address::Repeat) {
            ++k;
            return;
        }
        k = low >> level;
        offset += high - low;
    }
};

// The walk for one field and its pyramid of depths. Thread-safe.
class DepthWalk {
  public:
    // depths: those of the walk's map; not owned, must outlive the walk.
    DepthWalk(const PyramidWalk& walk, const DepthPyramid& depths)
        : depths_(depths), scene_(walk.field(), depths.highest, 1 << depths.top) {}

    // Unfit: float cannot follow the ray. Fallback: float cannot choose the next node, the leaf found no hit in a
    // candidate cell, or the walk reached lambda 1; the walk in double takes over.
    enum class End : std::uint8_t { Hit, Miss, Unfit, Fallback };
    struct Answer {
        End end = End::Unfit;
        double lambda = 0;  // of the hit, or from which the log continues
        double from = 0;    // Fallback: the ray does not meet the surface before this lambda
    };
    template <class Sink>
    Answer trace(const PyramidWalk& walk, const GridRay& exact, Sink& sink) const;

    const FloatScene& scene() const { return scene_; }

  private:
    struct Ray {
        DepthAxis x, y;
        int level;
        float lambda, tie;
        PyramidNode node() const { return {x.node(level), y.node(level)}; }
    };
    struct Crossings {
        DepthAxis::Crossing x, y;
        float out() const { return std::min(std::min(x.lambda, y.lambda), 1.0F); }
    };

    float depthAt(const PyramidNode& node, int level) const {
        return static_cast<float>(depths_.depth(level, node.x.index, node.y.index)) * static_cast<float>(kDepthUnit);
    }
    bool below(const PyramidWalk& walk, const Ray& ray, float out) const;
    bool neighbourClear(const Ray& ray, bool alongX, const Crossings& cross) const;
    bool cornerClear(const Ray& ray, const Crossings& cross) const {
        return ray.tie + ray.tie < std::min(ray.x.inverse, ray.y.inverse) && neighbourClear(ray, true, cross) &&
               neighbourClear(ray, false, cross);
    }
    std::optional<End> moveOn(Ray& ray, const Crossings& cross) const;

    const DepthPyramid& depths_;
    FloatScene scene_;
};

// Returns true if the surface in the ray's cell is certainly below the ray.
inline bool DepthWalk::below(const PyramidWalk& walk, const Ray& ray, float out) const {
    if (scene_.surface == Surface::Columns)
        return false;  // the height of the column is that of its node, which was tested
    const auto cellAxis = [](const DepthAxis& axis) {
        return FloatCellAxis{static_cast<float>(axis.k + axis.offset), axis.base, axis.run, axis.back};
    };
    const float entered = std::max(ray.x.lambdaAt(ray.x.k), ray.y.lambdaAt(ray.y.k));
    const float in = std::min(std::max(entered - ray.tie, 0.0F), out);
    const PyramidNode cell = ray.node();
    const std::array<float, 4> corners = withHeights(walk.field(), [&](const auto& heights) {
        return cellCorners<float>(heights, scene_.grid, cell.x.index, cell.y.index);
    });
    return patchBelow(corners, cellAxis(ray.x), cellAxis(ray.y), in, out, ray.tie);
}

// Returns true if the ray is certainly above the neighbouring node along one axis until it has passed the corner.
inline bool DepthWalk::neighbourClear(const Ray& ray, bool alongX, const Crossings& cross) const {
    const DepthAxis::Crossing& line = alongX ? cross.x : cross.y;
    if (line.last && scene_.address != Address::Repeat) return scene_.address == Address::Clamp;
    Ray next = ray;
    (alongX ? next.x : next.y).advance(scene_.address, line, ray.level);
    return cross.out() + (ray.tie + ray.tie) < depthAt(next.node(), ray.level);
}

// Moves to the next node, and to its parent if the parent changed; returns an end if the walk stops.
inline std::optional<DepthWalk::End> DepthWalk::moveOn(Ray& ray, const Crossings& cross) const {
    const float x = cross.x.lambda, y = cross.y.lambda;
    float out = cross.out();
    if (out >= 1) return End::Fallback;
    // The ray passes too close to a corner to decide which neighbour comes first. If both can be skipped, the order
    // does not matter.
    const bool near = std::abs(x - y) < ray.tie;
    if (near && !cornerClear(ray, cross)) return End::Fallback;
    if (near) out = std::max(x, y);
    const bool moveX = near || x <= y, moveY = near || y <= x;
    const int oldX = ray.x.k, oldY = ray.y.k;
    if (moveX) ray.x.advance(scene_.address, cross.x, ray.level);
    if (moveY) ray.y.advance(scene_.address, cross.y, ray.level);
    const bool left = (moveX && cross.x.last) || (moveY && cross.y.last);
    ray.lambda = out;
    if (left && scene_.address == Address::Border) return End::Miss;
    const bool changed = ((oldX ^ ray.x.k) | (oldY ^ ray.y.k)) > 1 || (left && scene_.address == Address::Repeat);
    if (changed && ray.level < depths_.top) ray.x.k >>= 1, ray.y.k >>= 1, ++ray.level;
    return std::nullopt;
}

template <class Sink>
DepthWalk::Answer DepthWalk::trace(const PyramidWalk& walk, const GridRay& exact, Sink& sink) const {
    const FloatPlace placeX(scene_, scene_.grid.x, exact.x, scene_.start);
    const FloatPlace placeY(scene_, scene_.grid.y, exact.y, scene_.start);
    const FloatFit fit = bothFit(placeX.fit, placeY.fit);
    if (fit == FloatFit::Unfit) return {};
    const int level = startLevel(std::max(placeX.run, placeY.run), depths_.top);
    Ray ray{{scene_, scene_.grid.x, exact.x, placeX, scene_.start},
            {scene_, scene_.grid.y, exact.y, placeY, scene_.start},
            level,
            static_cast<float>(scene_.start),
            (placeX.margin + placeY.margin) + (placeX.margin + placeY.margin)};
    ray.x.k >>= level, ray.y.k >>= level;
    double lambda = scene_.start;
    // The highest point is that of the top node, though the walk begins on a lower level.
    const auto above = [&](Decision decision, double after) {
        return walk.record(decision, depths_.top, walk.topNode(exact, 0), 0, after, depths_.highest, after);
    };
    sink.read(1);
    sink.step([&] { return above(Decision::Start, 0); });
    if (lambda > 0) sink.step([&] { return above(Decision::Advance, lambda); });
    const auto missed = [&](const PyramidNode& node, double value) {
        sink.step([&] { return walk.record(Decision::Miss, ray.level, node, lambda, lambda, value, lambda); });
        return Answer{End::Miss, lambda, lambda};
    };
    if (fit == FloatFit::Gone) return missed(ray.node(), depths_.highest);
    while (true) {
        const int at = ray.level;
        const PyramidNode node = ray.node();
        const Crossings cross{ray.x.crossing(scene_.address, at), ray.y.crossing(scene_.address, at)};
        const float depth = depthAt(node, at);
        const double value = 1 - static_cast<double>(depth);
        // The log stores the exact exit of the node; float places it slightly later.
        double out = lambda;
        if constexpr (!std::is_same_v<Sink, NullSink>) {
            out = std::clamp(walk.exit(exact, at, node).first(), lambda, 1.0);
        }
        sink.read(1);
        const bool skip = cross.out() < depth;
        if (!skip && at > 0) {
            sink.step([&] { return walk.descent(exact, at, node, lambda, out, value); });
            const float certain = ray.lambda - ray.tie;
            ray.x.toChild(at - 1, certain), ray.y.toChild(at - 1, certain);
            --ray.level;
            continue;
        }
        const double from = std::max(static_cast<double>(ray.lambda - ray.tie), scene_.start);
        if (!skip) {
            sink.read(walk.leafReads());
            const bool excluded = below(walk, ray, cross.out());
            if (const auto met = excluded ? std::nullopt : walk.leaf(exact, node)) {
                sink.step([&] { return walk.record(Decision::Hit, 0, node, lambda, out, value, *met); });
                return {End::Hit, *met, lambda};
            }
            sink.step([&] { return walk.record(Decision::Test, 0, node, lambda, out, value, out); });
            if (!excluded) return {End::Fallback, out, from};
        } else {
            sink.step([&] { return walk.record(Decision::Skip, at, node, lambda, out, value, out); });
        }
        lambda = out;
        if (const auto end = moveOn(ray, cross)) {
            return *end == End::Miss ? missed(node, value) : Answer{End::Fallback, lambda, from};
        }
        if (ray.level > at) {
            PyramidNode left = node;
            PyramidWalk::toParent(left);
            sink.step([&] {
                const double highest = 1 - static_cast<double>(depthAt(left, ray.level));
                return walk.record(Decision::Ascend, ray.level, left, lambda, lambda, highest, lambda);
            });
        }
    }
}

}  // namespace relief
