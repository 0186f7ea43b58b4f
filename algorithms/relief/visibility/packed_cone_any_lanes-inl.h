// SIMD version of packed-cone-any in double, one segment per lane. Reference: PackedConeAnyHit::query.
// It returns the same results for any target and vector width: the walk visits every cell in which the segment may be
// blocked, and cellBlocks() is repeated here operation by operation. Testing additional cells does not change the
// result. Axes are mirrored, x -> -x, where the run is negative, so that every segment runs to +x, +y; in IEEE
// arithmetic all edges and crossings keep their bits. Cell c becomes -c - 1. Cells are numbered continuously across
// periods and reduced to the first period for map accesses.

#if defined(RELIEF_PACKED_CONE_ANY_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_PACKED_CONE_ANY_LANES_INL_H
#undef RELIEF_PACKED_CONE_ANY_LANES_INL_H
#else
#define RELIEF_PACKED_CONE_ANY_LANES_INL_H
#endif

#include <array>
#include <cmath>

#include "relief/simd/double_lanes-inl.h"
#include "relief/simd/exact_leaf-inl.h"
#include "relief/visibility/packed_cone_any.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// One axis, mirrored: the values that are constant while a lane processes a segment, and its cell.
struct AxisRows {
    Row<double> start{}, run{}, inverse{}, sign{};
    Row<double> turn{};                    // 0, or the last cell's number where mirrored
    Row<double> firstCell{}, firstEdge{};  // outer cells and edges where the axis does not wrap
    Row<double> lastCell{}, lastEdge{};
    Row<double> cell{};

    void set(std::size_t lane, const GridAxis& grid, const RayAxis& ray) {
        // parallel: every edge ahead is beyond the end, every edge behind is before 0
        constexpr double kNever = 1e300;
        constexpr double kAll = HUGE_VAL;
        const bool mirrored = ray.side < 0;
        const AxisCell from = ray.startCell(grid);
        const double at = static_cast<double>(from.base + from.index);
        sign[lane] = mirrored ? -1 : 1;
        start[lane] = mirrored ? -ray.start : ray.start;
        run[lane] = std::abs(ray.run);
        inverse[lane] = ray.side == 0 ? kNever : std::abs(ray.inverse);
        turn[lane] = mirrored ? grid.cells - 1 : 0;
        cell[lane] = mirrored ? -at - 1 : at;
        firstCell[lane] = grid.wraps ? -kAll : (mirrored ? -grid.cells : 0.0);
        lastCell[lane] = grid.wraps ? kAll : (mirrored ? -1.0 : grid.cells - 1.0);
        // A parallel segment may run along an outer edge and never leaves across it.
        firstEdge[lane] = ray.side == 0 ? -kAll : (mirrored ? -grid.high : grid.low);
        lastEdge[lane] = ray.side == 0 ? kAll : (mirrored ? -grid.low : grid.high);
    }
};

struct AxisLanes {
    V start, run, inverse, sign, turn, firstCell, firstEdge, lastCell, lastEdge;
    V cell;

    HWY_INLINE explicit AxisLanes(const AxisRows& from)
        : start(load(from.start)),
          run(load(from.run)),
          inverse(load(from.inverse)),
          sign(load(from.sign)),
          turn(load(from.turn)),
          firstCell(load(from.firstCell)),
          firstEdge(load(from.firstEdge)),
          lastCell(load(from.lastCell)),
          lastEdge(load(from.lastEdge)),
          cell(load(from.cell)) {}

    HWY_INLINE V enter() const {
        const V edge = hn::IfThenElse(hn::Le(cell, firstCell), firstEdge, cell);
        return hn::Mul(hn::Sub(edge, start), inverse);
    }
    HWY_INLINE V leave() const {
        const V edge = hn::IfThenElse(hn::Ge(cell, lastCell), lastEdge, hn::Add(cell, constant(1)));
        return hn::Mul(hn::Sub(edge, start), inverse);
    }
    HWY_INLINE V place(V mu) const { return hn::Add(start, hn::Mul(mu, run)); }
    // The cell's index within the period, in [0, cells).
    HWY_INLINE V index(double cells) const {
        const V period = hn::Floor(hn::Mul(hn::Add(cell, constant(0.5)), constant(1 / cells)));
        return hn::Add(turn, hn::Mul(sign, hn::Sub(cell, hn::Mul(period, constant(cells)))));
    }
    // Position within the cell, computed as the reference does.
    HWY_INLINE V within(V mu) const {
        const V one = constant(1), zero = hn::Zero(D());
        const V unmirrored = hn::Sub(hn::Mul(sign, cell), hn::IfThenElseZero(hn::Lt(sign, zero), one));
        return hn::Min(hn::Max(hn::Sub(hn::Mul(sign, place(mu)), unmirrored), zero), one);
    }
};

// The queue from which all vectors take their segments.
struct SegmentQueue {
    const PackedConeAnyHit& query;
    const AnyRayBlock& rays;
    std::size_t quadrant;  // only segments of this quadrant are processed
    std::size_t next;
    std::size_t last;
    Visibility* results;
};

