// SIMD version of HeightField::at in double, with the same bits. Compiled for each target.

#if defined(RELIEF_SURFACE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_SURFACE_LANES_INL_H
#undef RELIEF_SURFACE_LANES_INL_H
#else
#define RELIEF_SURFACE_LANES_INL_H
#endif

#include "relief/cell_grid.h"
#include "relief/height_source.h"
#include "relief/simd/double_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// In texels: below this, products of periods are integers below 2^53.
constexpr double kFar = 0x1p40;

class SurfaceLanes {
  public:
    explicit SurfaceLanes(const HeightField& field)
        : field_(field),
          heights_(gathersHeights(field) ? field.heights().data() : nullptr),
          width_(field.width()),
          height_(field.height()),
          repeats_(field.address() == Address::Repeat),
          columns_(field.surface() == Surface::Columns) {}

    HWY_INLINE V at(V s, V t) const {
        if (columns_)
            return texel(addressed(hn::Floor(reduced(s, width_)), width_),
                         addressed(hn::Floor(reduced(t, height_)), height_));
        const V one = constant(1), half = constant(0.5);
        const V x = reduced(hn::Sub(s, half), width_), y = reduced(hn::Sub(t, half), height_);
        const V i = hn::Floor(x), j = hn::Floor(y);
        const V u = hn::Sub(x, i), v = hn::Sub(y, j);
        const V i0 = addressed(i, width_), i1 = addressed(hn::Add(i, one), width_);
        const V j0 = addressed(j, height_), j1 = addressed(hn::Add(j, one), height_);
        const V rest = hn::Sub(one, u);
        const V top = hn::Add(hn::Mul(rest, texel(i0, j0)), hn::Mul(u, texel(i1, j0)));
        const V bottom = hn::Add(hn::Mul(rest, texel(i0, j1)), hn::Mul(u, texel(i1, j1)));
        return hn::Add(hn::Mul(hn::Sub(one, v), top), hn::Mul(v, bottom));
    }

    // Whether the places are on the map, its rim included.
    HWY_INLINE M inside(V s, V t) const {
        const V zero = hn::Zero(D());
        return hn::And(hn::And(hn::Ge(s, zero), hn::Le(s, constant(width_))),
                       hn::And(hn::Ge(t, zero), hn::Le(t, constant(height_))));
    }
    // relief::reduceToPeriod() under repeat, for coordinates below 2^40.
    HWY_INLINE V reduceToPeriod(V x, double size) const {
        const V n = constant(size), zero = hn::Zero(D()), rest = reduced(x, size);
        const V positive = hn::IfThenElse(hn::Lt(rest, zero), hn::Add(rest, n), rest);
        return hn::IfThenElse(hn::Ge(positive, n), zero, positive);
    }

  private:
    // Repeat: std::fmod, whose remainder is exact; a quotient that is off by one is corrected. Otherwise clamps to [-1,
    // n + 1].
    HWY_INLINE V reduced(V x, double size) const {
        const V n = constant(size), zero = hn::Zero(D());
        if (!repeats_) return hn::Min(hn::Max(x, constant(-1)), constant(size + 1));
        const V whole = hn::Floor(hn::Mul(hn::Abs(x), constant(1 / size)));
        V rest = hn::Sub(hn::Abs(x), hn::Mul(whole, n));
        rest = hn::IfThenElse(hn::Lt(rest, zero), hn::Add(rest, n), rest);
        rest = hn::IfThenElse(hn::Ge(rest, n), hn::Sub(rest, n), rest);
        return hn::CopySign(rest, x);
    }
    HWY_INLINE V addressed(V i, double size) const {
        const V n = constant(size), zero = hn::Zero(D());
        if (!repeats_) return hn::Min(hn::Max(i, zero), constant(size - 1));
        const V raised = hn::IfThenElse(hn::Lt(i, zero), hn::Add(i, n), i);
        return hn::IfThenElse(hn::Ge(raised, n), hn::Sub(raised, n), raised);
    }
    HWY_INLINE V texel(V i, V j) const {
        if (HWY_UNLIKELY(heights_ == nullptr)) return texelByLanes(i, j);
        const V number = hn::Add(hn::Mul(j, constant(width_)), i);
        const auto at = hn::DemoteTo(hn::Rebind<std::int32_t, D>(), number);
        return hn::PromoteTo(D(), hn::GatherIndex(hn::Rebind<float, D>(), heights_, at));
    }

    HWY_NOINLINE V texelByLanes(V i, V j) const {
        HWY_ALIGN double x[hn::MaxLanes(D())], y[hn::MaxLanes(D())];
        hn::Store(i, D(), x), hn::Store(j, D(), y);
        for (std::size_t n = 0; n < hn::Lanes(D()); ++n) {
            x[n] = static_cast<double>(field_.texel(static_cast<std::int64_t>(x[n]), static_cast<std::int64_t>(y[n])));
        }
        return hn::Load(D(), x);
    }

    const HeightField& field_;
    const float* heights_;  // null: they are read lane by lane
    double width_;
    double height_;
    bool repeats_;
    bool columns_;
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
