// SIMD version of the walk down and up the pyramid of depths, one ray per lane. Reference: DepthWalk::trace. Compiled
// for each target.

#if defined(RELIEF_PYRAMID_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_PYRAMID_LANES_INL_H
#undef RELIEF_PYRAMID_LANES_INL_H
#else
#define RELIEF_PYRAMID_LANES_INL_H
#endif

#include <algorithm>

#include "relief/methods/depth_walk.h"
#include "relief/simd/candidates-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// Number of vectors of rays that are in flight together.
inline constexpr std::size_t kVectors = 2;

template <Address kAddress, Surface kSurface, class Arithmetic>
class PyramidKernel {
  public:
    PyramidKernel(const FloatScene& scene, const DepthPyramid& pyramid, LaneRays& rays)
        : scene_(scene),
          pyramid_(pyramid),
          rays_(rays),
          base_(reinterpret_cast<const std::int32_t*>(pyramid.gatheredDepths())),
          gathers_(pyramid.gathered()) {}

    void run() {
        std::array<State, kVectors> states;
        for (State& state : states) {
            state.slot = state.level = hn::Zero(di_);
            state.lambda = state.tie = hn::Zero(df_);
            for (Axis* axis : {&state.x, &state.y}) {
                axis->offset = axis->k = axis->mirror = hn::Zero(di_);
                axis->inverse = axis->base = axis->run = axis->rim = hn::Zero(df_);
                axis->mirrored = hn::MaskFromVec(hn::Zero(df_));
            }
            state.walking = hn::MaskFromVec(hn::Zero(df_));
            state.atLeaf = state.walking;
            refill(state);
        }
        for (;;) {
            bool busy = false;
            for (State& state : states) {
                const MF active = hn::Or(state.walking, state.atLeaf);
                if (hn::AllFalse(df_, active)) continue;
                busy = true;
                step(state);
            }
            if (!busy) return;
        }
    }

  private:
    struct Axis : LaneAxisState {
        VI k;       // node on the current level
        VI mirror;  // scene.mirror - 1 where mirrored, else 0
        VF rim;
    };
    struct State {
        Axis x, y;
        VI level, slot;
        VF lambda, tie;
        MF walking, atLeaf;
    };
    struct Crossing {
        VF lambda;
        MI last;
    };