// The state of one vector of segments, in memory.
struct Segments {
    AxisRows x, y;
    Row<double> z{}, dz{}, end{}, run{}, mu{};
    Row<std::size_t> number{};
    std::uint32_t active = 0;

    bool fill(std::size_t lane, SegmentQueue& queue);
};

// Loads the next segment that needs a walk into a lane. Returns false if there is none.
inline bool Segments::fill(std::size_t lane, SegmentQueue& queue) {
    const CellGrid& grid = queue.query.grid();
    while (queue.next < queue.last) {
        const std::size_t i = queue.next++;
        const AnyRay ray = queue.rays[i];
        if (!ray.finite()) {
            queue.results[i] = Visibility::Clear;
            continue;
        }
        const GridRay course(grid, ray.course());
        if (quadrantOf(course) != queue.quadrant) continue;
        queue.results[i] = Visibility::Clear;
        const double until = std::min(endBelow(ray, queue.query.map().highest), HUGE_VAL);
        if (!(until > 0) || runsOutside(grid, course)) continue;
        if (!course.inDomain()) {
            NullSink sink;
            queue.results[i] = queue.query.query(ray, sink);
            continue;
        }
        x.set(lane, grid.x, course.x);
        y.set(lane, grid.y, course.y);
        z[lane] = ray.z;
        dz[lane] = ray.dz;
        run[lane] = std::max(x.run[lane], y.run[lane]);
        end[lane] = until;
        mu[lane] = 0;
        number[lane] = i;
        active |= 1U << lane;
        return true;
    }
    return false;
}

template <class Visits>
class SegmentWalk {
  public:
    explicit SegmentWalk(SegmentQueue& queue)
        : queue_(queue),
          field_(queue.query.field()),
          grid_(queue.query.grid()),
          entries_(queue.query.map().quadrant(queue.quadrant)),
          nx_(queue.query.map().nx),
          ny_(queue.query.map().ny) {}

    // Refills idle lanes and takes a step. Returns false when all segments are done.
    bool advance();

  private:
    struct Lanes {
        AxisLanes x, y;
        V z, dz;
        HWY_INLINE V heightAt(V mu) const { return hn::Add(z, hn::Mul(mu, dz)); }
    };
    HWY_INLINE void resolve(std::uint32_t lanes, Visibility visibility) {
        segments_.active &= ~lanes;
        overLanes(lanes, [&](std::size_t lane) { queue_.results[segments_.number[lane]] = visibility; });
    }
    HWY_INLINE M blocks(const Lanes& lanes, V exits, V end, VI cx, VI cy) const;
    void step();

    SegmentQueue& queue_;
    const HeightField& field_;
    const CellGrid& grid_;
    const std::uint32_t* entries_;
    int nx_;
    int ny_;
    Segments segments_;
};

// cellBlocks() for the lanes' cells.
template <class Visits>
M SegmentWalk<Visits>::blocks(const Lanes& lanes, V exits, V end, VI cx, VI cy) const {
    const V zero = hn::Zero(D()), one = constant(1), clearance = constant(kVisibilityClearance);
    const V in = hn::Max(hn::Max(lanes.x.enter(), lanes.y.enter()), zero);
    const V out = hn::Min(hn::Min(exits, one), end);
    const M crosses = hn::Lt(in, out);
    const V zIn = lanes.heightAt(in), zOut = lanes.heightAt(out);
    if (field_.surface() == Surface::Columns) {
        const V height = heightsAt(field_.heights(), cx, cy);
        return hn::And(crosses, hn::Gt(hn::Sub(height, hn::Min(zIn, zOut)), clearance));
    }
    const ExactPlaces places{
        lanes.x.within(in), lanes.y.within(in), lanes.x.within(out), lanes.y.within(out), zIn, zOut};
    const ExactGaps gaps = exactGaps(cornersAt(field_.heights(), grid_, cx, cy), places);
    return hn::And(crosses, hn::Gt(highestGap(gaps), clearance));
}

