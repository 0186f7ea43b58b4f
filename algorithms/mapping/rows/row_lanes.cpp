#include "mapping/rows/row_lanes.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/simd_targets.h"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mapping/rows/row_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace relief::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kLineBytes = 64;

template <bool kPastCache, class D, typename T>
void put(hn::Vec<D> value, D d, T* to) {
    if constexpr (kPastCache) {
        hn::Stream(value, d, to);
    } else {
        hn::StoreU(value, d, to);
    }
}

// Runs k streams in k / N vectors of N lanes.
template <typename T, std::size_t k, bool kPastCache>
void streamsInLanes(const RowTerms<T>& row, T* HWY_RESTRICT u, T* HWY_RESTRICT v) {
    using D = hn::CappedTag<T, k>;
    using V = hn::Vec<D>;
    const D d;
    constexpr std::size_t N = hn::MaxLanes(D());
    constexpr std::size_t kVectors = k / N;
    const V stepU = hn::Set(d, row.stepA(k)), stepV = hn::Set(d, row.stepD(k)), stepQ = hn::Set(d, row.stepG(k));
    alignas(kLineBytes) std::array<T, k> offsetU, offsetV, offsetQ;
    for (std::size_t j = 0; j < k; ++j) {
        const auto n = static_cast<std::int64_t>(j);
        offsetU[j] = row.stepA(n), offsetV[j] = row.stepD(n), offsetQ[j] = row.stepG(n);
    }
    const std::int64_t length = row.anchor > 0 ? row.anchor : row.count;
    for (std::int64_t begin = 0, end = 0; begin < row.count; begin = end) {
        end = std::min(begin + length, row.count);
        const V startU = hn::Set(d, row.wuAt(begin));
        const V startV = hn::Set(d, row.wvAt(begin));
        const V startQ = hn::Set(d, row.qAt(begin));
        V wu[kVectors], wv[kVectors], q[kVectors];
        for (std::size_t i = 0; i < kVectors; ++i) {
            wu[i] = hn::Add(startU, hn::Load(d, offsetU.data() + i * N));
            wv[i] = hn::Add(startV, hn::Load(d, offsetV.data() + i * N));
            q[i] = hn::Add(startQ, hn::Load(d, offsetQ.data() + i * N));
        }
        std::int64_t n = begin;
        for (; n + static_cast<std::int64_t>(k) <= end; n += k) {
            for (std::size_t i = 0; i < kVectors; ++i) {
                put<kPastCache>(hn::Div(wu[i], q[i]), d, u + n + i * N);
                put<kPastCache>(hn::Div(wv[i], q[i]), d, v + n + i * N);
                wu[i] = hn::Add(wu[i], stepU);
                wv[i] = hn::Add(wv[i], stepV);
                q[i] = hn::Add(q[i], stepQ);
            }
        }
        if (n == end) continue;
        alignas(kLineBytes) std::array<T, k> restU, restV;
        for (std::size_t i = 0; i < kVectors; ++i) {
            hn::Store(hn::Div(wu[i], q[i]), d, restU.data() + i * N);
            hn::Store(hn::Div(wv[i], q[i]), d, restV.data() + i * N);
        }
        std::copy_n(restU.data(), end - n, u + n);
        std::copy_n(restV.data(), end - n, v + n);
    }
}

template <typename T, std::size_t k>
void streamsPlaced(const RowTerms<T>& row, bool pastCache, T* u, T* v) {
    // Stream() needs whole aligned vectors. Each restart interval begins at a multiple of k.
    constexpr std::size_t kBytes = std::min(k * sizeof(T), kLineBytes);
    const auto aligned = [](const T* p) { return reinterpret_cast<std::uintptr_t>(p) % kLineBytes == 0; };
    if (pastCache && kBytes == kLineBytes && aligned(u) && aligned(v)) {
        streamsInLanes<T, k, true>(row, u, v);
    } else {
        streamsInLanes<T, k, false>(row, u, v);
    }
}

template <typename T>
void streams(const RowTerms<T>& row, std::int64_t k, bool pastCache, T* u, T* v) {
    switch (k) {
        case 2:
            return streamsPlaced<T, 2>(row, pastCache, u, v);
        case 4:
            return streamsPlaced<T, 4>(row, pastCache, u, v);
        case 8:
            return streamsPlaced<T, 8>(row, pastCache, u, v);
        case 16:
            return streamsPlaced<T, 16>(row, pastCache, u, v);
        default:
            return streamsPlaced<T, 32>(row, pastCache, u, v);
    }
}

void streamsFloat(const RowTerms<float>& row, std::int64_t k, bool pastCache, float* u, float* v) {
    streams(row, k, pastCache, u, v);
}
void streamsDouble(const RowTerms<double>& row, std::int64_t k, bool pastCache, double* u, double* v) {
    streams(row, k, pastCache, u, v);
}

template <typename T>
void fill(T* to, std::int64_t count, T value) {
    const hn::ScalableTag<T> d;
    const auto lanes = static_cast<std::int64_t>(hn::Lanes(d));
    const auto vector = hn::Set(d, value);
    std::int64_t n = 0;
    while (n < count && reinterpret_cast<std::uintptr_t>(to + n) % kLineBytes != 0) to[n++] = value;
    for (; n + lanes <= count; n += lanes) hn::Stream(vector, d, to + n);
    for (; n < count; ++n) to[n] = value;
}
void fillFloat(float* to, std::int64_t count, float value) {
    fill(to, count, value);
}
void fillDouble(double* to, std::int64_t count, double value) {
    fill(to, count, value);
}

}  // namespace relief::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace relief {

HWY_EXPORT(streamsFloat);
HWY_EXPORT(streamsDouble);
HWY_EXPORT(fillFloat);
HWY_EXPORT(fillDouble);

bool hasStreamLanes(std::int64_t k) {
    return k == 2 || k == 4 || k == 8 || k == 16 || k == 32;
}

void streamsRowLanes(const RowTerms<float>& row, std::int64_t k, bool pastCache, float* u, float* v) {
    assert(hasStreamLanes(k) && row.anchor % k == 0 && row.count > 0);
    HWY_DYNAMIC_DISPATCH(streamsFloat)(row, k, pastCache, u, v);
}
void streamsRowLanes(const RowTerms<double>& row, std::int64_t k, bool pastCache, double* u, double* v) {
    assert(hasStreamLanes(k) && row.anchor % k == 0 && row.count > 0);
    HWY_DYNAMIC_DISPATCH(streamsDouble)(row, k, pastCache, u, v);
}

void finishStores() {
    hwy::FlushStream();
}

void fillPastCache(float* to, std::int64_t count, float value) {
    HWY_DYNAMIC_DISPATCH(fillFloat)(to, count, value);
}
void fillPastCache(double* to, std::int64_t count, double value) {
    HWY_DYNAMIC_DISPATCH(fillDouble)(to, count, value);
}

std::vector<std::int64_t> laneTargets() {
    return hwy::SupportedAndGeneratedTargets();
}

const char* laneTargetName(std::int64_t target) {
    return hwy::TargetName(target);
}

void forceLaneTarget(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace relief
#endif
