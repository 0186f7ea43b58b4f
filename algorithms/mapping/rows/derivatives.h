// Derivatives of the texture coordinates and the footprint ellipse along rows: direct, iterative, cached.
//
// Source: Romaniuk and Dudnyk, [TEX] (direct, iterative, caching of repeated terms). Re-derived, as some of its
// formulas are missing. With the nine coefficients A to I and q = G x + H y + I,
//
//     u_x = a / q^2   a = M y + (A I - C G)   M = A H - B G       v_x = b / q^2   b = N y + (D I - F G)   N = D H - E G
//     u_y = c / q^2   c = O x + (B I - C H)   O = -M              v_y = d / q^2   d = P x + (E I - F H)   P = -N
//
// a and b are constant along a row, c and d along a column, and a d - b c = det q. So the ellipse of footprint.h,
// times q^4,
//
//     A' = b^2 + d^2   B' = -2 (a b + c d)   C' = a^2 + c^2   F' = det^2 / q^2       A' U^2 + B' U V + C' V^2 = F' R^2
//
// is a sum of terms of the row and terms of the column, which can be cached once per polygon.
// Note that F' is not A' C' - B'^2 / 4 (that is F' q^4), and that the half extents are R sqrt(C') / q^2 and
// R sqrt(A') / q^2.
//
//     per pixel (verified with a counting scalar)   mul add div     [TEX] counts, derivatives alone
//     direct: four derivatives                       7   6   4      10 mul, 10 add, 1 sub, 4 div
//     iterative: q += G, c += O, d += P              1   3   4      2 mul, 6 add, 4 div
//     direct, to A, B, C, F                         17  10   4
//     iterative, to A, B, C, F                      11   7   4
//     cached, to A', B', C', F'                      1   4   1
//     cached, to r^2 = (A'' U^2 + B'' U V + C'' V^2) 4   4   0      1 / det^2 in the caches
//
// Frames and units: pixels and texels as in homography.h and footprint.h. Templates over the scalar.
//
// Errors: the map's terms are computed in the wide type. Direct and cached results have the error of a few roundings of
// T, times t / q with t = |G x| + |H y| + |I| (digits that cancel in q). Iterative rows drift and restart as described
// in rows.h.
//
// Precondition: q is positive. Near the horizon results may be infinite; apply clampedEllipse. Nothing is divided by
// det: a map with det = 0 has r^2 = 0.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

#include "mapping/clipping.h"
#include "mapping/footprint.h"
#include "mapping/rows/row_kernels.h"
#include "mapping/rows/row_terms.h"

namespace relief {

// Constants of a polygon: M, N, O, P, the constant terms of a, b, c, d, and the denominator's coefficients.
template <typename T>
struct DerivativeTerms {
    T m, n, o, p;
    T a1, b1, c1, d1;  // A I - C G, D I - F G, B I - C H, E I - F H
    T g, h, i;
    T det;

    T a(T y) const { return m * y + a1; }
    T b(T y) const { return n * y + b1; }
    T c(T x) const { return o * x + c1; }
    T d(T x) const { return p * x + d1; }
    T q(T x, T y) const { return g * x + h * y + i; }
};

// make: converts double to T.
template <typename T, typename Make>
DerivativeTerms<T> derivativeTerms(const Homography& f, const Make& make) {
    const auto minor = [&](double k, double l, double r, double s) { return make(k * l - r * s); };
    DerivativeTerms<T> terms;
    terms.m = minor(f.sx, f.qy, f.sy, f.qx);
    terms.n = minor(f.tx, f.qy, f.ty, f.qx);
    terms.o = minor(f.sy, f.qx, f.sx, f.qy);
    terms.p = minor(f.ty, f.qx, f.tx, f.qy);
    terms.a1 = minor(f.sx, f.q1, f.s1, f.qx);
    terms.b1 = minor(f.tx, f.q1, f.t1, f.qx);
    terms.c1 = minor(f.sy, f.q1, f.s1, f.qy);
    terms.d1 = minor(f.ty, f.q1, f.t1, f.qy);
    terms.g = make(f.qx), terms.h = make(f.qy), terms.i = make(f.q1);
    terms.det = make(f.determinant());
    return terms;
}
template <typename T>
DerivativeTerms<T> derivativeTerms(const Homography& map) {
    return derivativeTerms<T>(map, [](double value) { return static_cast<T>(value); });
}

// Coordinate of the centre of a pixel's column or row.
template <typename T>
T centreOf(std::int64_t pixel) {
    return static_cast<T>(static_cast<double>(pixel) + 0.5);
}

// Output arrays for a row of ellipses: A, B, C, F (or A', B', C', F') of pixel n.
template <typename T>
struct EllipseRow {
    T* a;
    T* b;
    T* c;
    T* f;
    void put(std::int64_t n, const EllipseOf<T>& e) const { a[n] = e.a, b[n] = e.b, c[n] = e.c, f[n] = e.f; }
    EllipseOf<T> at(std::int64_t n) const { return {a[n], b[n], c[n], f[n]}; }
};

// The four derivatives at (x, y), with every term computed anew.
template <typename T>
JacobianOf<T> directDerivatives(const DerivativeTerms<T>& terms, T x, T y) {
    const T q = terms.q(x, y);
    const T square = q * q;
    return {terms.a(y) / square, terms.b(y) / square, terms.c(x) / square, terms.d(x) / square};
}

template <typename T>
void directEllipses(const DerivativeTerms<T>& terms, std::int64_t first, T y, std::int64_t count, EllipseRow<T> to) {
    for (std::int64_t n = 0; n < count; ++n) to.put(n, ellipseOf(directDerivatives(terms, centreOf<T>(first + n), y)));
}

// Calls visit(n, derivatives) along a row. a and b are computed once; c, d and q advance by forward differences and are
// recomputed every `anchor` pixels (0: never).
template <typename T, typename Visit>
void iterativeDerivatives(const DerivativeTerms<T>& terms, std::int64_t first, T y, std::int64_t count,
                          std::int64_t anchor, const Visit& visit) {
    const T a = terms.a(y);
    const T b = terms.b(y);
    forEachStretch(count, anchor, [&](std::int64_t begin, std::int64_t end) {
        const T x = centreOf<T>(first + begin);
        T c = terms.c(x), d = terms.d(x), q = terms.q(x, y);
        for (std::int64_t n = begin; n < end; ++n) {
            const T square = q * q;
            visit(n, JacobianOf<T>{a / square, b / square, c / square, d / square});
            q += terms.g;
            c += terms.o;
            d += terms.p;
        }
    });
}

template <typename T>
void iterativeEllipses(const DerivativeTerms<T>& terms, std::int64_t first, T y, std::int64_t count,
                       std::int64_t anchor, EllipseRow<T> to) {
    iterativeDerivatives(terms, first, y, count, anchor,
                         [&](std::int64_t n, const JacobianOf<T>& j) { to.put(n, ellipseOf(j)); });
}

// The ellipse times q^4, as A', B', C', F'.
template <typename T>
struct ScaledEllipse {
    T a, b, c, f;
    T square;  // q^2

