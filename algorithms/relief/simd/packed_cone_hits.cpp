#include "relief/simd/packed_cone_hits.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "relief/block_work.h"

namespace relief {

PackedConeHits::PackedConeHits(const HeightField& field, std::shared_ptr<const PackedCones> cones)
    : field_(field), cones_(std::move(cones)), scene_(field, *cones_) {}

void PackedConeHits::trace(const RayBlock& rays, HitBlock& hits, const Tracer& method, Work& work) const {
    assert(method.guarantee() == Guarantee::Exact && method.baseLevel() == 0);
    hits.resize(rays.size());
    overBlock(rays.size(), work, [&](std::size_t first, std::size_t last) {
        std::vector<std::size_t> flat;
        traceByCones(field_, scene_, *cones_, rays, first, last, hits, flat);
        if (flat.empty()) return;
        RayBlock some(flat.size());
        for (std::size_t n = 0; n < flat.size(); ++n) some.set(n, rays[flat[n]]);
        HitBlock found;
        NullSink sink;
        method.trace(some, found, sink, work);
        for (std::size_t n = 0; n < flat.size(); ++n) hits.set(flat[n], found[n]);
    });
}

}  // namespace relief
