#include "filtering/elliptical_lanes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "filtering/lane_job.h"

// Vectors in arrays: not for the instruction sets without a fixed width.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filtering/elliptical_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "filtering/lane_texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// 2^x, x <= 0; 2^-126 below.
HWY_INLINE V exp2Of(V x) {
    const V at = hn::Max(x, set(-126));
    const V whole = hn::Round(at);
    const V rest = hn::Sub(at, whole);
    V p = set(kExp2[4]);
    for (const int n : {3, 2, 1, 0}) p = hn::Add(hn::Mul(p, rest), set(kExp2[static_cast<std::size_t>(n)]));
    const VI power = hn::ShiftLeft<23>(hn::Add(toInt(whole), setI(127)));
    return hn::Mul(p, hn::BitCast(D(), power));
}

// The same to 2e-7, for |x| < 126.
HWY_INLINE V preciseExp2Of(V x) {
    const V whole = hn::Round(x);
    const V rest = hn::Sub(x, whole);
    V p = set(kPreciseExp2[6]);
    for (const int n : {5, 4, 3, 2, 1, 0})
        p = hn::Add(hn::Mul(p, rest), set(kPreciseExp2[static_cast<std::size_t>(n)]));
    return hn::Mul(p, hn::BitCast(D(), hn::ShiftLeft<23>(hn::Add(toInt(whole), setI(127)))));
}

struct Sums {
    V red, green, blue, total;

    HWY_INLINE void add(VU redGreen, VU blueOnly, V w) {
        const DI d;
        const VU low = hn::And(redGreen, hn::Set(DU(), 0xFFFFU));
        red = hn::Add(red, hn::Mul(w, toFloat(hn::BitCast(d, low))));
        green = hn::Add(green, hn::Mul(w, toFloat(hn::BitCast(d, hn::ShiftRight<16>(redGreen)))));
        blue = hn::Add(blue, hn::Mul(w, toFloat(hn::BitCast(d, blueOnly))));
        total = hn::Add(total, w);
    }
};

// The ellipses of as many pixels as there are lanes, on their levels.
struct Footprints {
    VI level, width, height, origin, stride;
    VI cellS, cellT;       // the centre's texel of the level
    V restS, restT;        // and the way from its corner
    V slope;               // U of a row's middle = slope V
    V spanAt, spanFall;    // half a row's span: sqrt(spanAt - spanFall V^2)
    V acrossRow, downRow;  // r^2 / R^2 ... of the Gaussian's exponent: -(acrossRow (U - middle)^2 + downRow V^2)
    V firstRow, rows;      // whole numbers
};