    EllipseOf<T> unscaled() const {
        const T fourth = square * square;
        return {a / fourth, b / fourth, c / fourth, f / fourth};
    }
    HalfExtents<T> halfExtents(T radius) const {
        using std::sqrt;
        return {radius * sqrt(c) / square, radius * sqrt(a) / square};
    }
};

// Three coefficients that give r^2 of a texel, in pixels squared.
template <typename T>
struct RadiusForm {
    T a, b, c;
    T at(T du, T dv) const { return a * (du * du) + b * (du * dv) + c * (dv * dv); }
};

// Caches a^2, -2 a b, b^2 of the rows and c^2, -2 c d, d^2 (and the two parts of q) of the columns of a polygon's
// pixels. Memory: four scalars per row and per column. With `folded`, all are divided by det^2 once, as radiusForm()
// requires.
template <typename T>
class EllipseCaches {
  public:
    EllipseCaches(const DerivativeTerms<T>& terms, PixelSpan columns, PixelSpan rows, bool folded = false)
        : columns_(columns), rows_(rows), folded_(folded), det2_(terms.det * terms.det) {
        const T factor = !folded ? T(1) : det2_ > T(0) ? T(1) / det2_ : T(0);
        for (std::int64_t y = rows.begin; y < rows.end; ++y) {
            const T at = centreOf<T>(y);
            row_.push_back(entry(terms.a(at), terms.b(at), terms.h * at + terms.i, factor));
        }
        const auto size = static_cast<std::size_t>(columns.size());
        for (auto* column : {&aa_, &ab_, &bb_, &q_}) column->reserve(size);
        for (std::int64_t x = columns.begin; x < columns.end; ++x) {
            const T at = centreOf<T>(x);
            const Entry e = entry(terms.c(at), terms.d(at), terms.g * at, factor);
            aa_.push_back(e.aa), ab_.push_back(e.ab), bb_.push_back(e.bb), q_.push_back(e.q);
        }
    }

    // The scaled ellipse at pixel (x, y) of the polygon. Requires an unfolded cache.
    ScaledEllipse<T> at(std::int64_t x, std::int64_t y) const {
        assert(!folded_);
        return scaled(rowAt(y), static_cast<std::size_t>(x - columns_.begin));
    }
    // Requires a folded cache.
    RadiusForm<T> radiusForm(std::int64_t x, std::int64_t y) const {
        assert(folded_);
        const Entry& row = rowAt(y);
        const auto i = static_cast<std::size_t>(x - columns_.begin);
        const T q = row.q + q_[i];
        const T square = q * q;
        return {(row.bb + bb_[i]) * square, (row.ab + ab_[i]) * square, (row.aa + aa_[i]) * square};
    }
    // A', B', C', F' of `count` pixels from (first, y) on. Requires an unfolded cache.
    void ellipses(std::int64_t first, std::int64_t y, std::int64_t count, EllipseRow<T> to) const {
        assert(!folded_);
        const Entry row = rowAt(y);
        const auto offset = static_cast<std::size_t>(first - columns_.begin);
        for (std::int64_t n = 0; n < count; ++n) {
            const ScaledEllipse<T> e = scaled(row, offset + static_cast<std::size_t>(n));
            to.put(n, {e.a, e.b, e.c, e.f});
        }
    }

  private:
    struct Entry {
        T aa, ab, bb, q;
    };
    static Entry entry(T a, T b, T q, T factor) {
        return {a * a * factor, T(-2) * (a * b) * factor, b * b * factor, q};
    }
    const Entry& rowAt(std::int64_t y) const { return row_[static_cast<std::size_t>(y - rows_.begin)]; }
    ScaledEllipse<T> scaled(const Entry& row, std::size_t i) const {
        const T q = row.q + q_[i];
        const T square = q * q;
        return {row.bb + bb_[i], row.ab + ab_[i], row.aa + aa_[i], det2_ / square, square};
    }

    PixelSpan columns_, rows_;
    bool folded_;
    T det2_;
    std::vector<Entry> row_;
    std::vector<T> aa_, ab_, bb_, q_;  // of the columns, in separate arrays so that rows vectorise
};

}  // namespace relief
