// The footprint of a pixel on the texture: its Jacobian and the ellipse into which the circle of radius 1 pixel is
// mapped.
//
// Source: Heckbert 1989 (the ellipse of a Jacobian); Romaniuk and Dudnyk, [TEX]. With U = u - u0, V = v - v0:
//
//     A U^2 + B U V + C V^2 <= F R^2        the circle of radius R pixels
//     A = v_x^2 + v_y^2   B = -2 (u_x v_x + u_y v_y)   C = u_x^2 + u_y^2   F = (u_x v_y - u_y v_x)^2 = A C - B^2 / 4
//
// Frames and units: u, v are s, t of the code, in texels of level 0; x right, y down in pixels; U to the right and V
// down from the texture coordinate of the pixel's centre. R in pixels. The templates' scalar is float, double or a
// counting scalar.
//
// Ranges: derivatives up to 1e75 (double) and 1e9 (float) cause neither overflow nor NaN. A footprint may vanish
// (edge-on polygon: F = 0) or be infinite (horizon). Apply clampedEllipse first: it bounds the minor semi-axis from
// below and the major one from above, and every function here is finite for its result. Unclamped, a vanishing
// footprint has empty or one-point spans, never NaN.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "homography.h"

namespace relief {

// ux, vx: change of u and v in texels per pixel to the right; uy, vy: per pixel down.
template <typename T>
struct JacobianOf {
    T ux{1};
    T vx{0};
    T uy{0};
    T vy{1};

    // Signed area of a pixel in texels; negative if the plane is seen from behind.
    T determinant() const { return ux * vy - uy * vx; }
};
using Jacobian = JacobianOf<double>;

// Real interval [begin, end] inside the ellipse; empty if begin > end.
template <typename T>
struct Span {
    T begin{1};
    T end{-1};
    bool empty() const { return !(begin <= end); }
};

// Half-open [begin, end) of texel columns.
struct TexelSpan {
    std::int64_t begin = 0;
    std::int64_t end = 0;
    bool empty() const { return begin >= end; }
};

// Semi-axes in texels; (majorU, majorV) is the unit vector along the major axis.
template <typename T>
struct SemiAxes {
    T major{1};
    T minor{1};
    T majorU{1};
    T majorV{0};
};

template <typename T>
struct HalfExtents {
    T u{1};
    T v{1};
};

// A, B, C, F of the circle of radius 1 pixel. F = A C - B^2 / 4 must hold, so a scaled ellipse (derivatives.h) has to
// be unscaled first.
template <typename T>
struct EllipseOf {
    T a{1};
    T b{0};
    T c{1};
    T f{1};

    // The quadratic form at offset (du, dv). sqrt(form / F) is the texel's distance from the pixel's centre, in pixels.
    T form(T du, T dv) const { return a * (du * du) + b * (du * dv) + c * (dv * dv); }
    bool contains(T du, T dv, T radius) const { return form(du, dv) <= f * (radius * radius); }

    // Half extents of the bounding box: |U| <= R sqrt(C), |V| <= R sqrt(A).
    HalfExtents<T> halfExtents(T radius) const {
        using std::sqrt;
        return {radius * sqrt(c), radius * sqrt(a)};
    }

    // The interval of U inside the ellipse at this V: (-B V / 2 +- sqrt(F (R^2 A - V^2))) / A. Where A = 0 (the
    // footprint has no height) it is the whole width at V = 0 and empty elsewhere.
    Span<T> rowSpan(T dv, T radius) const {
        using std::sqrt;
        const T inside = radius * radius * a - dv * dv;
        if (inside < T(0)) return {};
        if (!(a > T(0))) return {-(radius * sqrt(c)), radius * sqrt(c)};
        const T half = sqrt(f) * sqrt(inside) / a;
        const T middle = T(-0.5) * b * dv / a;
        return {middle - half, middle + half};
    }

    // Exactly those texels i of a row for which contains(i + 1/2 - u0, dv, radius) holds: the ends of rowSpan are
    // corrected by evaluating the form. The ellipse must be clamped, and no wider than 2^31 texels.
    TexelSpan texelSpan(T u0, T dv, T radius) const {
        using std::ceil;
        using std::floor;
        using std::sqrt;
        const T middle = u0 - T(0.5) * b * dv / a;
        const T inside = radius * radius * a - dv * dv;
        const T half = inside > T(0) ? sqrt(f) * sqrt(inside) / a : T(0);
        auto begin = static_cast<std::int64_t>(ceil(middle - half - T(0.5)));
        auto end = static_cast<std::int64_t>(floor(middle + half - T(0.5))) + 1;
        const auto in = [&](std::int64_t i) {
            return contains(static_cast<T>(static_cast<double>(i) + 0.5) - u0, dv, radius);
        };
        // Rounding may leave the ends one texel off; the form is convex, so checking the ends suffices.
        while (begin < end && !in(begin)) ++begin;
        while (begin < end && !in(end - 1)) --end;
        while (in(begin - 1)) --begin;
        while (in(end)) ++end;
        if (begin > end) end = begin;
        return {begin, end};
    }

