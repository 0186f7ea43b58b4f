// Input of the kernels in row_kernels.h: a row of pixels under the nine coefficients, in the scalar type T.
//
// Source: [PERSP]. At pixel n of the row (n = 0 is the first), with the papers' u_t, u_b, v_t,
//
//     w_u = u_t + A n     w_v = v_t + D n     q = u_b + G n     u = w_u / q     v = w_v / q
//
// Frames and units: pixels (centres at + 1/2) and texels, as in homography.h. The per-row terms and the restarts are
// computed in the wider type (double for float). So an anchored row restarts from a correctly rounded value, without
// the loss of digits in A x + B y + C.
#pragma once

#include <array>
#include <cstdint>

#include "mapping/homography.h"

namespace relief {

template <typename T>
struct WideOf {
    using type = double;
};
template <typename T>
using Wide = typename WideOf<T>::type;

// Converts a row number, an index or a count to the scalar type.
template <typename T>
T numberOf(std::int64_t n) {
    return static_cast<T>(static_cast<double>(n));
}

template <typename T>
struct RowTerms {
    T a, b, c, d, e, f, g, h, i;  // A to I
    T y;                          // centre line of the row
    std::int64_t first = 0;       // pixel column of n = 0
    std::int64_t count = 0;       // number of pixels
    std::int64_t anchor = 0;      // pixels between exact restarts; 0: never
    Wide<T> ut, vt, ub;           // numerators and denominator at n = 0
    Wide<T> wideA, wideD, wideG;

    T x(std::int64_t n) const { return static_cast<T>(static_cast<double>(first + n) + 0.5); }

    // Value at pixel n, exact up to the rounding of the wide type and one rounding to T. Incremental rows start and
    // restart here.
    T wuAt(std::int64_t n) const { return static_cast<T>(ut + wideA * numberOf<Wide<T>>(n)); }
    T wvAt(std::int64_t n) const { return static_cast<T>(vt + wideD * numberOf<Wide<T>>(n)); }
    T qAt(std::int64_t n) const { return static_cast<T>(ub + wideG * numberOf<Wide<T>>(n)); }
    T uAt(std::int64_t n) const {
        return static_cast<T>((ut + wideA * numberOf<Wide<T>>(n)) / (ub + wideG * numberOf<Wide<T>>(n)));
    }
    T vAt(std::int64_t n) const {
        return static_cast<T>((vt + wideD * numberOf<Wide<T>>(n)) / (ub + wideG * numberOf<Wide<T>>(n)));
    }
    // The step multiplied by n.
    T stepA(std::int64_t n) const { return static_cast<T>(wideA * numberOf<Wide<T>>(n)); }
    T stepD(std::int64_t n) const { return static_cast<T>(wideD * numberOf<Wide<T>>(n)); }
    T stepG(std::int64_t n) const { return static_cast<T>(wideG * numberOf<Wide<T>>(n)); }
};

// The terms of the pixels [first, first + count) on the line y. make(double) returns a T and makeWide(double) a
// Wide<T>; a counting scalar receives its counter there. Cost: 6 mul, 6 add per row.
template <typename T, typename Make, typename MakeWide>
RowTerms<T> rowTerms(const Homography& map, double y, std::int64_t first, std::int64_t count, std::int64_t anchor,
                     const Make& make, const MakeWide& makeWide) {
    RowTerms<T> row;
    row.a = make(map.sx), row.b = make(map.sy), row.c = make(map.s1);
    row.d = make(map.tx), row.e = make(map.ty), row.f = make(map.t1);
    row.g = make(map.qx), row.h = make(map.qy), row.i = make(map.q1);
    row.y = make(y);
    row.first = first, row.count = count, row.anchor = anchor;
    row.wideA = makeWide(map.sx), row.wideD = makeWide(map.tx), row.wideG = makeWide(map.qx);
    const Wide<T> wideX(static_cast<double>(first) + 0.5);
    const Wide<T> wideY(y);
    row.ut = (row.wideA * wideX + makeWide(map.sy) * wideY) + makeWide(map.s1);
    row.vt = (row.wideD * wideX + makeWide(map.ty) * wideY) + makeWide(map.t1);
    row.ub = (row.wideG * wideX + makeWide(map.qy) * wideY) + makeWide(map.q1);
    return row;
}

template <typename T>
RowTerms<T> rowTerms(const Homography& map, double y, std::int64_t first, std::int64_t count, std::int64_t anchor) {
    return rowTerms<T>(
        map, y, first, count, anchor, [](double value) { return static_cast<T>(value); },
        [](double value) { return value; });
}

}  // namespace relief
