// Texture coordinates along a row: the reference implementation of every variant, to be read next to the papers'
// formulas. rows.h describes the variants, their cost and their use. row_lanes.cpp is the SIMD version of streamsRow.
//
// Each writes u[n], v[n] (texels) for n in [0, row.count); q must remain positive on the whole row (rows.h clips).
// Templates over the scalar: float, double, a counting scalar. Source: [PERSP], with its formula numbers in
// parentheses; only the last, sub-spans, is from Heckbert and the games of the 1990s.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mapping/rows/rows.h"

namespace relief {

// Calls visit(begin, end) for each interval between exact restarts.
template <typename Visit>
void forEachStretch(std::int64_t count, std::int64_t anchor, const Visit& visit) {
    const std::int64_t length = anchor > 0 ? anchor : std::max<std::int64_t>(count, 1);
    for (std::int64_t begin = 0; begin < count; begin += length) visit(begin, std::min(begin + length, count));
}

// Affine: u is linear between the row's ends, without perspective.
template <typename T>
void affineRow(const RowTerms<T>& row, T* u, T* v) {
    const std::int64_t last = row.count - 1;
    T s = row.uAt(0);
    T t = row.vAt(0);
    const T ds = last > 0 ? (row.uAt(last) - s) / numberOf<T>(last) : T(0);
    const T dt = last > 0 ? (row.vAt(last) - t) / numberOf<T>(last) : T(0);
    for (std::int64_t n = 0; n < row.count; ++n) {
        u[n] = s;
        v[n] = t;
        s += ds;
        t += dt;
    }
}

// (1): u = (A x + B y + C) / (G x + H y + I), with the operations that the paper counts: q is computed twice.
template <typename T>
void directRow(const RowTerms<T>& row, T* u, T* v) {
    for (std::int64_t n = 0; n < row.count; ++n) {
        const T x = row.x(n);
        u[n] = (row.a * x + row.b * row.y + row.c) / (row.g * x + row.h * row.y + row.i);
        v[n] = (row.d * x + row.e * row.y + row.f) / (row.g * x + row.h * row.y + row.i);
    }
}

// (3): u_n = (u_t + A n) / (u_b + G n).
template <typename T>
void rowConstantRow(const RowTerms<T>& row, T* u, T* v) {
    const T ut = row.wuAt(0);
    const T vt = row.wvAt(0);
    const T ub = row.qAt(0);
    for (std::int64_t n = 0; n < row.count; ++n) {
        const T number = numberOf<T>(n);
        u[n] = (ut + row.a * number) / (ub + row.g * number);
        v[n] = (vt + row.d * number) / (ub + row.g * number);
    }
}

// (4): w_n+1 = w_n + A, q_n+1 = q_n + G, with a denominator for each of u and v.
template <typename T>
void incrementalRow(const RowTerms<T>& row, T* u, T* v) {
    forEachStretch(row.count, row.anchor, [&](std::int64_t begin, std::int64_t end) {
        T wu = row.wuAt(begin), qu = row.qAt(begin);
        T wv = row.wvAt(begin), qv = qu;
        for (std::int64_t n = begin; n < end; ++n) {
            u[n] = wu / qu;
            v[n] = wv / qv;
            wu += row.a;
            qu += row.g;
            wv += row.d;
            qv += row.g;
        }
    });
}

// (4) with one denominator for both coordinates.
template <typename T>
void incrementalSharedRow(const RowTerms<T>& row, T* u, T* v) {
    forEachStretch(row.count, row.anchor, [&](std::int64_t begin, std::int64_t end) {
        T wu = row.wuAt(begin), wv = row.wvAt(begin), q = row.qAt(begin);
        for (std::int64_t n = begin; n < end; ++n) {
            u[n] = wu / q;
            v[n] = wv / q;
            wu += row.a;
            wv += row.d;
            q += row.g;
        }
    });
}

// (4) with one division for both coordinates.
template <typename T>
void incrementalReciprocalRow(const RowTerms<T>& row, T* u, T* v) {
    forEachStretch(row.count, row.anchor, [&](std::int64_t begin, std::int64_t end) {
        T wu = row.wuAt(begin), wv = row.wvAt(begin), q = row.qAt(begin);
        for (std::int64_t n = begin; n < end; ++n) {
            const T r = T(1) / q;
            u[n] = wu * r;
            v[n] = wv * r;
            wu += row.a;
            wv += row.d;
            q += row.g;
        }
    });
}

// (5) and its generalisation w_n = w_n-k + k A: stream j computes the pixels j, j + k, j + 2k ... The paper's even and
// odd pixels are k = 2. The streams are independent; they run one after the other here, and in parallel in the SIMD
// version.
template <typename T>
void streamsRow(const RowTerms<T>& row, std::int64_t k, T* u, T* v) {
    struct Terms {
        T wu, wv, q;
    };
    const Terms step{row.stepA(k), row.stepD(k), row.stepG(k)};
    std::vector<Terms> offsets;
    for (std::int64_t j = 0; j < k; ++j) offsets.push_back({row.stepA(j), row.stepD(j), row.stepG(j)});
    forEachStretch(row.count, row.anchor, [&](std::int64_t begin, std::int64_t end) {
        const Terms start{row.wuAt(begin), row.wvAt(begin), row.qAt(begin)};
        for (std::int64_t j = 0; j < std::min(k, end - begin); ++j) {
            const Terms& offset = offsets[static_cast<std::size_t>(j)];
            T wu = start.wu + offset.wu, wv = start.wv + offset.wv, q = start.q + offset.q;
            for (std::int64_t n = begin + j; n < end; n += k) {
                u[n] = wu / q;
                v[n] = wv / q;
                wu += step.wu;
                wv += step.wv;
                q += step.q;
            }
        }
    });
}

// Two streams that meet in the middle: (4) from the left, and w_n-1 = w_n - A from the right.
template <typename T>
void opposedRow(const RowTerms<T>& row, T* u, T* v) {
    const std::int64_t half = row.count / 2;
    forEachStretch(half, row.anchor, [&](std::int64_t begin, std::int64_t end) {
        const std::int64_t right = row.count - 1 - begin;
        T wu = row.wuAt(begin), wv = row.wvAt(begin), q = row.qAt(begin);
        T wuRight = row.wuAt(right), wvRight = row.wvAt(right), qRight = row.qAt(right);
        for (std::int64_t n = begin, m = right; n < end; ++n, --m) {
            u[n] = wu / q;
            v[n] = wv / q;
            u[m] = wuRight / qRight;
            v[m] = wvRight / qRight;
            wu += row.a;
            wv += row.d;
            q += row.g;
            wuRight -= row.a;
            wvRight -= row.d;
            qRight -= row.g;
        }
    });
    if (row.count % 2 != 0) {
        u[half] = row.uAt(half);
        v[half] = row.vAt(half);
    }
}

// One division every m pixels, u and v linear in between: 4/m mul, 2 + 3/m add, 1/m div. The last sub-span ends at the
// last pixel, so q is never evaluated beyond the row.
template <typename T>
void subspanRow(const RowTerms<T>& row, std::int64_t m, T* u, T* v) {
    const T mA = row.stepA(m), mD = row.stepD(m), mG = row.stepG(m), part = T(1) / numberOf<T>(m);
    const std::int64_t last = row.count - 1;
    T s = row.uAt(0), t = row.vAt(0);
    const auto line = [&](std::int64_t n, std::int64_t end, T ds, T dt) {
        u[n] = s;
        v[n] = t;
        for (T sn = s, tn = t; ++n < end;) u[n] = sn += ds, v[n] = tn += dt;
    };
    std::int64_t n = 0;
    forEachStretch(last, row.anchor, [&](std::int64_t begin, std::int64_t end) {
        T wu = row.wuAt(begin), wv = row.wvAt(begin), q = row.qAt(begin);
        for (; n + m <= end; n += m) {
            wu += mA;
            wv += mD;
            q += mG;
            const T r = T(1) / q;
            const T sEnd = wu * r, tEnd = wv * r;
            line(n, n + m, (sEnd - s) * part, (tEnd - t) * part);
            s = sEnd;
            t = tEnd;
        }
    });
    if (n < last) {
        const T length = numberOf<T>(last - n);
        const T sEnd = row.uAt(last), tEnd = row.vAt(last);
        line(n, last, (sEnd - s) / length, (tEnd - t) / length);
        s = sEnd;
        t = tEnd;
    }
    u[last] = s;
    v[last] = t;
}

// Evaluates the row by the given variant. streams: for Streams and RowsParallel; span: for Subspan.
template <typename T>
void variantRow(const RowTerms<T>& row, RowVariant variant, std::int64_t streams, std::int64_t span, T* u, T* v) {
    switch (variant) {
        case RowVariant::Affine:
            return affineRow(row, u, v);
        case RowVariant::Direct:
            return directRow(row, u, v);
        case RowVariant::RowConstant:
            return rowConstantRow(row, u, v);
        case RowVariant::Incremental:
            return incrementalRow(row, u, v);
        case RowVariant::IncrementalShared:
            return incrementalSharedRow(row, u, v);
        case RowVariant::IncrementalReciprocal:
            return incrementalReciprocalRow(row, u, v);
        case RowVariant::Opposed:
            return opposedRow(row, u, v);
        case RowVariant::Subspan:
            return subspanRow(row, span, u, v);
        case RowVariant::Streams:
        case RowVariant::RowsParallel:
            return streamsRow(row, streams, u, v);
    }
}

}  // namespace relief