    // Loads new rays into idle lanes.
    HWY_INLINE void refill(State& state) {
        const MF active = hn::Or(state.walking, state.atLeaf);
        const std::size_t idle = kLanes - hn::CountTrue(df_, active);
        if (next_ >= rays_.count || idle < (idle == kLanes ? 1 : kRefill)) return;
        HWY_ALIGN std::int32_t slots[kLanes];
        HWY_ALIGN std::int32_t fresh[kLanes];
        hn::Store(state.slot, di_, slots);
        hn::Store(hn::VecFromMask(di_, asInt(active)), di_, fresh);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const bool isIdle = fresh[lane] == 0;
            fresh[lane] = 0;
            if (!isIdle) continue;
            while (next_ < rays_.count && rays_.end[next_] != 0) ++next_;
            if (next_ >= rays_.count) continue;
            slots[lane] = static_cast<std::int32_t>(next_++);
            fresh[lane] = -1;
        }
        const MI isNew = hn::MaskFromVec(hn::Load(di_, fresh));
        if (hn::AllFalse(di_, isNew)) return;
        state.slot = hn::Load(di_, slots);
        const VI from = hn::IfThenElseZero(isNew, state.slot);
        const VF runX = hn::GatherIndex(df_, rays_.x.run.data(), from);
        const VF runY = hn::GatherIndex(df_, rays_.y.run.data(), from);
        const VI level = startLevels(hn::Max(hn::Abs(runX), hn::Abs(runY)));
        load(from, isNew, rays_.x, runX, level, state.x);
        load(from, isNew, rays_.y, runY, level, state.y);
        const MF isNewF = asFloat(isNew);
        state.tie = hn::IfThenElse(isNewF, hn::GatherIndex(df_, rays_.tie.data(), from), state.tie);
        state.lambda = hn::IfThenElse(isNewF, hn::GatherIndex(df_, rays_.begin.data(), from), state.lambda);
        state.level = hn::IfThenElse(isNew, level, state.level);
        state.walking = hn::Or(state.walking, isNewF);
    }

    // startLevel(): the bit width of an integer is the exponent of its float, plus 1.
    HWY_INLINE VI startLevels(VF run) const {
        const VI exponent = hn::ShiftRight<23>(hn::BitCast(di_, run));
        const VI level = hn::Sub(exponent, hn::Set(di_, 126 + kStartBelow));
        return hn::Min(hn::Max(level, hn::Zero(di_)), hn::Set(di_, pyramid_.top));
    }

    HWY_INLINE void load(VI from, MI isNew, const LaneAxisRays& rays, VF run, VI level, Axis& out) {
        const MF isNewF = asFloat(isNew);
        const auto take = [&](const std::array<float, kLaneSlots>& column, VF& to) {
            to = hn::IfThenElse(isNewF, hn::GatherIndex(df_, column.data(), from), to);
        };
        take(rays.inverse, out.inverse);
        take(rays.base, out.base);
        out.run = hn::IfThenElse(isNewF, hn::Abs(run), out.run);
        out.mirrored = hn::Or(hn::And(isNewF, hn::Lt(run, hn::Zero(df_))), hn::AndNot(isNewF, out.mirrored));
        if constexpr (kAddress == Address::Border) take(rays.rim, out.rim);
        const VI cell = hn::GatherIndex(di_, rays.cell.data(), from);
        const VI first = hn::GatherIndex(di_, rays.first.data(), from);
        const VI origin = kAddress == Address::Repeat ? cell : first;
        out.offset = hn::IfThenElse(isNew, hn::Neg(origin), out.offset);
        out.k = hn::IfThenElse(isNew, hn::Shr(cell, level), out.k);
        out.mirror = hn::IfThenElseZero(asInt(out.mirrored), hn::Set(di_, scene_.mirror - 1));
    }

    // First cell of the axis, in mirrored indices.
    HWY_INLINE VI low(const GridAxis& axis, const Axis& ray) const {
        return hn::IfThenElseZero(hn::Ne(ray.mirror, hn::Zero(di_)), hn::Set(di_, scene_.mirror - axis.cells));
    }

    HWY_INLINE Crossing crossing(const GridAxis& axis, const Axis& ray, VI level) const {
        const VI high = hn::Add(low(axis, ray), hn::Set(di_, axis.cells));
        Crossing out;
        const VI edge = hn::Min(hn::Shl(hn::Add(ray.k, hn::Set(di_, 1)), level), high);
        out.last = hn::Eq(edge, high);
        out.lambda = lambdaAt(ray, edge);
        if constexpr (kAddress == Address::Clamp)
            out.lambda = hn::IfThenElse(asFloat(out.last), hn::Set(df_, 1e30F), out.lambda);
        if constexpr (kAddress == Address::Border) {
            const VF margin = hn::Set(df_, kCrossingMargin);
            const VF rim = Arithmetic::mulAdd(ray.inverse, margin, hn::Add(ray.rim, margin));
            out.lambda = hn::IfThenElse(asFloat(out.last), rim, out.lambda);
        }
        return out;
    }
    HWY_INLINE VF lambdaAt(const Axis& ray, VI line) const {
        return Arithmetic::mulAdd(hn::ConvertTo(df_, hn::Add(line, ray.offset)), ray.inverse, ray.base);
    }

    HWY_INLINE VF depthAt(MI who, VI kx, VI ky, VI mirrorX, VI mirrorY, VI level) const {
        const VI x = hn::Xor(kx, hn::Shr(mirrorX, level));
        const VI y = hn::Xor(ky, hn::Shr(mirrorY, level));
        const VF unit = hn::Set(df_, static_cast<float>(kDepthUnit));
        if (HWY_UNLIKELY(!gathers_)) return hn::Mul(hn::ConvertTo(df_, someByLanes(who, x, y, level)), unit);
        return hn::Mul(hn::ConvertTo(df_, gathered(who, x, y, level, offsetOf(level))), unit);
    }
    // The depths of the lanes `who`; those of the other lanes are unspecified. offset: index of the level's first
    // depth.
    HWY_INLINE VI gathered(MI who, VI x, VI y, VI level, VI offset) const {
        const VI width = hn::Add(hn::Shr(hn::Set(di_, scene_.grid.x.cells - 1), level), hn::Set(di_, 1));
        const VI index = hn::Add(hn::Add(hn::Mul(y, width), x), offset);
        const VI word = hn::GatherOffset(di_, base_, hn::IfThenElseZero(who, hn::Add(index, index)));
        return hn::And(word, hn::Set(di_, 0xFFFF));
    }
    // The same where only some levels are gathered, or none.
    HWY_NOINLINE VI someByLanes(MI who, VI x, VI y, VI level) const {
        MI byLane = hn::And(who, hn::Lt(level, hn::Set(di_, pyramid_.firstGathered)));
        const MI others = hn::AndNot(byLane, who);
        VI depths = hn::Zero(di_);
        if (!hn::AllFalse(di_, others)) {
            const VI known = hn::IfThenElseZero(others, level);
            depths = gathered(others, x, y, level, hn::GatherIndex(di_, pyramid_.offsets.data(), known));
        }
        if (kSurface == Surface::Bilinear && pyramid_.tiled) {
            byLane = hn::AndNot(fromTiles(byLane, x, y, hn::IfThenElseZero(byLane, level), depths), byLane);
        }
        if (hn::AllFalse(di_, byLane)) return depths;
        HWY_ALIGN std::int32_t chosen[kLanes], xs[kLanes], ys[kLanes], levels[kLanes], found[kLanes];
        hn::Store(hn::VecFromMask(di_, byLane), di_, chosen);
        hn::Store(x, di_, xs), hn::Store(y, di_, ys), hn::Store(level, di_, levels), hn::Store(depths, di_, found);
        for (std::size_t n = 0; n < kLanes; ++n) {
            if (chosen[n] != 0) found[n] = pyramid_.depth(levels[n], xs[n], ys[n]);
        }
        return hn::Load(di_, found);
    }
    // TiledPyramid::depth() of levels that are not kept in memory. Sets the depths of the lanes that it returns.
    HWY_INLINE MI fromTiles(MI who, VI x, VI y, VI level, VI& depths) const {
        const TiledHeights& tiles = pyramid_.tiled->tiles();
        const TileAccess& access = tiles.access();
        const VI one = hn::Set(di_, 1), zero = hn::Zero(di_);
        const auto nodes = [&](VI node, int texels, VI& before, VI& after) HWY_ATTR {
            const VI last = hn::Shr(hn::Set(di_, texels - 1), level);
            if constexpr (kAddress == Address::Repeat) {
                before = node, after = hn::IfThenElseZero(hn::Lt(node, last), hn::Add(node, one));
            } else {
                before = hn::Max(hn::Sub(node, one), zero), after = hn::Min(node, last);
            }
        };
        VI i0, i1, j0, j1;
        nodes(x, tiles.width(), i0, i1);
        nodes(y, tiles.height(), j0, j1);
        FourHeights<DF> four;
        const MI done = heightsInTiles(df_, access, who, hn::GatherIndex(di_, access.firstGroup.data(), level),
                                       hn::GatherIndex(di_, access.groupsAcross.data(), level), i0, i1, j0, j1, four);
        const VF highest = hn::Max(hn::Max(four.h00, four.h10), hn::Max(four.h01, four.h11));
        // depthOf(): scaling by a power of two is exact, and floor(n - x) = n - ceil(x) for whole n.
        constexpr int kUnits = static_cast<int>(1 / kDepthUnit);
        const VI units = hn::ConvertTo(di_, hn::Ceil(hn::Mul(highest, hn::Set(df_, static_cast<float>(kUnits)))));
        const VI depth = hn::Min(hn::Sub(hn::Set(di_, kUnits), units), hn::Set(di_, kUnits - 1));
        depths = hn::IfThenElse(done, hn::Max(depth, zero), depths);
        return done;
    }

    HWY_INLINE VI offsetOf(VI level) const {
        if constexpr (kLanes >= kGatheredLevels) {
            return hn::TableLookupLanes(hn::LoadU(di_, pyramid_.offsets.data()), hn::IndicesFromVec(di_, level));
        } else {
            return hn::GatherIndex(di_, pyramid_.offsets.data(), level);
        }
    }

    HWY_INLINE void step(State& state) {
        const VI zero = hn::Zero(di_), one = hn::Set(di_, 1);
        const VF oneF = hn::Set(df_, 1.0F);
        // Leaf tests are made together, when enough lanes wait or no other lane walks.
        const std::size_t waiting = hn::CountTrue(df_, state.atLeaf);
        if (waiting >= kLeaves || (waiting > 0 && hn::AllFalse(df_, state.walking))) {
            leaves(state);
            refill(state);
            return;
        }
        const Crossing cx = crossing(scene_.grid.x, state.x, state.level);
        const Crossing cy = crossing(scene_.grid.y, state.y, state.level);
        const VF out = hn::Min(hn::Min(cx.lambda, cy.lambda), oneF);
        const VF depth =
            depthAt(asInt(state.walking), state.x.k, state.y.k, state.x.mirror, state.y.mirror, state.level);
        if constexpr (Arithmetic::kRecords) {
            const auto index = [&](const Axis& axis) { return hn::Xor(axis.k, hn::Shr(axis.mirror, state.level)); };
            Arithmetic::visit(state.slot, state.level, index(state.x), index(state.y), depth, state.walking);
        }
        const MF skip = hn::And(state.walking, hn::Lt(out, depth));
        const MF stop = hn::AndNot(skip, state.walking);
        const MI bottom = hn::Eq(state.level, zero);
        const MF leaf = hn::And(stop, asFloat(bottom));
        const MI descend = asInt(hn::AndNot(asFloat(bottom), stop));
        if (!hn::AllFalse(di_, descend)) {
            const VI below = hn::Sub(state.level, one);
            const VF certain = hn::Sub(state.lambda, state.tie);
            toChild(scene_.grid.x, state.x, descend, below, certain);
            toChild(scene_.grid.y, state.y, descend, below, certain);
            state.level = hn::IfThenElse(descend, below, state.level);
        }
        if constexpr (kSurface == Surface::Columns) {
            finishCandidates(state, leaf);
            state.walking = hn::AndNot(leaf, state.walking);
        } else {
            state.atLeaf = hn::Or(state.atLeaf, leaf);
            state.walking = hn::AndNot(leaf, state.walking);
        }
        if (!hn::AllFalse(df_, skip)) moveOn(state, skip, cx, cy, out);
        refill(state);
    }

    HWY_INLINE void toChild(const GridAxis& axis, Axis& ray, MI descend, VI below, VF certain) const {
        const VI first = hn::Add(ray.k, ray.k);
        const VI middle = hn::Shl(hn::Add(first, hn::Set(di_, 1)), below);
        const VI lowest = low(axis, ray);
        // The line through the start and those before it are behind the ray, however slowly it moves.
        const MI behind = hn::Not(hn::Gt(hn::Add(middle, ray.offset), hn::Zero(di_)));
        const MI far = hn::Or(behind, asInt(hn::Ge(certain, lambdaAt(ray, middle))));
        const MI exists = hn::Lt(middle, hn::Add(lowest, hn::Set(di_, axis.cells)));
        const MI only = hn::Not(hn::Gt(middle, lowest));
        const MI upper = hn::And(hn::Or(far, only), exists);
        ray.k = hn::IfThenElse(descend, hn::Sub(first, hn::VecFromMask(di_, upper)), ray.k);
    }

    // Moves to the neighbour, and one level up if that has another parent.
    HWY_INLINE void moveOn(State& state, MF who, const Crossing& cx, const Crossing& cy, VF out) {
        MF moveX = hn::And(who, hn::Le(cx.lambda, cy.lambda));
        MF moveY = hn::And(who, hn::Le(cy.lambda, cx.lambda));
        const VF oneF = hn::Set(df_, 1.0F);
        const MF ended = hn::And(who, hn::Ge(out, oneF));
        if (HWY_UNLIKELY(!hn::AllFalse(df_, ended))) {
            finish(state, ended, LaneEnd::Scalar);
            who = hn::AndNot(ended, who);
            state.walking = hn::AndNot(ended, state.walking);
        }
        const MF near = hn::And(who, hn::Lt(hn::Abs(hn::Sub(cx.lambda, cy.lambda)), state.tie));
        if (HWY_UNLIKELY(!hn::AllFalse(df_, near))) {
            // The ray passes too close to a corner to decide which neighbour comes first. If both can be skipped, the
            // order does not matter.
            const MF clear = hn::And(
                cornerWithinCells(state.tie, state.x.inverse, state.y.inverse),
                hn::And(sideClear(state, asInt(near), true, cx, out), sideClear(state, asInt(near), false, cy, out)));
            const MF unclear = hn::AndNot(clear, near);
            if (!hn::AllFalse(df_, unclear)) {
                finish(state, unclear, LaneEnd::Scalar);
                who = hn::AndNot(unclear, who);
                state.walking = hn::AndNot(unclear, state.walking);
            }
            moveX = hn::Or(moveX, near);
            moveY = hn::Or(moveY, near);
            out = hn::IfThenElse(near, hn::Max(cx.lambda, cy.lambda), out);
        }
        moveX = hn::And(moveX, who);
        moveY = hn::And(moveY, who);
        const VI oldX = state.x.k, oldY = state.y.k;
        const MI leftX = advance(scene_.grid.x, state.x, asInt(moveX), cx, state.level);
        const MI leftY = advance(scene_.grid.y, state.y, asInt(moveY), cy, state.level);
        const MI left = hn::Or(leftX, leftY);
        state.lambda = hn::IfThenElse(who, out, state.lambda);
        MI climb = hn::And(asInt(who), hn::Lt(state.level, hn::Set(di_, pyramid_.top)));
        const VI differ = hn::Or(hn::Xor(oldX, state.x.k), hn::Xor(oldY, state.y.k));
        MI changed = hn::Gt(differ, hn::Set(di_, 1));
        if constexpr (kAddress == Address::Repeat) changed = hn::Or(changed, left);
        climb = hn::And(climb, changed);
        state.level = hn::Sub(state.level, hn::VecFromMask(di_, climb));
        state.x.k = hn::IfThenElse(climb, hn::ShiftRight<1>(state.x.k), state.x.k);
        state.y.k = hn::IfThenElse(climb, hn::ShiftRight<1>(state.y.k), state.y.k);
        if constexpr (kAddress == Address::Border) {
            const MF gone = asFloat(left);
            finish(state, gone, LaneEnd::Miss);
            state.walking = hn::AndNot(gone, state.walking);
        }
    }

    // Moves to the next node. Returns the lanes that left the map or its period.
    HWY_INLINE MI advance(const GridAxis& axis, Axis& ray, MI move, const Crossing& crossing, VI level) const {
        const MI left = hn::And(move, crossing.last);
        VI next = hn::Add(ray.k, hn::Set(di_, 1));
        if constexpr (kAddress == Address::Repeat) {
            next = hn::IfThenElse(left, hn::Shr(low(axis, ray), level), next);
            ray.offset = hn::IfThenElse(left, hn::Add(ray.offset, hn::Set(di_, axis.cells)), ray.offset);
        }
        ray.k = hn::IfThenElse(move, next, ray.k);
        return left;
    }

    // Returns the rays that are certainly above the neighbouring node along one axis until they have passed the corner.
    HWY_INLINE MF sideClear(const State& state, MI who, bool alongX, const Crossing& crossing, VF out) const {
        Axis x = state.x, y = state.y;
        const MI left = alongX ? advance(scene_.grid.x, x, who, crossing, state.level)
                               : advance(scene_.grid.y, y, who, crossing, state.level);
        MI inside = who;
        if constexpr (kAddress != Address::Repeat) inside = hn::AndNot(left, who);
        const VI kx = hn::IfThenElse(inside, x.k, state.x.k), ky = hn::IfThenElse(inside, y.k, state.y.k);
        const VF depth = depthAt(who, kx, ky, x.mirror, y.mirror, state.level);
        const MF clear = hn::Lt(hn::Add(out, hn::Add(state.tie, state.tie)), depth);
        if constexpr (kAddress == Address::Clamp) return hn::Or(clear, asFloat(left));
        if constexpr (kAddress == Address::Border) return hn::AndNot(asFloat(left), clear);
        return clear;
    }

    // Leaf tests: whether the surface is certainly below the ray in a cell whose maximum is not.
    HWY_INLINE void leaves(State& state) {
        const MF who = state.atLeaf;
        const MI whoI = asInt(who);
        state.atLeaf = hn::MaskFromVec(hn::Zero(df_));
        const Crossing cx = crossing(scene_.grid.x, state.x, state.level);
        const Crossing cy = crossing(scene_.grid.y, state.y, state.level);
        const VF out = hn::Min(hn::Min(cx.lambda, cy.lambda), hn::Set(df_, 1.0F));
        // Other lanes are on other levels, where k is not a cell.
        const VI cellX = hn::IfThenElseZero(whoI, hn::Xor(state.x.k, state.x.mirror));
        const VI cellY = hn::IfThenElseZero(whoI, hn::Xor(state.y.k, state.y.mirror));
        const VF nx = hn::ConvertTo(df_, hn::Add(state.x.k, state.x.offset));
        const VF ny = hn::ConvertTo(df_, hn::Add(state.y.k, state.y.offset));
        VF in = hn::Max(lambdaAt(state.x, state.x.k), lambdaAt(state.y, state.y.k));
        in = hn::Min(hn::Max(hn::Sub(in, state.tie), hn::Zero(df_)), out);
        const Patch patch = HWY_LIKELY(scene_.gathered) ? patchAt<kAddress>(scene_, whoI, cellX, cellY)
                                                        : patchApart<kAddress>(scene_, whoI, cellX, cellY);
        const MF below = patchBelow<Arithmetic>(patch, state.x, state.y, nx, ny, in, out, state.tie);
        const MF candidates = hn::AndNot(below, who);
        finishCandidates(state, candidates);
        const MF on = hn::And(below, who);
        state.walking = hn::Or(state.walking, on);
        if (!hn::AllFalse(df_, on)) moveOn(state, on, cx, cy, out);
    }

    HWY_INLINE void finishCandidates(const State& state, MF who) {
        if (hn::AllFalse(df_, who)) return;
        noteCandidates<kAddress>(rays_, asInt(who), state.slot, hn::Xor(state.x.k, state.x.mirror),
                                 hn::Xor(state.y.k, state.y.mirror), hn::Add(state.x.k, state.x.offset),
                                 hn::Add(state.y.k, state.y.offset));
    }

    HWY_INLINE void finish(const State& state, MF who, LaneEnd end) { noteEnd(rays_, asInt(who), state.slot, end); }

    // Number of idle lanes at which new rays are loaded, and of waiting lanes at which leaf tests are made.
    static constexpr std::size_t kRefill = std::max<std::size_t>(1, kLanes / 4);
    static constexpr std::size_t kLeaves = std::max<std::size_t>(1, kLanes / 2);

    const DF df_{};
    const DI di_{};
    const FloatScene& scene_;
    const DepthPyramid& pyramid_;
    LaneRays& rays_;
    const std::int32_t* base_;
    const bool gathers_;
    std::size_t next_ = 0;
};

