#include "filtering/elliptical_lanes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "filtering/lane_job.h"

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filtering/simd/elliptical_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include "filtering/simd/lane_bilinear-inl.h"
#include "filtering/simd/lane_texels-inl.h"
#include "filtering/simd/lane_weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

struct Sums : PointSums {
    V total;

    HWY_INLINE void add(VU redGreen, VU blueOnly, V w) {
        PointSums::add(redGreen, blueOnly, w);
        total = hn::Add(total, w);
    }
};

// The ellipses of a vector of pixels, each on its level.
struct Footprints {
    VI level, width, height, origin, stride;
    VI cellS, cellT;       // texel of the level that contains the centre
    V restS, restT;        // position of the centre in that texel
    V slope;               // at V, the middle of the row's span is at U = slope V
    V spanAt, spanFall;    // half the length of a row's span is sqrt(spanAt - spanFall V^2)
    V acrossRow, downRow;  // a Gaussian's base-2 exponent is -(acrossRow (U - middle)^2 + downRow V^2)
    V firstRow, rows;      // integers
    V small;               // 1 for pixels with nothing to average: bilinear, no rows
};

// fallback: set to 1 for pixels that are not supported.
HWY_INLINE Footprints footprintsOf(const LaneJob& job, const LaneChunk& chunk, std::size_t first,
                                   std::uint8_t* HWY_RESTRICT fallback) {
    const D d;
    const DI di;
    Footprints f;
    const V ux = hn::Load(d, chunk.ux + first), vx = hn::Load(d, chunk.vx + first);
    const V uy = hn::Load(d, chunk.uy + first), vy = hn::Load(d, chunk.vy + first);
    // M = J J^T and its eigenvalues, which are the squares of the semi-axes.
    const V uu = hn::Add(hn::Mul(ux, ux), hn::Mul(uy, uy)), vv = hn::Add(hn::Mul(vx, vx), hn::Mul(vy, vy));
    const V uv = hn::Add(hn::Mul(ux, vx), hn::Mul(uy, vy)), det = hn::Sub(hn::Mul(ux, vy), hn::Mul(uy, vx));
    const V apart = hn::Sub(uu, vv), twice = hn::Add(uv, uv);
    const V root = hn::Sqrt(hn::Add(hn::Mul(apart, apart), hn::Mul(twice, twice)));
    const V largest = hn::Mul(set(0.5F), hn::Add(hn::Add(uu, vv), root));
    const V least = hn::Min(hn::Div(hn::Mul(det, det), largest), largest);
    // Written so that NaN is not supported.
    const auto usual = hn::And(hn::Le(largest, set(job.mostSquare)), hn::Ge(largest, set(kLeastSquare)));
    const V minor = hn::Max(least, hn::Mul(largest, set(job.perAnisotropySquare)));
    const V over = hn::Mul(minor, set(job.perFloorSquare));
    // floor(log2(minor / floor)) is half the exponent of the square.
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

    // On levels with narrow last texels, only footprints that do not touch these are supported.
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
    const auto near = hn::And(hn::And(usual, below), valid);
    const auto averaged = hn::And(hn::AndNot(small, near), hn::Or(whole, inside));
    const auto bilinear = hn::And(small, near);
    f.small = hn::IfThenElseZero(bilinear, one);

    f.firstRow = hn::IfThenElseZero(averaged, hn::Ceil(hn::Sub(hn::Sub(f.restT, highest), set(0.5F))));
    const V lastRow = hn::Floor(hn::Sub(hn::Add(f.restT, highest), set(0.5F)));
    f.rows = hn::IfThenElseZero(averaged, hn::Add(hn::Sub(lastRow, f.firstRow), one));
    alignas(64) std::int32_t flags[kLanes];
    hn::Store(hn::IfThenElse(hn::RebindMask(di, hn::Or(averaged, bilinear)), setI(0), setI(1)), di, flags);
    for (std::size_t k = 0; k < kLanes; ++k) fallback[k] = static_cast<std::uint8_t>(flags[k]);
    return f;
}

// A span: the texels of one row of each pixel, or at most kLanePad of them.
template <class Weight>
struct Span {
    typename Weight::Run run;
    V x, rowTerm, middle;                 // input of the run
    V count;                              // number of texels
    alignas(64) std::int32_t at[kLanes];  // the first texel
    VI row, column;                       // for the log only: its row and column; v: middle of the row
    V v;
};

// Sums the spans of a vector of pixels, row by row. Several spans are prepared before the first is summed, because
// preparing a span is a long chain of dependent operations and the number of its texels must be known before the next
// can start.
template <class Weight, bool kLog>
class SpanSums {
  public:
    HWY_INLINE SpanSums(const LaneJob& job, const Footprints& f) : job_(job), f_(f), weight_(f.acrossRow, f.downRow) {}

