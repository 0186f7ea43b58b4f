// Beams: 64 consecutive rays (a square of pixels) begin together with one cone walk of their bounding box, as long as
// one cone is clear of all of them. Compiled for each target.
//
// All runs have the signs of the quadrant. At lambda the rays are within [low + lambda slowest, high + lambda fastest]
// on both axes, and from then on in the quadrant of the cell that contains the lower corner. A ray at a distance g
// beyond this cell, in the maximum norm, is free above A + kappa g; g grows at most at the fastest run.

#if defined(RELIEF_CONE_BEAMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_BEAMS_INL_H
#undef RELIEF_CONE_BEAMS_INL_H
#else
#define RELIEF_CONE_BEAMS_INL_H
#endif

#include "relief/maps/packed_cones.h"
#include "relief/simd/lane_trace-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

inline constexpr std::size_t kBeamRays = 64;
inline constexpr std::size_t kChunkBeams = kLaneChunk / kBeamRays;  // one or a few vectors
// Wider boxes, in texels, are not walked as beams. Steps shorter than kLeastLead texels are left to the single rays.
inline constexpr double kWidestBeam = 64;
inline constexpr double kLeastLead = 0.5;
inline constexpr int kMostLeads = 24;

inline constexpr std::size_t kQuadrants = 4;

// The quadrant of all rays, or kQuadrants if they have none in common.
inline std::size_t commonQuadrant(const double* a, const double* b, std::size_t count) {
    const DD d;
    const auto sign = [&](const double* runs) {
        MD every = hn::FirstN(d, kHalfLanes), any = hn::MaskFromVec(hn::Zero(d));
        std::size_t i = 0;
        for (; i + kHalfLanes <= count; i += kHalfLanes) {
            const MD back = hn::Lt(hn::LoadU(d, runs + i), hn::Zero(d));
            every = hn::And(every, back), any = hn::Or(any, back);
        }
        bool all = count >= kHalfLanes ? hn::AllTrue(d, every) : runs[0] < 0;
        bool some = !hn::AllFalse(d, any);
        for (; i < count; ++i) all = all && runs[i] < 0, some = some || runs[i] < 0;
        return all ? 1 : (some ? 2 : 0);
    };
    const int x = sign(a), y = sign(b);
    return x == 2 || y == 2 ? kQuadrants : static_cast<std::size_t>(x + 2 * y);
}

// One axis of beams, mirrored; one value per beam, padded to whole vectors.
struct BeamAxis {
    alignas(64) std::array<double, kChunkBeams> low, high, slowest, fastest;
};

inline void measureBeams(const GridAxis& axis, const double* origins, const double* runs, std::size_t beams,
                         bool mirrored, BeamAxis& out) {
    const DD d;
    for (std::size_t n = 0; n < beams; ++n) {
        const double* s = origins + n * kBeamRays;
        const double* run = runs + n * kBeamRays;
        VD low = hn::LoadU(d, s), high = low, slowest = hn::LoadU(d, run), fastest = slowest;
        for (std::size_t i = kHalfLanes; i < kBeamRays; i += kHalfLanes) {
            const VD si = hn::LoadU(d, s + i), runI = hn::LoadU(d, run + i);
            low = hn::Min(low, si), high = hn::Max(high, si);
            slowest = hn::Min(slowest, runI), fastest = hn::Max(fastest, runI);
        }
        const double least = hn::GetLane(hn::MinOfLanes(d, low)) + axis.shift;
        const double most = hn::GetLane(hn::MaxOfLanes(d, high)) + axis.shift;
        const double back = hn::GetLane(hn::MinOfLanes(d, slowest)), forth = hn::GetLane(hn::MaxOfLanes(d, fastest));
        out.low[n] = mirrored ? -most : least;
        out.high[n] = mirrored ? -least : most;
        out.slowest[n] = mirrored ? -forth : back;
        out.fastest[n] = mirrored ? -back : forth;
    }
    for (auto* values : {&out.low, &out.high, &out.slowest, &out.fastest}) {
        std::fill(values->begin() + static_cast<std::ptrdiff_t>(beams), values->end(), values->front());
    }
}

template <Address kAddress>
class BeamWalk {
  public:
    BeamWalk(const FloatScene& scene, const PackedCones& cones, std::uint32_t quadrant)
        : scene_(scene),
          entries_(reinterpret_cast<const std::int32_t*>(cones.quadrant(quadrant))),
          stride_(cones.stride),
          unit_(cones.unit),
          top_(1 - cones.highest),
          mirroredX_((quadrant & 1U) != 0),
          mirroredY_((quadrant & 2U) != 0) {}

    // Advances lambda for each beam (padded to whole vectors) to a value before which none of its rays meets the
    // surface. All beams take a step, one vector after the other, so that their memory accesses overlap.
    void lead(const BeamAxis& x, const BeamAxis& y, std::size_t beams, double* lambda) const {
        std::array<bool, kChunkBeams> on{};
        std::fill_n(on.begin(), beams, true);
        bool any = true;
        for (int n = 0; n < kMostLeads && any; ++n) {
            any = false;
            for (std::size_t g = 0; g < beams; g += kHalfLanes) {
                if (on[g]) any |= on[g] = leadOn(x, y, g, lambda + g);
            }
        }
    }