// left: 1 for pixels that are left out.
HWY_INLINE Footprints footprintsOf(const LaneJob& job, const LaneChunk& chunk, std::size_t first,
                                   std::uint8_t* HWY_RESTRICT left) {
    const D d;
    const DI di;
    Footprints f;
    const V ux = hn::Load(d, chunk.ux + first), vx = hn::Load(d, chunk.vx + first);
    const V uy = hn::Load(d, chunk.uy + first), vy = hn::Load(d, chunk.vy + first);
    // M = J J^T and its eigenvalues: the semi-axes' squares.
    const V uu = hn::Add(hn::Mul(ux, ux), hn::Mul(uy, uy)), vv = hn::Add(hn::Mul(vx, vx), hn::Mul(vy, vy));
    const V uv = hn::Add(hn::Mul(ux, vx), hn::Mul(uy, vy)), det = hn::Sub(hn::Mul(ux, vy), hn::Mul(uy, vx));
    const V apart = hn::Sub(uu, vv), twice = hn::Add(uv, uv);
    const V root = hn::Sqrt(hn::Add(hn::Mul(apart, apart), hn::Mul(twice, twice)));
    const V largest = hn::Mul(set(0.5F), hn::Add(hn::Add(uu, vv), root));
    const V least = hn::Min(hn::Div(hn::Mul(det, det), largest), largest);
    // NaN fails.
    const auto usual = hn::And(hn::Le(largest, set(job.mostSquare)), hn::Ge(largest, set(kLeastSquare)));
    const V minor = hn::Max(least, hn::Mul(largest, set(job.perAnisotropySquare)));
    const V over = hn::Mul(minor, set(job.perFloorSquare));
    // floor(log2(minor / floor)): half the exponent of the square.
    const VI exponent = hn::Sub(hn::ShiftRight<23>(hn::BitCast(di, over)), setI(127));
    f.level = hn::Min(hn::Max(hn::ShiftRight<1>(exponent), setI(0)), setI(job.top));
    f.level = hn::IfThenElseZero(hn::RebindMask(di, usual), f.level);
    const LaneLevels& levels = *job.levels;
    const PerLane perLevel(f.level, job.top);
    f.width = perLevel(levels.width);
    f.height = perLevel(levels.height);
    f.origin = perLevel(levels.origin);
    f.stride = perLevel(levels.stride);
    const V scale = perLevel(job.scale);
    const V square = hn::Mul(scale, scale), texels = perLevel(job.texelTerm);
    const V lowest = set(job.leastMinorSquare);
    const V across = hn::Max(hn::Add(hn::Mul(minor, square), texels), lowest);
    const V along = hn::Max(hn::Add(hn::Mul(largest, square), texels), across);
    // The ellipse with these eigenvalues and M's axes.
    const V wide = hn::Sub(largest, least);
    const V share = hn::IfThenElseZero(hn::Gt(wide, hn::Zero(d)), hn::Div(hn::Sub(along, across), wide));
    const V a = hn::Add(across, hn::Mul(share, hn::Sub(vv, least)));
    const V c = hn::Add(across, hn::Mul(share, hn::Sub(uu, least)));
    const V area = hn::Mul(along, across), perA = hn::Div(set(1), a);
    f.slope = hn::Mul(hn::Mul(share, uv), perA);
    f.spanAt = hn::Mul(set(job.radiusSquare), hn::Mul(area, perA));
    f.spanFall = hn::Mul(hn::Mul(area, perA), perA);
    f.acrossRow = hn::Mul(set(job.exponent), hn::Div(a, area));
    f.downRow = hn::Mul(set(job.exponent), perA);
    const V highest = hn::Mul(set(job.radius), hn::Sqrt(a)), widest = hn::Mul(set(job.radius), hn::Sqrt(c));

    const VI mask = hn::Sub(hn::Shl(setI(1), f.level), setI(1));
    const auto split = [&](const std::int32_t* whole, const float* rest, VI& cell, V& within) HWY_ATTR {
        const VI texel = hn::Load(di, whole + first);
        cell = hn::Shr(texel, f.level);
        within = hn::Mul(hn::Add(toFloat(hn::And(texel, mask)), hn::Load(d, rest + first)), scale);
    };
    split(chunk.wholeS, chunk.restS, f.cellS, f.restS);
    split(chunk.wholeT, chunk.restT, f.cellT, f.restT);

    // On levels with narrow last texels, only what keeps clear of them.
    const V s = hn::Add(toFloat(f.cellS), f.restS), t = hn::Add(toFloat(f.cellT), f.restT);
    const V zero = hn::Zero(d), one = set(1);
    const auto inside = hn::And(
        hn::And(hn::Ge(hn::Sub(s, widest), zero), hn::Le(hn::Add(s, widest), hn::Sub(toFloat(f.width), one))),
        hn::And(hn::Ge(hn::Sub(t, highest), zero), hn::Le(hn::Add(t, highest), hn::Sub(toFloat(f.height), one))));
    const auto whole = hn::RebindMask(d, hn::Gt(perLevel(levels.whole), setI(0)));
    const auto first0 = hn::RebindMask(d, hn::Eq(f.level, setI(0)));
    const auto small = hn::And(first0, hn::Lt(largest, set(job.smallSquare)));
    const auto below = hn::RebindMask(d, hn::Lt(f.level, setI(job.top)));
    const auto valid = hn::Gt(hn::Load(d, chunk.valid + first), zero);
    const auto served = hn::AndNot(small, hn::And(hn::And(usual, below), hn::And(valid, hn::Or(whole, inside))));

    f.firstRow = hn::IfThenElseZero(served, hn::Ceil(hn::Sub(hn::Sub(f.restT, highest), set(0.5F))));
    const V lastRow = hn::Floor(hn::Sub(hn::Add(f.restT, highest), set(0.5F)));
    f.rows = hn::IfThenElseZero(served, hn::Add(hn::Sub(lastRow, f.firstRow), one));
    alignas(64) std::int32_t flags[kLanes];
    hn::Store(hn::IfThenElse(hn::RebindMask(di, served), setI(0), setI(1)), di, flags);
    for (std::size_t k = 0; k < kLanes; ++k) left[k] = static_cast<std::uint8_t>(flags[k]);
    return f;
}

