#include "relief/methods/cone_rays.h"

#include <cmath>
#include <memory>

#include "relief/methods/cone_walk.h"
#include "relief/simd/cone_lanes.h"
#include "relief/simd/packed_parts.h"

namespace relief {

namespace {

// Largest number of rays that wait for each other: enough to fill vectors, few enough that the map entries near them
// remain in the cache.
constexpr std::size_t kMaxWaiting = 256;

// Rays that resume the SIMD walk, gathered from different chunks.
struct ResumedRays {
    LaneRays rays;
    alignas(64) std::array<std::array<double, kLaneSlots>, 4> columns;  // s0, t0, a, b
    std::array<std::size_t, kLaneSlots> of;                             // their indices in the block
    std::array<double, kLaneSlots> from;  // lambda before which they do not meet the surface
    HitBlock found = HitBlock(kLaneSlots);
};

// The rays of a block that the SIMD walk cannot finish. Where float cannot choose a ray's next cell, the walk in double
// takes the ray past that corner. These rays, and those whose candidate the leaf rejected, then resume the SIMD walk.
// In this way many rays wait for memory together, and no part of a ray is walked twice.
class RemainingRays {
  public:
    RemainingRays(const HeightField& field, const FloatScene& scene, const PackedCones& cones, const RayBlock& block,
                  HitBlock& hits, std::vector<std::size_t>& flat, const ConeLanes& lanes)
        : lanes_(lanes), field_(field), scene_(scene), cones_(cones), block_(block), hits_(hits), flat_(flat) {
        resumed().rays.count = 0;
    }

    // Collects the unfinished rays of the chunk that begins at ray `begin`.
    void take(std::size_t begin, const LaneRays& chunk) {
        for (std::size_t n = 0; n < chunk.othersCount; ++n) {
            const LaneRays::Other& other = chunk.others[n];
            if (other.end == LaneEnd::Miss) continue;
            if (waiting() == kMaxWaiting) resume();
            sort(other, begin + other.ray, chunk);
        }
    }
    void finish() {
        resume();
        packedHits({field_, scene_.grid, cones_}, block_, starts_, hits_);
    }

  private:
    static ResumedRays& resumed() {
        static thread_local const auto rays = std::make_unique<ResumedRays>();
        return *rays;
    }
    std::size_t waiting() const { return resumed().rays.count + parts_.size(); }

    // Queues a ray for the walk that can continue it. number: its index in the block.
    void sort(const LaneRays::Other& other, std::size_t number, const LaneRays& of) {
        if (!packedWalks(scene_.grid, block_[number])) {
            flat_.push_back(number);
        } else if (other.end == LaneEnd::Scalar) {
            starts_.push_back({number, 0});
        } else {
            const auto cell = [&](const LaneAxisRays& axis) {
                return AxisCell{axis.hitCell[other.ray], axis.hitPeriod[other.ray]};
            };
            const AmbiguousPart part(scene_.grid, GridRay(scene_.grid, block_[number]), cell(of.x), cell(of.y));
            if (other.end == LaneEnd::FalseCandidate) {
                add(number, cell(of.x), cell(of.y), part.from, false);
            } else if (std::isfinite(part.until)) {
                parts_.push_back({number, part.from, part.until});
            } else {
                starts_.push_back({number, part.from});
            }
        }
    }
    void add(std::size_t number, const AxisCell& x, const AxisCell& y, double from, bool within) {
        ResumedRays& to = resumed();
        const std::size_t at = to.rays.count++;
        to.columns[0][at] = block_.s0[number], to.columns[1][at] = block_.t0[number];
        to.columns[2][at] = block_.a[number], to.columns[3][at] = block_.b[number];
        to.rays.x.hitCell[at] = x.index, to.rays.x.hitPeriod[at] = static_cast<std::int32_t>(x.base);
        to.rays.y.hitCell[at] = y.index, to.rays.y.hitPeriod[at] = static_cast<std::int32_t>(y.base);
        to.rays.within[at] = within ? 1 : 0;
        to.of[at] = number;
        to.from[at] = from;
    }

    void resume() {
        for (int times = 0; waiting() > 0; ++times) {
            passCorners();
            if (resumed().rays.count == 0) break;
            if (times < kMostReturns) {
                resumeSimd();
            } else {
                leave();
            }
        }
    }
    void passCorners() {
        packedParts({field_, scene_.grid, cones_}, block_, parts_);
        for (const PackedPart& part : parts_) {
            if (part.ended) {
                hits_.set(part.ray, part.hit);
            } else {
                add(part.ray, part.x, part.y, part.until, true);
            }
        }
        parts_.clear();
    }
    void resumeSimd() {
        ResumedRays& all = resumed();
        const double* const columns[] = {all.columns[0].data(), all.columns[1].data(), all.columns[2].data(),
                                         all.columns[3].data()};
        lanes_.resume(scene_, cones_, columns, all.rays, all.found);
        for (std::size_t n = 0; n < all.rays.count; ++n) {
            const std::size_t i = all.of[n];
            hits_.lambda[i] = all.found.lambda[n];
            hits_.s[i] = all.found.s[n];
            hits_.t[i] = all.found.t[n];
        }
        // The rays are overwritten in place, which is safe because others are in the order of their rays.
        all.rays.count = 0;
        for (std::size_t n = 0; n < all.rays.othersCount; ++n) {
            const LaneRays::Other other = all.rays.others[n];
            const std::size_t number = all.of[other.ray];
            if (other.end == LaneEnd::Miss) {
                hits_.set(number, Hit::none(Outcome::Miss));
            } else {
                sort(other, number, all.rays);
            }
        }
    }
    void leave() {
        ResumedRays& all = resumed();
        for (std::size_t n = 0; n < all.rays.count; ++n) {
            packedWalks(scene_.grid, block_[all.of[n]]) ? starts_.push_back({all.of[n], all.from[n]})
                                                        : flat_.push_back(all.of[n]);
        }
        all.rays.count = 0;
    }

    const ConeLanes& lanes_;
    const HeightField& field_;
    const FloatScene& scene_;
    const PackedCones& cones_;
    const RayBlock& block_;
    HitBlock& hits_;
    std::vector<std::size_t>& flat_;
    std::vector<PackedPart> parts_;
    std::vector<PackedStart> starts_;
};

}  // namespace

void traceByCones(const ConeLanes& lanes, const HeightField& field, const FloatScene& scene, const PackedCones& cones,
                  const RayBlock& rays, std::size_t first, std::size_t last, HitBlock& hits,
                  std::vector<std::size_t>& flat) {
    RemainingRays leftovers(field, scene, cones, rays, hits, flat, lanes);
    traceChunks(
        first, last, hits,
        [&](std::size_t begin, std::size_t end, LaneRays& scratch) {
            lanes.trace(scene, cones, rays, begin, end, hits, scratch);
        },
        [&](std::size_t begin, const LaneRays& scratch) { leftovers.take(begin, scratch); });
    leftovers.finish();
}

void traceByCones(const HeightField& field, const FloatScene& scene, const PackedCones& cones, const RayBlock& rays,
                  std::size_t first, std::size_t last, HitBlock& hits, std::vector<std::size_t>& flat) {
    traceByCones({&traceConeLanes, &resumeConeLanes}, field, scene, cones, rays, first, last, hits, flat);
}

}  // namespace relief