template <class Visits>
void SegmentWalk<Visits>::step() {
    const D d;
    Lanes lanes{AxisLanes(segments_.x), AxisLanes(segments_.y), load(segments_.z), load(segments_.dz)};
    const V mu = load(segments_.mu), end = load(segments_.end), run = load(segments_.run);
    const VI cx = hn::DemoteTo(DI(), lanes.x.index(nx_)), cy = hn::DemoteTo(DI(), lanes.y.index(ny_));
    const hn::Rebind<std::uint32_t, D> du;
    const auto entry = hn::GatherIndex(du, entries_, hn::Add(hn::Mul(cy, whole(queue_.query.map().stride)), cx));
    const V exitX = lanes.x.leave(), exitY = lanes.y.leave();
    const V exits = hn::Min(exitX, exitY);
    const V out = hn::Max(hn::Min(exits, end), mu);
    const V zOut = lanes.heightAt(out);
    const V lowest = hn::Min(lanes.heightAt(mu), zOut);
    const auto heightOf = [&](auto depth) {
        const V steps = hn::PromoteTo(d, hn::BitCast(DI(), hn::And(depth, hn::Set(du, kConeDepths))));
        return hn::Sub(constant(queue_.query.map().highest), hn::Mul(steps, constant(queue_.query.map().unit)));
    };
    const M above = hn::Gt(lowest, heightOf(entry));
    // Lanes that need a cell test wait until several of them can be tested together.
    constexpr int kMinTested = kLanes > 2 ? static_cast<int>(kLanes / 2) : 1;
    const std::uint32_t all = (1U << kLanes) - 1;
    const std::uint32_t walking = segments_.active;
    std::uint32_t waiting = ~bitsOf(above) & walking;
    if (waiting != 0 && (waiting == walking || __builtin_popcount(waiting) >= kMinTested)) {
        resolve(bitsOf(blocks(lanes, exits, end, cx, cy)) & waiting, Visibility::Blocked);
        waiting = 0;
    }
    if constexpr (Visits::kRecords) {
        // A waiting lane repeats its step: only the last repetition is recorded. Visits to cells that end before mu
        // only catch up and are not recorded.
        const std::uint32_t behind = bitsOf(hn::And(hn::Le(exits, mu), hn::Gt(mu, hn::Zero(d))));
        Visits::visit(segments_.number, walking & ~waiting & ~behind, lanes.x.index(nx_), lanes.y.index(ny_));
    }
    // Move to the next cell, or further by the cone.
    const V room = hn::Sub(zOut, heightOf(hn::ShiftRight<10>(entry)));
    const V slope = hn::PromoteTo(d, hn::BitCast(DF(), entry));
    const V closing = hn::Sub(hn::Mul(slope, run), lanes.dz);
    const V zero = hn::Zero(d);
    // Cones count from where the segment leaves the cell. So they are not used in a cell that ends before mu, which is
    // visited where the cell after a jump was chosen too low.
    const M open = hn::And(hn::And(above, hn::Gt(room, zero)), hn::Ge(exits, mu));
    const M forEver = hn::And(open, hn::Le(closing, zero));
    // Subtracted from the position after a jump, in cells; more than its rounding, so that the cell found is never too
    // far on. The jump itself needs no margin: a cell is tested over its whole interval.
    constexpr double kUnsure = 1e-8;
    const V share = hn::Mul(hn::Div(room, closing), constant(kShorterShare));
    const V target = hn::Add(out, share);
    const M jumps = hn::And(open, hn::Gt(target, out));
    const V after = hn::IfThenElse(jumps, target, out);
    const auto next = [&](const AxisLanes& axis, V exit, V other) {
        const V stepped = hn::Add(axis.cell, hn::IfThenElseZero(hn::Le(exit, other), constant(1)));
        const V jumped = hn::Max(stepped, hn::Floor(hn::Sub(axis.place(after), constant(kUnsure))));
        return hn::IfThenElse(jumps, hn::Min(jumped, axis.lastCell), stepped);
    };
    const V nextX = next(lanes.x, exitX, exitY), nextY = next(lanes.y, exitY, exitX);
    const M leaves = hn::Or(hn::Gt(nextX, lanes.x.lastCell), hn::Gt(nextY, lanes.y.lastCell));
    const M done = hn::Or(hn::Or(forEver, leaves), hn::Not(hn::Lt(after, end)));
    resolve(bitsOf(done) & segments_.active & ~waiting, Visibility::Clear);
    // Waiting and idle lanes do not move.
    const std::uint8_t bits[8] = {static_cast<std::uint8_t>(segments_.active & ~waiting & all)};
    const M moves = hn::LoadMaskBits(d, bits);
    hn::StoreU(hn::IfThenElse(moves, after, mu), d, segments_.mu.data());
    hn::StoreU(hn::IfThenElse(moves, nextX, lanes.x.cell), d, segments_.x.cell.data());
    hn::StoreU(hn::IfThenElse(moves, nextY, lanes.y.cell), d, segments_.y.cell.data());
}

template <class Visits>
bool SegmentWalk<Visits>::advance() {
    const std::uint32_t all = (1U << kLanes) - 1;
    for (std::uint32_t idle = all & ~segments_.active; idle != 0; idle &= idle - 1) {
        if (!segments_.fill(static_cast<std::size_t>(__builtin_ctz(idle)), queue_)) break;
    }
    if (segments_.active == 0) return false;
    step();
    return true;
}

template <class Visits = NoVisits>
void runQueries(const PackedConeAnyHit& query, const AnyRayBlock& rays, std::size_t first, std::size_t last,
                Visibility* results) {
    // Shadow rays of one light, or the visibility queries of one pixel, fall into one or a few quadrants.
    std::uint32_t quadrants = 0;
    for (std::size_t i = first; i < last; ++i) {
        constexpr double kNegative = -1e-300;  // as in RayAxis: smaller runs count as 0
        quadrants |= 1U << ((rays.ds[i] <= kNegative ? 1U : 0U) + (rays.dt[i] <= kNegative ? 2U : 0U));
    }
    for (std::size_t quadrant = 0; quadrant < 4; ++quadrant) {
        if ((quadrants >> quadrant & 1) == 0) continue;
        SegmentQueue queue{query, rays, quadrant, first, last, results};
        runAlternating<SegmentWalk<Visits>>(queue);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