// The weights of a row's texels, one after the other; x: the first one's way from the row's middle, row: what row()
// returned. Run(weight, x, row, middle).next() is called for each.
struct GaussianLanes {
    V acrossRow, downRow;
    HWY_INLINE explicit GaussianLanes(const Footprints& f) : acrossRow(f.acrossRow), downRow(f.downRow) {}
    HWY_INLINE V row(V v, V) const { return hn::Mul(downRow, hn::Mul(v, v)); }
    HWY_INLINE V at(V x, V row) const { return exp2Of(hn::Sub(hn::Neg(row), hn::Mul(acrossRow, hn::Mul(x, x)))); }

    struct Run {
        const GaussianLanes& gaussian;
        V x, row;
        HWY_INLINE Run(const GaussianLanes& g, V first, V rowTerm, V) : gaussian(g), x(first), row(rowTerm) {}
        HWY_INLINE V next() {
            const V now = gaussian.at(x, row);
            x = hn::Add(x, set(1));
            return now;
        }
    };
};
// The same where no weight is very small (kMostRunExponent): in a row each is the one before times a ratio, and the
// ratios so as well, two multiplications instead of an exponential. Off by 1e-5 after kLanePad texels, where runs end.
struct GaussianRuns : GaussianLanes {
    V bend;
    HWY_INLINE explicit GaussianRuns(const Footprints& f)
        : GaussianLanes(f), bend(preciseExp2Of(within(hn::Mul(set(-2), f.acrossRow)))) {}

    struct Run {
        V weight, ratio, bend;
        HWY_INLINE Run(const GaussianRuns& g, V x, V row, V)
            : weight(g.at(x, row)),
              ratio(preciseExp2Of(within(hn::Neg(hn::Mul(g.acrossRow, hn::Add(hn::Add(x, x), set(1))))))),
              bend(g.bend) {}
        HWY_INLINE V next() {
            const V now = weight;
            weight = hn::Mul(weight, ratio);
            ratio = hn::Mul(ratio, bend);
            return now;
        }
    };

  private:
    // Lanes that are summed are within.
    HWY_INLINE static V within(V x) { return hn::Min(hn::Max(x, set(-100)), set(100)); }
};
struct UniformLanes {
    HWY_INLINE explicit UniformLanes(const Footprints&) {}
    HWY_INLINE V row(V, V) const { return set(1); }
    struct Run {
        HWY_INLINE Run(const UniformLanes&, V, V, V) {}
        HWY_INLINE V next() const { return set(1); }
    };
};
struct TexelDistanceLanes {
    HWY_INLINE explicit TexelDistanceLanes(const Footprints&) {}
    HWY_INLINE V row(V v, V) const { return hn::Mul(v, v); }
    struct Run {
        V u, row;
        HWY_INLINE Run(const TexelDistanceLanes&, V x, V vv, V middle) : u(hn::Add(x, middle)), row(vv) {}
        HWY_INLINE V next() {
            const V now = u;
            u = hn::Add(u, set(1));
            return hn::Div(set(1), hn::Add(set(1), hn::Sqrt(hn::Add(hn::Mul(now, now), row))));
        }
    };
};

// The pixel of lane 0, texel by texel.
struct LaneLogger {
    FootprintLog* log;
    const LaneLevels& levels;
    std::int32_t level, row;
    double v;

    void add(V weight, V count, float n, V u, VI column) const {
        if (!(n < hn::GetLane(count))) return;
        const int width = levels.width[static_cast<std::size_t>(level)];
        const std::int64_t i = std::int64_t{hn::GetLane(column)} + static_cast<std::int64_t>(n);
        log->texels.push_back({addressIndex(i, width, levels.address), row, level, double{hn::GetLane(u)}, v, 1,
                               Color(hn::GetLane(weight))});
    }
};

