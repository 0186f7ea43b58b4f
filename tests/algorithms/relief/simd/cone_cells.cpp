#include "cone_cells.h"

#include <map>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/relief/simd/cone_cells.cpp"
#include <hwy/foreach_target.h>
// Included after foreach_target.h.
#include "plain_arithmetic-inl.h"
#include "relief/simd/cone_entry-inl.h"

#ifndef RELIEF_CONE_CELLS_VISITS
#define RELIEF_CONE_CELLS_VISITS
namespace relief::test {

// A visited cell: the ray's index in the chunk, and the cell's offset from the ray's first one.
struct Visit {
    std::int32_t slot, x, y;
    std::uint32_t word;
};
// A ray that left a packet: its index in the chunk, and its candidate cell.
struct Candidate {
    std::size_t ray;
    std::int64_t x, y;
};
inline std::vector<Candidate>& candidates() {
    static std::vector<Candidate> all;
    return all;
}
inline std::vector<Visit>& visits() {
    static std::vector<Visit> all;
    return all;
}

}  // namespace relief::test
#endif

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

template <class Base>
struct Noting : Base {
    static constexpr bool kRecords = true;
    static void visit(const WalkColumns& columns, std::size_t i, VF nx, VF ny, VI word, MF who) {
        HWY_ALIGN std::int32_t slots[kLanes], words[kLanes], chosen[kLanes];
        HWY_ALIGN float x[kLanes], y[kLanes];
        const DF df;
        const DI di;
        hn::Store(hn::Load(di, columns.slot.data() + i), di, slots);
        hn::Store(word, di, words);
        hn::Store(hn::IfThenElseZero(asInt(who), hn::Set(di, 1)), di, chosen);
        hn::Store(nx, df, x);
        hn::Store(ny, df, y);
        for (std::size_t k = 0; k < kLanes; ++k) {
            if (chosen[k] == 0) continue;
            const auto forth = [&](float n, const WalkAxis& axis) {
                return static_cast<std::int32_t>(std::signbit(axis.stride[i + k]) ? -n : n);
            };
            test::visits().push_back(
                {slots[k], forth(x[k], columns.x), forth(y[k], columns.y), static_cast<std::uint32_t>(words[k])});
        }
    }
    static void leavePacket(const PacketColumns& columns, std::size_t packet, bool periods) {
        for (std::size_t k = 0; k < kLanes; ++k) {
            const std::size_t i = packet * kLanes + k;
            if ((columns.ended[packet] >> k & 1U) == 0) continue;
            if (columns.end[i] != static_cast<std::int32_t>(LaneEnd::Candidate)) continue;
            test::candidates().push_back({columns.first[packet] + k,
                                          columns.cellX[i] + (periods ? columns.periodX[i] : 0),
                                          columns.cellY[i] + (periods ? columns.periodY[i] : 0)});
        }
    }
};

// Invokes `call` with the walk for the scene's surface.
template <class Arithmetic, class Call>
void onSurface(const FloatScene& scene, const Call& call) {
    if (scene.surface == Surface::Bilinear) {
        call.template operator()<Surface::Bilinear, Noting<Arithmetic>>();
    } else {
        call.template operator()<Surface::Columns, Noting<Arithmetic>>();
    }
}
// plain: with arithmetic that rounds as the reference does.
template <class Call>
void noted(bool plain, const FloatScene& scene, const Call& call) {
    plain ? onSurface<PlainArithmetic>(scene, call) : onSurface<FastArithmetic>(scene, call);
}

void traceNoted(bool plain, const FloatScene& scene, const PackedCones& cones, const double* const* given,
                HitBlock& hits, std::size_t first, LaneRays& rays) {
    noted(plain, scene, [&]<Surface kSurface, class Arithmetic>() {
        traceConesOn<kSurface, Arithmetic>(scene, cones, given, hits, first, rays);
    });
}
void goOnNoted(bool plain, const FloatScene& scene, const PackedCones& cones, const double* const* given,
               LaneRays& rays, HitBlock& hits) {
    noted(plain, scene, [&]<Surface kSurface, class Arithmetic>() {
        resumeConesOn<kSurface, Arithmetic>(scene, cones, given, rays, hits);
    });
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(traceNoted);
HWY_EXPORT(goOnNoted);

namespace test {

namespace {

using RayKey = std::array<double, 4>;

// The visited cells of the rays being traced.
struct Noted {
    std::map<RayKey, std::size_t> numbers;
    std::vector<VisitedRay> rays;
    bool plain = true;
};
Noted& noted() {
    static Noted all;
    return all;
}

// Assigns the visits to the rays, which are identified by their numbers in `given`.
void sortVisits(const double* const* given, const LaneRays& rays) {
    for (const Visit& visit : visits()) {
        const auto slot = static_cast<std::size_t>(visit.slot);
        const std::size_t number = noted().numbers.at({given[0][slot], given[1][slot], given[2][slot], given[3][slot]});
        noted().rays[number].cells.push_back(
            {std::int64_t{rays.x.cell[slot]} + visit.x, std::int64_t{rays.y.cell[slot]} + visit.y, visit.word});
    }
    visits().clear();
    for (const Candidate& each : candidates()) {
        const std::size_t n = each.ray;
        const std::size_t number = noted().numbers.at({given[0][n], given[1][n], given[2][n], given[3][n]});
        noted().rays[number].candidate = {each.x, each.y};
    }
    candidates().clear();
}

void trace(const FloatScene& scene, const PackedCones& cones, const RayBlock& rays, std::size_t first, std::size_t last,
           HitBlock& hits, LaneRays& scratch) {
    scratch.count = last - first;
    scratch.behind = rays.size() - last;
    if (scratch.count == 0) return;
    const double* const given[] = {rays.s0.data() + first, rays.t0.data() + first, rays.a.data() + first,
                                   rays.b.data() + first};
    HWY_DYNAMIC_DISPATCH(traceNoted)(noted().plain, scene, cones, given, hits, first, scratch);
    for (std::size_t i = first; i < last; ++i) noted().rays[i].begin = scratch.start[(i - first) / kLaneGroup];
    sortVisits(given, scratch);
    std::fill_n(hits.outcome.data() + first, scratch.count, Outcome::Hit);
}

void resume(const FloatScene& scene, const PackedCones& cones, const double* const* given, LaneRays& rays,
            HitBlock& hits) {
    if (rays.count == 0) return;
    HWY_DYNAMIC_DISPATCH(goOnNoted)(noted().plain, scene, cones, given, rays, hits);
    sortVisits(given, rays);
}

}  // namespace

std::vector<VisitedRay> cellsInLanes(const HeightField& field, const PackedCones& cones, const RayBlock& rays,
                                     HitBlock& hits, bool asTheReference) {
    noted() = {};
    noted().plain = asTheReference;
    noted().rays.resize(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        noted().numbers[{rays.s0[i], rays.t0[i], rays.a[i], rays.b[i]}] = i;
    }
    hits.resize(rays.size());
    std::vector<std::size_t> flat;
    traceByCones({&trace, &resume}, field, FloatScene(field, cones), cones, rays, 0, rays.size(), hits, flat);
    return std::move(noted().rays);
}

}  // namespace test
}  // namespace relief
#endif