    // major^2 = (A + C + hypot(A - C, B)) / 2, minor = sqrt(F) / major. Neither formula cancels.
    SemiAxes<T> semiAxes() const {
        using std::hypot;
        using std::sqrt;
        SemiAxes<T> axes;
        const T square = T(0.5) * ((a + c) + hypot(a - c, b));
        axes.major = sqrt(square);
        axes.minor = axes.major > T(0) ? sqrt(f) / axes.major : T(0);
        // The eigenvector of [[C, -B/2], [-B/2, A]] for the larger eigenvalue, from the row that does not cancel.
        const T along = c >= a ? square - a : T(-0.5) * b;
        const T across = c >= a ? T(-0.5) * b : square - c;
        const T length = hypot(along, across);
        if (length > T(0)) {
            axes.majorU = along / length;
            axes.majorV = across / length;
        }
        return axes;
    }
};
using Ellipse = EllipseOf<double>;

template <typename T>
EllipseOf<T> ellipseOf(const JacobianOf<T>& j) {
    const T det = j.determinant();
    return {j.vx * j.vx + j.vy * j.vy, T(-2) * (j.ux * j.vx + j.uy * j.vy), j.ux * j.ux + j.uy * j.uy, det * det};
}

// Returns the same ellipse with its minor semi-axis raised to at least smallestMinor and its major one reduced to at
// most largestMajor (texels, 0 < smallestMinor <= largestMajor). Avoids trigonometry: M + c (lambda I - M) moves one
// eigenvalue of M = J J^T and keeps the axes' directions. An ellipse that is not finite becomes the circle of radius
// largestMajor.
template <typename T>
EllipseOf<T> clampedEllipse(const EllipseOf<T>& ellipse, T smallestMinor, T largestMajor) {
    using std::hypot;
    const T low = smallestMinor * smallestMinor;
    const T high = largestMajor * largestMajor;
    T uu = ellipse.c;
    T vv = ellipse.a;
    T uv = T(-0.5) * ellipse.b;
    T lambdaMax = T(0.5) * ((uu + vv) + hypot(uu - vv, T(2) * uv));
    if (!(lambdaMax <= std::numeric_limits<T>::max()) || !(ellipse.f <= std::numeric_limits<T>::max())) {
        return {high, T(0), high, high * high};
    }
    if (!(lambdaMax > low)) return {low, T(0), low, low * low};
    T lambdaMin = std::min(ellipse.f / lambdaMax, lambdaMax);
    if (lambdaMin >= high) return {high, T(0), high, high * high};
    // Replaces M by keep M + part lambda I with keep + part = 1, each computed without cancellation.
    const auto move = [&](T keep, T part, T lambda) {
        uu = keep * uu + part * lambda;
        vv = keep * vv + part * lambda;
        uv = keep * uv;
    };
    if (lambdaMax > high) {
        const T width = lambdaMax - lambdaMin;
        move((high - lambdaMin) / width, (lambdaMax - high) / width, lambdaMin);
        lambdaMax = high;
    }
    if (lambdaMin < low) {
        const T width = lambdaMax - lambdaMin;
        move((lambdaMax - low) / width, (low - lambdaMin) / width, lambdaMax);
        lambdaMin = low;
    }
    return {vv, T(-2) * uv, uu, lambdaMax * lambdaMin};
}

// J^-1, which takes an offset in texels to one in pixels. It is linear, so it advances by constant steps along a row of
// texels.
template <typename T>
struct PixelFromTexelOf {
    T xu{1};  // pixels to the right per texel of U
    T xv{0};
    T yu{0};  // pixels down per texel of U
    T yv{1};

    T dx(T du, T dv) const { return xu * du + xv * dv; }
    T dy(T du, T dv) const { return yu * du + yv * dv; }
};
using PixelFromTexel = PixelFromTexelOf<double>;

// (dx, dy) = 1 / det [[v_y, -u_y], [-v_x, u_x]] (U, V). All zero (each texel at the pixel's centre) if the Jacobian
// vanishes, overflows, or maps a texel to more than 1 / epsilon^2 pixels.
template <typename T>
PixelFromTexelOf<T> pixelFromTexel(const JacobianOf<T>& j) {
    using std::abs;
    constexpr T most = T(1) / (std::numeric_limits<T>::epsilon() * std::numeric_limits<T>::epsilon());
    const T inverse = T(1) / j.determinant();
    const PixelFromTexelOf<T> out{j.vy * inverse, -(j.uy * inverse), -(j.vx * inverse), j.ux * inverse};
    const bool usable = abs(out.xu) <= most && abs(out.xv) <= most && abs(out.yu) <= most && abs(out.yv) <= most;
    return usable ? out : PixelFromTexelOf<T>{T(0), T(0), T(0), T(0)};
}

// The direct form of [TEX] at pixel coordinates (x, y) with q != 0, from the minors of the nine coefficients: u_x = a /
// q^2, v_x = b / q^2, u_y = c / q^2, v_y = d / q^2. Near the horizon the result may be infinite.
inline Jacobian jacobianAt(const Homography& map, double x, double y) {
    const double q = map.denominator(x, y);
    const double square = q * q;
    const double a = (map.sx * map.qy - map.sy * map.qx) * y + (map.sx * map.q1 - map.s1 * map.qx);
    const double b = (map.tx * map.qy - map.ty * map.qx) * y + (map.tx * map.q1 - map.t1 * map.qx);
    const double c = (map.sy * map.qx - map.sx * map.qy) * x + (map.sy * map.q1 - map.s1 * map.qy);
    const double d = (map.ty * map.qx - map.tx * map.qy) * x + (map.ty * map.q1 - map.t1 * map.qy);
    return {a / square, b / square, c / square, d / square};
}

}  // namespace relief