template <class Weight, bool kLog>
HWY_INLINE void sumRow(const LaneJob& job, const Footprints& f, const Weight& weight, VI row, V v, V active, Sums& sums,
                       V& texelsRead) {
    const D d;
    const DI di;
    const V inside = hn::Sub(f.spanAt, hn::Mul(f.spanFall, hn::Mul(v, v)));
    const V zero = hn::Zero(d), half = set(0.5F), one = set(1);
    const auto some = hn::And(hn::Ge(inside, zero), hn::Gt(active, zero));
    const V reach = hn::Sqrt(hn::Max(inside, zero));
    const V offset = hn::Mul(f.slope, v), middle = hn::Add(offset, f.restS);
    // Lanes without texels here read texel 0.
    const V begin = hn::IfThenElseZero(some, hn::Ceil(hn::Sub(hn::Sub(middle, reach), half)));
    const V end = hn::Floor(hn::Sub(hn::Add(middle, reach), half));
    const V count = hn::IfThenElseZero(some, hn::Max(hn::Add(hn::Sub(end, begin), one), zero));
    texelsRead = hn::Add(texelsRead, count);
    const float longest = hn::GetLane(hn::MaxOfLanes(d, count));
    const V x = hn::Sub(hn::Add(begin, half), middle);
    const V rowTerm = weight.row(v, offset);
    const bool repeat = job.levels->address == Address::Repeat;
    VI column = hn::Add(f.cellS, toInt(begin));
    alignas(64) std::int32_t at[kLanes];
    const VI rowStart = hn::Add(f.origin, hn::Mul(row, f.stride));
    for (float done = 0; done < longest; done += kLanePad) {
        if (repeat) {
            const auto out = hn::Or(hn::Lt(column, setI(0)), hn::Not(hn::Lt(column, f.width)));
            if (!hn::AllFalse(di, out)) column = wrapped(column, f.width);
        }
        const VI from = repeat ? column : hn::Max(hn::Min(column, f.width), setI(-kLanePad));
        hn::Store(hn::Add(rowStart, from), di, at);
        const std::uint64_t* texels = job.levels->texels.data();
        const float stop = std::min(longest, done + kLanePad);
        typename Weight::Run run(weight, hn::Add(x, set(done)), rowTerm, offset);
        for (float n = done; n < stop; n += 2) {
            const Pair pair = loadPair(texels, at);
            const V n0 = set(n), n1 = set(n + 1);
            const V w0 = hn::IfThenElseZero(hn::Lt(n0, count), run.next());
            const V w1 = hn::IfThenElseZero(hn::Lt(n1, count), run.next());
            sums.add(pair.redGreen0, pair.blue0, w0);
            sums.add(pair.redGreen1, pair.blue1, w1);
            if constexpr (kLog) {
                const LaneLogger logger{job.log, *job.levels, hn::GetLane(f.level), hn::GetLane(row),
                                        hn::GetLane(f.cellT) + double{hn::GetLane(f.restT)} + hn::GetLane(v)};
                const V centre = hn::Add(toFloat(hn::Add(f.cellS, toInt(begin))), half);
                const VI start = hn::Add(f.cellS, toInt(begin));
                logger.add(w0, count, n, hn::Add(centre, n0), start);
                logger.add(w1, count, n + 1, hn::Add(centre, n1), start);
            }
            texels += 2;
        }
        column = hn::Add(column, setI(kLanePad));
    }
}