    V texels = hn::Zero(D());
    Sums sums{{hn::Zero(D()), hn::Zero(D()), hn::Zero(D())}, hn::Zero(D())};

    // active: above 0 for pixels that have this row.
    HWY_INLINE void addRow(VI row, V v, V active) {
        const D d;
        const DI di;
        const V inside = hn::Sub(f_.spanAt, hn::Mul(f_.spanFall, hn::Mul(v, v)));
        const V zero = hn::Zero(d), half = set(0.5F), one = set(1);
        const auto some = hn::And(hn::Ge(inside, zero), hn::Gt(active, zero));
        const V reach = hn::Sqrt(hn::Max(inside, zero));
        const V offset = hn::Mul(f_.slope, v), middle = hn::Add(offset, f_.restS);
        // Lanes without texels in this row read texel 0.
        const V begin = hn::IfThenElseZero(some, hn::Ceil(hn::Sub(hn::Sub(middle, reach), half)));
        const V end = hn::Floor(hn::Sub(hn::Add(middle, reach), half));
        const V count = hn::IfThenElseZero(some, hn::Max(hn::Add(hn::Sub(end, begin), one), zero));
        texels = hn::Add(texels, count);
        // Lanes without texels use the middle: weights that are NaN or denormal would be slow.
        const V x = hn::IfThenElseZero(some, hn::Sub(hn::Add(begin, half), middle));
        const V rowTerm = weight_.row(v, offset);
        VI column = hn::Add(f_.cellS, toInt(begin));
        const VI rowStart = hn::Add(f_.origin, hn::Mul(row, f_.stride));
        V remaining = count;
        float done = 0;
        while (true) {
            if (made_ == kSpansAhead) sumSpans();
            Span<Weight>& span = spans_[made_++];
            VI from = column;
            if (job_.levels->address == Address::Repeat) {
                const auto out = hn::Or(hn::Lt(column, setI(0)), hn::Not(hn::Lt(column, f_.width)));
                if (!hn::AllFalse(di, out)) from = column = wrapped(column, f_.width);
            } else {
                from = hn::Max(hn::Min(column, f_.width), setI(-kLanePad));
            }
            hn::Store(hn::Add(rowStart, from), di, span.at);
            span.count = hn::Min(remaining, set(kLanePad));
            span.x = hn::Add(x, set(done)), span.rowTerm = rowTerm, span.middle = offset;
            if constexpr (kLog) {
                span.row = row, span.v = v;
                span.column = hn::Add(hn::Add(f_.cellS, toInt(begin)), toInt(set(done)));
            }
            remaining = hn::Sub(remaining, set(kLanePad));
            if (HWY_LIKELY(hn::AllFalse(d, hn::Gt(remaining, zero)))) break;
            column = hn::Add(column, setI(kLanePad));
            done += kLanePad;
        }
    }

    HWY_INLINE void sumSpans() {
        const D d;
        const V zero = hn::Zero(d), one = set(1), two = set(2);
        const std::uint64_t* const first = job_.levels->texels.data();
        // Exponentials are long chains of dependent operations as well, so they are computed for all spans first.
        for (std::size_t i = 0; i < made_; ++i) {
            Span<Weight>& span = spans_[i];
            span.run = typename Weight::Run(weight_, span.x, span.rowTerm, span.middle);
        }
        Sums all = sums;
        for (std::size_t i = 0; i < made_; ++i) {
            const Span<Weight>& span = spans_[i];
            typename Weight::Run run = span.run;
            V count = span.count;
            const std::uint64_t* texels = first;
            for (auto some = hn::Gt(count, zero); !hn::AllFalse(d, some); some = hn::Gt(count, zero)) {
                const Pair pair = loadPair(texels, span.at);
                const V w0 = hn::IfThenElseZero(some, run.next(weight_));
                const V w1 = hn::IfThenElseZero(hn::Gt(count, one), run.next(weight_));
                all.add(pair.redGreen0, pair.blue0, w0);
                all.add(pair.redGreen1, pair.blue1, w1);
                if constexpr (kLog) log(span, texels - first, w0), log(span, texels - first + 1, w1);
                count = hn::Sub(count, two);
                texels += 2;
            }
        }
        sums = all;
        made_ = 0;
    }

  private:
    static constexpr std::size_t kSpansAhead = 16;

    // Logs a texel of the pixel in lane 0.
    void log(const Span<Weight>& span, std::int64_t n, V weight) const {
        if (!(static_cast<float>(n) < hn::GetLane(span.count))) return;
        const LaneLevels& levels = *job_.levels;
        const std::int32_t level = hn::GetLane(f_.level);
        const int width = levels.width[static_cast<std::size_t>(level)];
        const std::int64_t i = hn::GetLane(span.column) + n;
        const double u = static_cast<double>(i) + 0.5;
        const double v = hn::GetLane(f_.cellT) + double{hn::GetLane(f_.restT)} + hn::GetLane(span.v);
        job_.log->texels.push_back(
            {addressIndex(i, width, levels.address), hn::GetLane(span.row), level, u, v, Color(hn::GetLane(weight))});
    }

