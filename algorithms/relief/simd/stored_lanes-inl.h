// Values of a stored map in vectors of doubles. Compiled for each target.

#if defined(RELIEF_STORED_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RELIEF_STORED_LANES_INL_H
#undef RELIEF_STORED_LANES_INL_H
#else
#define RELIEF_STORED_LANES_INL_H
#endif

#include "relief/maps/stored_values.h"
#include "relief/simd/double_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

// addressIndex() for whole numbers below 2^52.
HWY_INLINE V addressedIndex(V i, double size, bool repeats) {
    const V n = constant(size), zero = hn::Zero(D());
    if (!repeats) return hn::Min(hn::Max(i, zero), constant(size - 1));
    const V rest = hn::Sub(i, hn::Mul(hn::Floor(hn::Mul(i, constant(1 / size))), n));
    const V raised = hn::IfThenElse(hn::Lt(rest, zero), hn::Add(rest, n), rest);
    return hn::IfThenElse(hn::Ge(raised, n), hn::Sub(raised, n), raised);
}

// StoredValues by the number of the value: layer by layer, row by row. fitsLanes() holds for the values.
class StoredLanes {
  public:
    explicit StoredLanes(const StoredValues& values) : values_(values) {
        const auto* floats = std::get_if<UnfilledVector<float>>(&values.codes());
        floats_ = floats == nullptr ? nullptr : floats->data();
    }

    HWY_INLINE V at(V number) const {
        if (HWY_UNLIKELY(floats_ == nullptr)) return byLanes(number);
        return hn::PromoteTo(D(), hn::GatherIndex(DF(), floats_, hn::DemoteTo(DI(), number)));
    }

  private:
    // Codes of 16 and 8 bits, for which there is no gather.
    HWY_NOINLINE V byLanes(V number) const {
        Row<double> all;
        store(number, all);
        for (double& each : all) each = static_cast<double>(values_(static_cast<int>(each), 0, 0));
        return load(all);
    }

    const StoredValues& values_;
    const float* floats_;  // null: the values are codes
};

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