template <class Weight, bool kLog>
void filterVector(const LaneJob& job, const LaneChunk& chunk, std::size_t first, std::uint8_t* left,
                  Color* HWY_RESTRICT colors, FootprintCounts& counts) {
    const D d;
    const DI di;
    const Footprints f = footprintsOf(job, chunk, first, left);
    const Weight weight(f);
    const V zero = hn::Zero(d);
    Sums sums{zero, zero, zero, zero};
    V texels = zero;
    const bool repeat = job.levels->address == Address::Repeat;
    VI row = hn::Add(f.cellT, toInt(f.firstRow));
    if (repeat) row = wrapped(row, f.height);
    const float most = hn::GetLane(hn::MaxOfLanes(d, f.rows));
    for (float r = 0; r < most; r += 1) {
        const V v = hn::Sub(hn::Add(hn::Add(f.firstRow, set(r)), set(0.5F)), f.restT);
        const V active = hn::Sub(f.rows, set(r));
        const VI in = repeat ? row : hn::Max(hn::Min(row, hn::Sub(f.height, setI(1))), setI(0));
        sumRow<Weight, kLog>(job, f, weight, in, v, active, sums, texels);
        row = hn::Add(row, setI(1));
        if (repeat) row = hn::IfThenElseZero(hn::Lt(row, f.height), row);
    }
    const V per = hn::Mul(sums.total, set(kLaneWhite));
    alignas(64) float red[kLanes], green[kLanes], blue[kLanes], total[kLanes], read[kLanes];
    hn::Store(hn::Div(sums.red, per), d, red);
    hn::Store(hn::Div(sums.green, per), d, green);
    hn::Store(hn::Div(sums.blue, per), d, blue);
    hn::Store(sums.total, d, total);
    hn::Store(texels, d, read);
    (void)di;
    for (std::size_t k = 0; k < kLanes; ++k) {
        if (first + k >= chunk.count || left[k] != 0) continue;
        if (!(total[k] > 0)) {
            left[k] = 1;
            continue;
        }
        colors[k] = {red[k], green[k], blue[k]};
        ++counts.footprints;
        counts.texels += static_cast<std::int64_t>(read[k]);
    }
}

template <class Weight, bool kLog>
void filterChunks(const LaneJob& job, FootprintCounts& counts) {
    LaneChunk chunk;
    for (std::size_t begin = 0; begin < job.count; begin += kLanePixels) {
        fillChunk(job, begin, chunk);
        for (std::size_t k = 0; k < chunk.count; k += kLanes) {
            std::uint8_t left[kLanes];
            filterVector<Weight, kLog>(job, chunk, k, left, job.colors + begin + k, counts);
            for (std::size_t n = 0; n < kLanes && k + n < chunk.count; ++n) job.left[begin + k + n] = left[n];
        }
    }
}

template <class Weight>
void filterWith(const LaneJob& job, FootprintCounts& counts) {
    job.log != nullptr ? filterChunks<Weight, true>(job, counts) : filterChunks<Weight, false>(job, counts);
}

void filterLanes(const LaneJob& job, FootprintCounts& counts) {
    switch (job.weights) {
        case WeightKind::Uniform:
            return filterWith<UniformLanes>(job, counts);
        case WeightKind::TexelDistance:
            return filterWith<TexelDistanceLanes>(job, counts);
        default:
            if (job.exponent * job.radiusSquare > kMostRunExponent) return filterWith<GaussianLanes>(job, counts);
            return filterWith<GaussianRuns>(job, counts);
    }
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(filterLanes);

EllipticalLanes::EllipticalLanes(std::shared_ptr<const LaneLevels> levels, const EllipticalSettings& settings)
    : job_(laneJob(*levels, settings)), levels_(std::move(levels)) {
    assert(serves(settings));
}

bool EllipticalLanes::serves(const EllipticalSettings& settings) {
    return !settings.shaped() && !settings.exhaustive && settings.source == WeightSource::Direct;
}

void EllipticalLanes::filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors,
                             std::span<std::uint8_t> left, FootprintCounts& counts, FootprintLog* log) const {
    assert(colors.size() <= block.size() && left.size() == colors.size() && (log == nullptr || colors.size() == 1));
    LaneJob job = job_;
    job.s = block.s.data(), job.t = block.t.data();
    job.ux = block.ux.data(), job.vx = block.vx.data();
    job.uy = block.uy.data(), job.vy = block.vy.data();
    job.count = colors.size();
    job.perS = scale.x, job.perT = scale.y;
    job.colors = colors.data(), job.left = left.data();
    job.log = log;
    HWY_DYNAMIC_DISPATCH(filterLanes)(job, counts);
}

}  // namespace relief
#endif
