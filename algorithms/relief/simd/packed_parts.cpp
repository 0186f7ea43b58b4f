#include "relief/simd/packed_parts.h"

#include <limits>

namespace relief {

void packedHits(const ConeGround& ground, const RayBlock& rays, const std::vector<PackedStart>& starts,
                HitBlock& hits) {
    static thread_local std::vector<PackedWalk> walks;
    walks.clear();
    for (const PackedStart& start : starts) {
        const ViewRay ray = rays[start.ray];
        if (!ray.finite() || GridRay(ground.grid, ray).entersOutside(ground.grid)) {
            hits.set(start.ray, Hit::none(Outcome::Miss));
        } else {
            walks.emplace_back(ground, FirstHit{ray}, start.ray, start.from, std::numeric_limits<double>::infinity());
        }
    }
    walkAll(ground, walks, [&](const PackedWalk& walk) { hits.set(walk.number(), walk.hit()); });
}

void packedParts(const ConeGround& ground, const RayBlock& rays, std::vector<PackedPart>& parts) {
    static thread_local std::vector<PackedWalk> walks;
    walks.clear();
    for (std::size_t n = 0; n < parts.size(); ++n) {
        walks.emplace_back(ground, FirstHit{rays[parts[n].ray]}, n, parts[n].from, parts[n].until);
    }
    walkAll(ground, walks, [&](const PackedWalk& walk) {
        PackedPart& part = parts[walk.number()];
        part.ended = !walk.paused();
        part.hit = walk.hit();
        part.x = walk.x(), part.y = walk.y();
    });
}

}  // namespace relief
