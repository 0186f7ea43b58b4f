// SIMD versions of ConeTracer with layout=texel and of ConeMarch, in double, one ray per lane: the same steps with the
// same bits. Compiled for each target.

#if defined(RELIEF_TEXEL_CONE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_TEXEL_CONE_LANES_INL_H
#undef RELIEF_TEXEL_CONE_LANES_INL_H
#else
#define RELIEF_TEXEL_CONE_LANES_INL_H
#endif

#include <algorithm>
#include <cmath>

#include "relief/maps/distance_map.h"
#include "relief/maps/packed_cones.h"
#include "relief/methods/texel_cone_lanes.h"
#include "relief/sampled_surface.h"
#include "relief/simd/bisection_lanes-inl.h"
#include "relief/simd/cell_lanes-inl.h"
#include "relief/simd/stored_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// A vector of rays in flight from cell to cell: ConeTracer::run.
template <class Visits>
class ConeCells : public CellWalk<ConeCells<Visits>, ConeCellSearch> {
  public:
    explicit ConeCells(RayQueue<ConeCellSearch>& queue)
        : Cells(queue, queue.search.field, queue.search.grid),
          map_(queue.search.map),
          apex_(map_.apex),
          slopes_(map_.slopes) {}

    bool take(std::size_t lane, const ViewRay& ray, std::size_t number);
    void step();

  private:
    using Cells = CellWalk<ConeCells, ConeCellSearch>;
    using Cells::active_;
    using Cells::grid_;
    using Cells::lambda_;
    using Cells::queue_;
    using Cells::ray_;
    using Cells::x_;
    using Cells::y_;
    using Axis = WalkAxisLanes;

    const ConeMap& map_;
    StoredLanes apex_, slopes_;
    Row<double> plane_{}, runLength_{};  // plane: number of the first slope of the ray's sector
};

template <class Visits>
bool ConeCells<Visits>::take(std::size_t lane, const ViewRay& viewRay, std::size_t number) {
    const GridRay ray(grid_, viewRay);
    if (!ray.inDomain()) {
        queue_.fallback.push_back(number);
        return false;
    }
    if (!this->begin(lane, number, ray, ray.cellBound() + 2)) return false;
    const int sector = azimuthSector(ray.x.run, ray.y.run, map_.parameters.sectors);
    plane_[lane] = static_cast<double>(sector) * map_.nx() * map_.ny();
    runLength_[lane] = std::hypot(ray.x.run, ray.y.run);
    return true;
}

template <class Visits>
void ConeCells<Visits>::step() {
    const V zero = hn::Zero(D()), one = constant(1), lambda = load(lambda_);
    const Axis x(grid_.x, x_, lambda), y(grid_.y, y_, lambda);
    const V out = hn::Max(stdMin(stdMin(x.leaveCell(), y.leaveCell()), one), lambda);
    const V cell = hn::Add(hn::Mul(y.index(), constant(map_.nx())), x.index());
    const V apex = apex_.at(cell);
    const V kappa = slopes_.at(hn::Add(load(plane_), cell));
    const V room = hn::Sub(hn::Sub(one, out), apex);
    const V closing = hn::Add(one, hn::Mul(kappa, load(runLength_)));
    const V free = hn::Mul(hn::Div(room, closing), constant(kShorterShare));
    const M above = hn::Gt(hn::Sub(one, out), apex);
    const V jump = hn::Add(out, hn::Max(zero, hn::Sub(free, constant(kExclusionMargin))));
    const std::uint32_t walking = active_;
    const V after = this->moveOn(x, y, lambda, hn::Not(above), jump);
    if constexpr (Visits::kRecords) {
        Visits::visit(ray_, walking, x.index(), y.index(), hn::IfThenElse(above, kappa, apex), lambda, out, after);
    }
}

// ConeMarch::slopeAt.
class SlopeLanes {
  public:
    explicit SlopeLanes(const ConeMap& map)
        : slopes_(map.slopes), nx_(map.nx()), ny_(map.ny()), repeats_(map.address == Address::Repeat) {}

    HWY_INLINE V at(V s, V t) const {
        const V one = constant(1), half = constant(0.5);
        const V x = hn::Sub(s, half), y = hn::Sub(t, half);
        const V i = hn::Floor(x), j = hn::Floor(y);
        const V u = hn::Sub(x, i), v = hn::Sub(y, j);
        const V i0 = addressedIndex(i, nx_, repeats_), i1 = addressedIndex(hn::Add(i, one), nx_, repeats_);
        const V j0 = row(j), j1 = row(hn::Add(j, one));
        const V rest = hn::Sub(one, u);
        const V top = hn::Add(hn::Mul(rest, slopes_.at(hn::Add(j0, i0))), hn::Mul(u, slopes_.at(hn::Add(j0, i1))));
        const V bottom = hn::Add(hn::Mul(rest, slopes_.at(hn::Add(j1, i0))), hn::Mul(u, slopes_.at(hn::Add(j1, i1))));
        return hn::Add(hn::Mul(hn::Sub(one, v), top), hn::Mul(v, bottom));
    }

