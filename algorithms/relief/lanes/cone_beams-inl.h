// Beams: rays that begin together are led by one cone walk of their bounding box, as long as one cone stands clear of
// all of them; first squares of 256, from there each group of 16. Compiled for each target.
//
// All runs have the signs of the quadrant. At lambda the rays are within [low + lambda slowest, high + lambda fastest]
// on both axes, and from then on in the quadrant of the cell that holds the lower corner. A ray that is g beyond this
// cell, in the maximum norm, is free above A + kappa g; g grows by the fastest run at most.

#if defined(RELIEF_CONE_BEAMS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_CONE_BEAMS_INL_H
#undef RELIEF_CONE_BEAMS_INL_H
#else
#define RELIEF_CONE_BEAMS_INL_H
#endif

#include "relief/lanes/lane_trace-inl.h"
#include "relief/maps/packed_cones.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

inline constexpr std::size_t kBeamGroups = 16;  // of a square
inline constexpr std::size_t kChunkGroups = kLaneChunk / kLaneGroup;
// Boxes wider than this many texels are not led, and steps that lead on by less than this part of a texel are left to
// the rays.
inline constexpr double kWidestBeam = 64;
inline constexpr double kLeastLead = 0.5;
inline constexpr int kMostLeads = 24;
// Of the rounding here, and of the start in lanes (LaneScene).
inline constexpr double kLeadSlack = 0x1p-12;

// One axis of beams, mirrored; one value a group, filled up to whole vectors.
struct BeamAxis {
    alignas(64) std::array<double, kChunkGroups> low, high, slowest, fastest;
};

inline void measureBeams(const GridAxis& axis, const double* origins, const double* runs, std::size_t groups,
                         bool mirrored, BeamAxis& out) {
    const DD d;
    const VD shift = hn::Set(d, axis.shift);
    for (std::size_t g = 0; g < groups; ++g) {
        VD low = hn::LoadU(d, origins + g * kLaneGroup), high = low;
        VD slowest = hn::LoadU(d, runs + g * kLaneGroup), fastest = slowest;
        for (std::size_t i = kHalfLanes; i < kLaneGroup; i += kHalfLanes) {
            const VD s = hn::LoadU(d, origins + g * kLaneGroup + i), run = hn::LoadU(d, runs + g * kLaneGroup + i);
            low = hn::Min(low, s), high = hn::Max(high, s);
            slowest = hn::Min(slowest, run), fastest = hn::Max(fastest, run);
        }
        const double least = hn::GetLane(hn::Add(hn::MinOfLanes(d, low), shift));
        const double most = hn::GetLane(hn::Add(hn::MaxOfLanes(d, high), shift));
        const double back = hn::GetLane(hn::MinOfLanes(d, slowest)), forth = hn::GetLane(hn::MaxOfLanes(d, fastest));
        out.low[g] = mirrored ? -most : least;
        out.high[g] = mirrored ? -least : most;
        out.slowest[g] = mirrored ? -forth : back;
        out.fastest[g] = mirrored ? -back : forth;
    }
}

template <Address kAddress>
class BeamWalk {
  public:
    BeamWalk(const LaneScene& scene, const PackedCones& cones, std::uint32_t quadrant)
        : scene_(scene),
          words_(reinterpret_cast<const std::int32_t*>(cones.words[quadrant].data())),
          nx_(cones.nx),
          unit_(cones.unit),
          top_(1 - cones.highest),
          mirroredX_((quadrant & 1U) != 0),
          mirroredY_((quadrant & 2U) != 0) {}

    // lambda, for each of `groups` beams (filled up to whole vectors): up to there none of its rays meets anything. All
    // beams take a step, one vector after the other: their reads do not wait for each other.
    void lead(const BeamAxis& x, const BeamAxis& y, std::size_t groups, double* lambda) const {
        std::array<bool, kChunkGroups> on{};
        std::fill_n(on.begin(), groups, true);
        bool any = true;
        for (int n = 0; n < kMostLeads && any; ++n) {
            any = false;
            for (std::size_t g = 0; g < groups; g += kHalfLanes) {
                if (on[g]) any |= on[g] = leadOn(x, y, g, lambda + g);
            }
        }
    }

