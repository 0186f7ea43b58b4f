#include "relief/lanes/cone_twin.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "relief/block_work.h"

namespace relief {

ConeTwin::ConeTwin(const HeightField& field, std::shared_ptr<const PackedCones> cones)
    : cones_(std::move(cones)), scene_(field, *cones_) {}

void ConeTwin::trace(const RayBlock& rays, HitBlock& hits, const Tracer& method, Work& work) const {
    assert(method.guarantee() == Guarantee::Exact && method.baseLevel() == 0);
    hits.resize(rays.size());
    overBlock(rays.size(), work, [&](std::size_t first, std::size_t last) {
        static thread_local LaneRays scratch;
        std::vector<std::size_t> left;
        for (std::size_t begin = first; begin < last; begin += kLaneChunk) {
            const std::size_t end = std::min(begin + kLaneChunk, last);
            traceConeLanes(scene_, *cones_, rays, begin, end, hits, scratch);
            for (std::size_t n = 0; n < scratch.othersCount; ++n) {
                const std::size_t i = begin + scratch.others[n].ray;
                if (scratch.others[n].end == LaneEnd::Scalar) left.push_back(i);
                if (scratch.others[n].end == LaneEnd::Miss) hits.set(i, Hit::none(Outcome::Miss));
            }
        }
        if (left.empty()) return;
        RayBlock some(left.size());
        for (std::size_t n = 0; n < left.size(); ++n) some.set(n, rays[left[n]]);
        HitBlock found;
        NullSink sink;
        method.trace(some, found, sink, work);
        for (std::size_t n = 0; n < left.size(); ++n) hits.set(left[n], found[n]);
    });
}

}  // namespace relief