  private:
    HWY_INLINE V row(V j) const { return hn::Mul(addressedIndex(j, ny_, repeats_), constant(nx_)); }

    StoredLanes slopes_;
    double nx_, ny_;
    bool repeats_;
};

// A vector of rays in flight from cone to cone: ConeMarch::march.
template <class Visits>
class ConeSteps : public VectorOfRays<ConeSteps<Visits>, ConeMarchSearch> {
  public:
    explicit ConeSteps(BracketQueue<ConeMarchSearch>& queue)
        : Rays(queue),
          brackets_(queue.brackets),
          field_(queue.search.field),
          surface_(field_),
          slopes_(queue.search.map) {}

    bool take(std::size_t lane, const ViewRay& ray, std::size_t number);
    void step();

  private:
    using Rays = VectorOfRays<ConeSteps, ConeMarchSearch>;
    using Rays::active_;
    using Rays::queue_;
    using Rays::ray_;
    void finish(std::size_t lane, bool inside, double gap);

    std::vector<Bracket>& brackets_;
    const HeightField& field_;
    SurfaceLanes surface_;
    SlopeLanes slopes_;
    Row<double> s0_{}, t0_{}, a_{}, b_{}, runLength_{}, lambda_{}, before_{}, end_{}, left_{};
};

template <class Visits>
bool ConeSteps<Visits>::take(std::size_t lane, const ViewRay& ray, std::size_t number) {
    const double farthest = std::max({std::abs(ray.s0), std::abs(ray.t0), std::abs(ray.a), std::abs(ray.b)});
    if (!(farthest < kFar)) {
        queue_.fallback.push_back(number);
        return false;
    }
    const auto [s0, t0] = SampledSurface(field_, ray).placeAt(0);
    const Segment segment = queue_.segmentOf(number);
    s0_[lane] = s0, t0_[lane] = t0, a_[lane] = ray.a, b_[lane] = ray.b;
    runLength_[lane] = std::hypot(ray.a, ray.b);
    lambda_[lane] = before_[lane] = segment.in;
    end_[lane] = segment.out;
    left_[lane] = queue_.search.iterations;
    return true;
}

template <class Visits>
void ConeSteps<Visits>::step() {
    const V one = constant(1), zero = hn::Zero(D());
    const V lambda = load(lambda_), end = load(end_), left = load(left_);
    const V s = hn::Add(load(s0_), hn::Mul(lambda, load(a_)));
    const V t = hn::Add(load(t0_), hn::Mul(lambda, load(b_)));
    const V gap = hn::Sub(surface_.at(s, t), hn::Sub(one, lambda));
    const V kappa = slopes_.at(s, t);
    const V closing = hn::Add(one, hn::Mul(kappa, load(runLength_)));
    const V after = hn::Min(hn::Sub(lambda, hn::Div(gap, closing)), end);
    M inside = hn::Eq(zero, zero);
    if (field_.address() == Address::Border) {
        inside = surface_.inside(s, t);
    }
    const M arrived = hn::Or(hn::Ge(gap, zero), hn::Or(hn::Ge(lambda, end), hn::Le(left, zero)));
    const std::uint32_t in = bitsOf(inside);
    const std::uint32_t done = active_ & (bitsOf(arrived) | ~in);
    if constexpr (Visits::kRecords) Visits::visit(ray_, active_ & ~done, lambda, kappa, after);
    if (done != 0) {
        Row<double> gaps;
        store(gap, gaps);
        overLanes(done, [&](std::size_t lane) { finish(lane, (in >> lane & 1) != 0, gaps[lane]); });
        active_ &= ~done;
    }
    store(lambda, before_), store(after, lambda_), store(hn::Sub(left, one), left_);
    overLanes(done, [&](std::size_t lane) { lambda_[lane] = 0; });  // idle lanes stay at the start
}

template <class Visits>
void ConeSteps<Visits>::finish(std::size_t lane, bool inside, double gap) {
    const std::size_t i = ray_[lane];
    const double lambda = lambda_[lane];
    const bool leaves = lambda >= end_[lane] && end_[lane] < 1 && gap < 0;
    if (!inside || leaves) {
        queue_.hits.set(i, Hit::none(Outcome::Miss));
    } else if (gap > 0 && queue_.search.bisections > 0) {
        brackets_.push_back({i, {s0_[lane], t0_[lane], a_[lane], b_[lane]}, before_[lane], lambda});
    } else {
        queue_.hits.set(i, Hit::at(queue_.rays[i], lambda));
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