  private:
    // Takes a step with a vector of beams. Returns true if one of them advanced; a beam that does not advance never
    // will again.
    HWY_INLINE bool leadOn(const BeamAxis& x, const BeamAxis& y, std::size_t g, double* to) const {
        const DD d;
        const auto load = [&](const std::array<double, kChunkBeams>& from) { return hn::Load(d, from.data() + g); };
        const VD lambda = hn::Load(d, to);
        const VD lowX = load(x.low), highX = load(x.high), slowX = load(x.slowest), fastX = load(x.fastest);
        const VD lowY = load(y.low), highY = load(y.high), slowY = load(y.slowest), fastY = load(y.fastest);
        const VD fastest = hn::Max(fastX, fastY);
        const VD one = hn::Set(d, 1.0);
        const VD widest = hn::Set(d, kWidestBeam), far = hn::Set(d, kFloatRun);
        const MD fit = hn::And(
            hn::And(hn::Lt(hn::Sub(highX, lowX), widest), hn::Lt(hn::Sub(highY, lowY), widest)),
            hn::And(hn::Lt(fastest, far), hn::Lt(hn::Max(hn::Abs(lowX), hn::Abs(lowY)), hn::Set(d, kFloatPlaces))));
        const VD cellX = hn::Floor(hn::Add(lowX, hn::Mul(lambda, slowX)));
        const VD cellY = hn::Floor(hn::Add(lowY, hn::Mul(lambda, slowY)));
        const auto entry = entryAt(fit, cellX, cellY);
        const VD kappa = hn::PromoteTo(d, hn::BitCast(DHF(), entry));
        const auto bits = hn::And(hn::ShiftRight<10>(entry), hn::Set(DHI(), static_cast<std::int32_t>(kConeDepths)));
        const VD apex = hn::Add(hn::Set(d, top_), hn::Mul(hn::PromoteTo(d, bits), hn::Set(d, unit_)));
        const auto beyond = [&](VD high, VD fast, VD cell) {
            return hn::Sub(hn::Add(high, hn::Mul(lambda, fast)), hn::Add(cell, one));
        };
        const VD gap = hn::Max(hn::Max(beyond(highX, fastX, cellX), beyond(highY, fastY, cellY)), hn::Zero(d));
        const VD gain =
            hn::Div(hn::Sub(hn::Sub(apex, lambda), hn::Mul(kappa, gap)), hn::Add(one, hn::Mul(kappa, fastest)));
        const MD on = hn::And(fit, hn::Gt(hn::Mul(gain, fastest), hn::Set(d, kLeastLead)));
        hn::Store(hn::IfThenElse(on, hn::Add(lambda, gain), lambda), d, to);
        return !hn::AllFalse(d, on);
    }

    hn::Vec<DHI> entryAt(MD who, VD cellX, VD cellY) const {
        const DD d;
        const VD x = addressed(scene_.grid.x, mirroredX_, cellX), y = addressed(scene_.grid.y, mirroredY_, cellY);
        const VD index = hn::Add(hn::Mul(y, hn::Set(d, stride_)), x);
        return hn::GatherIndex(DHI(), entries_, hn::DemoteTo(DHI(), hn::IfThenElseZero(who, index)));
    }
    VD addressed(const GridAxis& axis, bool mirrored, VD cell) const {
        const DD d;
        if (mirrored) cell = hn::Sub(hn::Set(d, -1.0), cell);
        const VD cells = hn::Set(d, axis.cells);
        if constexpr (kAddress == Address::Repeat)
            return hn::Sub(cell, hn::Mul(hn::Floor(hn::Div(cell, cells)), cells));
        return hn::Min(hn::Max(cell, hn::Zero(d)), hn::Sub(cells, hn::Set(d, 1.0)));
    }

    const FloatScene& scene_;
    const std::int32_t* entries_;
    double stride_, unit_, top_;
    bool mirroredX_, mirroredY_;
};

// Sets the start of the rays' groups. Rays beyond the last whole beam begin at the scene's start.
template <Address kAddress>
void leadBeams(const FloatScene& scene, const PackedCones& cones, std::uint32_t quadrant, const double* const* columns,
               LaneRays& rays) {
    BeamAxis x, y;
    const std::size_t beams = rays.count / kBeamRays;
    measureBeams(scene.grid.x, columns[0], columns[2], beams, (quadrant & 1U) != 0, x);
    measureBeams(scene.grid.y, columns[1], columns[3], beams, (quadrant & 2U) != 0, y);
    alignas(64) std::array<double, kChunkBeams> starts;
    starts.fill(scene.start);
    BeamWalk<kAddress>(scene, cones, quadrant).lead(x, y, beams, starts.data());
    constexpr std::size_t kGroups = kBeamRays / kLaneGroup;
    for (std::size_t n = 0; n < beams; ++n) {
        double* first = rays.start.data() + n * kGroups;
        for (std::size_t k = 0; k < kGroups; ++k) first[k] = std::max(starts[n] - kStartSlack, first[k]);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