    const LaneJob& job_;
    const Footprints& f_;
    Weight weight_;
    std::size_t made_ = 0;
    Span<Weight> spans_[kSpansAhead];
};

// Adds the colours of small pixels, whose sums are empty.
HWY_INLINE void readSmall(const LaneJob& job, const Footprints& f, Sums& sums) {
    const D d;
    PointSums read{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
    addBilinear(*job.levels, f, f.restS, f.restT, f.small, read);
    sums.red = hn::Add(sums.red, read.red);
    sums.green = hn::Add(sums.green, read.green);
    sums.blue = hn::Add(sums.blue, read.blue);
    sums.total = hn::Add(sums.total, f.small);
}

template <class Weight, bool kLog>
void filterVector(const LaneJob& job, const LaneChunk& chunk, std::size_t first, std::uint8_t* fallback,
                  Color* HWY_RESTRICT colors, FootprintCounts& counts) {
    const D d;
    const Footprints f = footprintsOf(job, chunk, first, fallback);
    SpanSums<Weight, kLog> spans(job, f);
    const bool repeat = job.levels->address == Address::Repeat;
    VI row = hn::Add(f.cellT, toInt(f.firstRow));
    if (repeat) row = wrapped(row, f.height);
    const float most = hn::GetLane(hn::MaxOfLanes(d, f.rows));
    for (float r = 0; r < most; r += 1) {
        const V v = hn::Sub(hn::Add(hn::Add(f.firstRow, set(r)), set(0.5F)), f.restT);
        const V active = hn::Sub(f.rows, set(r));
        const VI in = repeat ? row : hn::Max(hn::Min(row, hn::Sub(f.height, setI(1))), setI(0));
        spans.addRow(in, v, active);
        row = hn::Add(row, setI(1));
        if (repeat) row = hn::IfThenElseZero(hn::Lt(row, f.height), row);
    }
    spans.sumSpans();
    Sums sums = spans.sums;
    const auto small = hn::Gt(f.small, hn::Zero(d));
    if (!hn::AllFalse(d, small)) readSmall(job, f, sums);
    const V per = hn::Mul(sums.total, set(kLaneWhite));
    alignas(64) float red[kLanes], green[kLanes], blue[kLanes], total[kLanes], read[kLanes], smallOnes[kLanes];
    hn::Store(hn::Div(sums.red, per), d, red);
    hn::Store(hn::Div(sums.green, per), d, green);
    hn::Store(hn::Div(sums.blue, per), d, blue);
    hn::Store(sums.total, d, total);
    hn::Store(hn::IfThenElse(small, set(4), spans.texels), d, read);
    hn::Store(f.small, d, smallOnes);
    for (std::size_t k = 0; k < kLanes; ++k) {
        if (first + k >= chunk.count || fallback[k] != 0) continue;
        if (!(total[k] > 0)) {
            fallback[k] = 1;
            continue;
        }
        colors[k] = {red[k], green[k], blue[k]};
        ++(smallOnes[k] > 0 ? counts.bilinear : counts.footprints);
        counts.texels += static_cast<std::int64_t>(read[k]);
    }
}

template <class Weight, bool kLog>
void filterChunks(const LaneJob& job, FootprintCounts& counts) {
    LaneChunk chunk;
    for (std::size_t begin = 0; begin < job.count; begin += kLanePixels) {
        fillChunk(job, begin, chunk);
        for (std::size_t k = 0; k < chunk.count; k += kLanes) {
            std::uint8_t fallback[kLanes];
            filterVector<Weight, kLog>(job, chunk, k, fallback, job.colors + begin + k, counts);
            for (std::size_t n = 0; n < kLanes && k + n < chunk.count; ++n) job.fallback[begin + k + n] = fallback[n];
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
                             std::span<std::uint8_t> fallback, FootprintCounts& counts, FootprintLog* log) const {
    assert(colors.size() <= block.size() && fallback.size() == colors.size() && (log == nullptr || colors.size() == 1));
    LaneJob job = job_;
    job.s = block.s.data(), job.t = block.t.data();
    job.ux = block.ux.data(), job.vx = block.vx.data();
    job.uy = block.uy.data(), job.vy = block.vy.data();
    job.count = colors.size();
    job.perS = scale.x, job.perT = scale.y;
    job.colors = colors.data(), job.fallback = fallback.data();
    job.log = log;
    HWY_DYNAMIC_DISPATCH(filterLanes)(job, counts);
}

}  // namespace relief
#endif
