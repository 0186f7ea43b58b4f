// Bisection of brackets that contain a hit, in double, one ray per lane. Reference: LayersTracerOf::refined,
// ConeMarch::bisected. Compiled for each target.

#if defined(RELIEF_BISECTION_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_BISECTION_LANES_INL_H
#undef RELIEF_BISECTION_LANES_INL_H
#else
#define RELIEF_BISECTION_LANES_INL_H
#endif

#include <algorithm>

#include "relief/simd/surface_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// The part of a ray between `above`, where it is above the surface, and `below`, where it is not.
struct Bracket {
    std::size_t ray;
    ViewRay reduced;  // under repeat, with its origin in the first period
    double above;
    double below;
};

// A queue of rays whose hits are refined after the walk, all by the same number of bisections.
template <class Search>
struct BracketQueue : RayQueue<Search> {
    std::vector<Bracket> brackets;
};

// Halves the brackets and sets the hits. Visits: receives above, below and the sampled height of each bisection.
template <class Visits, class Search>
void bisect(BracketQueue<Search>& queue) {
    const SurfaceLanes surface(queue.search.field);
    Row<double> s0{}, t0{}, a{}, b{}, from{}, to{};
    for (std::size_t begin = 0; begin < queue.brackets.size(); begin += kLanes) {
        const std::size_t count = std::min(kLanes, queue.brackets.size() - begin);
        std::array<std::size_t, kLanes> numbers{};
        for (std::size_t n = 0; n < count; ++n) {
            const Bracket& bracket = queue.brackets[begin + n];
            numbers[n] = bracket.ray;
            s0[n] = bracket.reduced.s0, t0[n] = bracket.reduced.t0;
            a[n] = bracket.reduced.a, b[n] = bracket.reduced.b;
            from[n] = bracket.above, to[n] = bracket.below;
        }
        V above = load(from), below = load(to);
        const V startS = load(s0), startT = load(t0), runS = load(a), runT = load(b);
        for (int k = 0; k < queue.search.bisections; ++k) {
            const V middle = hn::Mul(constant(0.5), hn::Add(above, below));
            const V height = surface.at(hn::Add(startS, hn::Mul(middle, runS)), hn::Add(startT, hn::Mul(middle, runT)));
            const V gap = hn::Sub(height, hn::Sub(constant(1), middle));
            const M over = hn::Lt(gap, hn::Zero(D()));
            above = hn::IfThenElse(over, middle, above);
            below = hn::IfThenElse(over, below, middle);
            if constexpr (Visits::kRecords) {
                const V logged = hn::Sub(hn::Add(gap, constant(1)), middle);
                Visits::visit(numbers, (1U << count) - 1, above, below, logged);
            }
        }
        store(below, to);
        for (std::size_t n = 0; n < count; ++n) queue.hits.set(numbers[n], Hit::at(queue.rays[numbers[n]], to[n]));
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