template <Address kAddress, Surface kSurface, class Arithmetic>
void tracePyramidIn(const FloatScene& scene, const DepthPyramid& pyramid, const RayBlock& rays, std::size_t first,
                    HitBlock& hits, LaneRays& scratch) {
    const double* const given[] = {rays.s0.data() + first, rays.t0.data() + first, rays.a.data() + first,
                                   rays.b.data() + first};
    scratch.start.fill(scene.start);
    scratch.othersCount = 0;
    setUpLanes<kAddress>(scene, given[0], given[1], given[2], given[3], scratch);
    PyramidKernel<kAddress, kSurface, Arithmetic>(scene, pyramid, scratch).run();
    periodsOfHits<kAddress>(scene, scratch.count, scratch.x);
    periodsOfHits<kAddress>(scene, scratch.count, scratch.y);
    resolveCandidates<kAddress, kSurface>(scene, given, scratch, hits, first);
}

// Traces the chunk with the kernel of the scene's surface type and addressing.
template <class Arithmetic = FastArithmetic>
void tracePyramidOn(const FloatScene& scene, const DepthPyramid& pyramid, const RayBlock& rays, std::size_t first,
                    HitBlock& hits, LaneRays& scratch) {
    forAddress(scene, [&]<Address kAddress>() {
        if (scene.surface == Surface::Bilinear) {
            tracePyramidIn<kAddress, Surface::Bilinear, Arithmetic>(scene, pyramid, rays, first, hits, scratch);
        } else {
            tracePyramidIn<kAddress, Surface::Columns, Arithmetic>(scene, pyramid, rays, first, hits, scratch);
        }
    });
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
