// What SIMD walks in double, one ray per lane, have in common: rows of lane values in memory, the queue from which
// finished lanes are refilled, and the interleaving of two vectors. Compiled for each target.

#if defined(RELIEF_DOUBLE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_DOUBLE_LANES_INL_H
#undef RELIEF_DOUBLE_LANES_INL_H
#else
#define RELIEF_DOUBLE_LANES_INL_H
#endif

#include <array>
#include <cstdint>
#include <vector>

#include "relief/ray.h"
#include "relief/simd/double_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

using D = DD;
using V = VD;
using M = MD;
constexpr std::size_t kLanes = kHalfLanes;
template <class T>
using Row = std::array<T, kLanes>;
// Integers of 31 bits (indices of cells, texels and values), and stored values.
using DI = DHI;
using VI = VHI;
using DF = DHF;

HWY_INLINE V constant(double value) {
    return hn::Set(D(), value);
}
HWY_INLINE VI whole(std::int32_t value) {
    return hn::Set(DI(), value);
}
HWY_INLINE V load(const Row<double>& from) {
    return hn::LoadU(D(), from.data());
}
HWY_INLINE void store(V from, Row<double>& to) {
    hn::StoreU(from, D(), to.data());
}
HWY_INLINE std::uint32_t bitsOf(M mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(D(), mask, bits);
    return bits[0];
}

// The rays [next, last) that a Search has yet to trace, shared by all vectors. fallback receives the indices of rays
// that the reference has to trace. segments: of each ray of the block, if only these are traced.
template <class Search>
struct RayQueue {
    const Search& search;
    const RayBlock& rays;
    HitBlock& hits;
    std::size_t next;
    std::size_t last;
    std::vector<std::size_t>& fallback;
    const Segment* segments = nullptr;

    Segment segmentOf(std::size_t number) const { return segments == nullptr ? Segment{} : segments[number]; }
};

// Receiver of the numbers of each step. Only tests record them, to compare them with the reference's log.
struct NoVisits {
    static constexpr bool kRecords = false;
};

// A vector of rays in flight, refilled from the queue. Walk provides take(lane, ray, number), which sets up the lane
// for that finite ray and returns false if it needs no walk (its hit is set, or it is in queue.fallback), and step().
template <class Walk, class Search>
class VectorOfRays {
  public:
    explicit VectorOfRays(RayQueue<Search>& queue) : queue_(queue) {}

    // Refills idle lanes and takes a step. Returns false when all rays are done.
    bool advance() {
        constexpr std::uint32_t kAll = (1U << kLanes) - 1;
        for (std::uint32_t idle = kAll & ~active_; idle != 0; idle &= idle - 1) {
            if (!fill(static_cast<std::size_t>(__builtin_ctz(idle)))) break;
        }
        if (active_ == 0) return false;
        walk().step();
        return true;
    }

  protected:
    RayQueue<Search>& queue_;
    std::uint32_t active_ = 0;
    std::array<std::size_t, kLanes> ray_{};  // their indices in the block

  private:
    Walk& walk() { return static_cast<Walk&>(*this); }
    // Refills a lane. Returns false if the queue is empty.
    bool fill(std::size_t lane) {
        while (queue_.next < queue_.last) {
            const std::size_t i = queue_.next++;
            const ViewRay ray = queue_.rays[i];
            if (!ray.finite()) {
                queue_.hits.set(i, Hit::none(Outcome::Miss));
            } else if (walk().take(lane, ray, i)) {
                ray_[lane] = i;
                active_ |= 1U << lane;
                return true;
            }
        }
        return false;
    }
};

// Runs two vectors alternately: while one waits for memory, the other proceeds.
template <class Walk, class Queue>
void runAlternating(Queue& queue) {
    Walk one(queue);
    Walk two(queue);
    bool more = true;
    while (more) {
        more = one.advance();
        more = two.advance() || more;
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