  private:
    // A step of a vector of beams; whether one of them gained anything. One that did not never will.
    HWY_INLINE bool leadOn(const BeamAxis& x, const BeamAxis& y, std::size_t g, double* to) const {
        const DD d;
        const auto load = [&](const std::array<double, kChunkGroups>& from) { return hn::Load(d, from.data() + g); };
        const VD lambda = hn::Load(d, to);
        const VD lowX = load(x.low), highX = load(x.high), slowX = load(x.slowest), fastX = load(x.fastest);
        const VD lowY = load(y.low), highY = load(y.high), slowY = load(y.slowest), fastY = load(y.fastest);
        const VD fastest = hn::Max(fastX, fastY);
        const VD one = hn::Set(d, 1.0);
        const VD widest = hn::Set(d, kWidestBeam), far = hn::Set(d, kLaneRun);
        const MD fit = hn::And(
            hn::And(hn::Lt(hn::Sub(highX, lowX), widest), hn::Lt(hn::Sub(highY, lowY), widest)),
            hn::And(hn::Lt(fastest, far), hn::Lt(hn::Max(hn::Abs(lowX), hn::Abs(lowY)), hn::Set(d, kLanePlaces))));
        const VD cellX = hn::Floor(hn::Add(lowX, hn::Mul(lambda, slowX)));
        const VD cellY = hn::Floor(hn::Add(lowY, hn::Mul(lambda, slowY)));
        const auto word = wordAt(fit, cellX, cellY);
        const VD kappa = hn::PromoteTo(d, hn::BitCast(DHF(), word));
        const auto bits = hn::And(hn::ShiftRight<10>(word), hn::Set(DHI(), static_cast<std::int32_t>(kConeDepths)));
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

    hn::Vec<DHI> wordAt(MD who, VD cellX, VD cellY) const {
        const DD d;
        const VD x = addressed(scene_.grid.x, mirroredX_, cellX), y = addressed(scene_.grid.y, mirroredY_, cellY);
        const VD index = hn::Add(hn::Mul(y, hn::Set(d, nx_)), x);
        return hn::GatherIndex(DHI(), words_, hn::DemoteTo(DHI(), hn::IfThenElseZero(who, index)));
    }
    VD addressed(const GridAxis& axis, bool mirrored, VD cell) const {
        const DD d;
        if (mirrored) cell = hn::Sub(hn::Set(d, -1.0), cell);
        const VD cells = hn::Set(d, axis.cells);
        if constexpr (kAddress == Address::Repeat)
            return hn::Sub(cell, hn::Mul(hn::Floor(hn::Div(cell, cells)), cells));
        return hn::Min(hn::Max(cell, hn::Zero(d)), hn::Sub(cells, hn::Set(d, 1.0)));
    }

    const LaneScene& scene_;
    const std::int32_t* words_;
    double nx_, unit_, top_;
    bool mirroredX_, mirroredY_;
};

// The bounding box of a square's groups, in the place of its first group.
inline void uniteBeams(const BeamAxis& groups, std::size_t begin, std::size_t end, std::size_t at, BeamAxis& out) {
    const auto from = [&](const std::array<double, kChunkGroups>& a) {
        return a.begin() + static_cast<std::ptrdiff_t>(begin);
    };
    const auto to = [&](const std::array<double, kChunkGroups>& a) {
        return a.begin() + static_cast<std::ptrdiff_t>(end);
    };
    out.low[at] = *std::min_element(from(groups.low), to(groups.low));
    out.high[at] = *std::max_element(from(groups.high), to(groups.high));
    out.slowest[at] = *std::min_element(from(groups.slowest), to(groups.slowest));
    out.fastest[at] = *std::max_element(from(groups.fastest), to(groups.fastest));
}

// Where the rays' groups begin; rays that are not a whole group begin at the scene's start.
template <Address kAddress>
void leadBeams(const LaneScene& scene, const PackedCones& cones, std::uint32_t quadrant, const double* const* columns,
               LaneRays& rays) {
    BeamAxis x, y;
    const std::size_t groups = rays.count / kLaneGroup;
    measureBeams(scene.grid.x, columns[0], columns[2], groups, (quadrant & 1U) != 0, x);
    measureBeams(scene.grid.y, columns[1], columns[3], groups, (quadrant & 2U) != 0, y);
    const std::size_t filled = hwy::RoundUpTo(groups, kHalfLanes);
    for (std::size_t g = groups; g < filled; ++g) uniteBeams(x, 0, 1, g, x), uniteBeams(y, 0, 1, g, y);
    const BeamWalk<kAddress> walk(scene, cones, quadrant);
    alignas(64) std::array<double, kChunkGroups> starts;
    starts.fill(scene.start);
    // Squares, all in one vector.
    BeamAxis squaresX, squaresY;
    const std::size_t squares = (groups + kBeamGroups - 1) / kBeamGroups;
    for (std::size_t s = 0; s < squares; ++s) {
        const std::size_t begin = s * kBeamGroups, end = std::min(begin + kBeamGroups, groups);
        uniteBeams(x, begin, end, s, squaresX), uniteBeams(y, begin, end, s, squaresY);
    }
    for (std::size_t s = squares; s < hwy::RoundUpTo(squares, kHalfLanes); ++s) {
        uniteBeams(squaresX, 0, 1, s, squaresX), uniteBeams(squaresY, 0, 1, s, squaresY);
    }
    walk.lead(squaresX, squaresY, squares, starts.data());
    for (std::size_t s = squares; s-- > 0;) {
        const auto first = starts.begin() + static_cast<std::ptrdiff_t>(s * kBeamGroups);
        std::fill_n(first, std::min(kBeamGroups, kChunkGroups - s * kBeamGroups), starts[s]);
    }
    walk.lead(x, y, groups, starts.data());
    for (double& start : starts) start = std::max(start - kLeadSlack, scene.start);
    for (std::size_t g = 0; g < groups; ++g) rays.start[g] = starts[g];
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
