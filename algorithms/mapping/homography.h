// Perspective-correct texture coordinates: the nine coefficients of Heckbert's rational map from a pixel to a texel.
//
// Source: Heckbert 1989 (Fundamentals of Texture Mapping and Image Warping, the square-to-quadrilateral closed form);
// Romaniuk and Dudnyk, [PERSP] and [TEX].
//
//     s = (A x + B y + C) / q      t = (D x + E y + F) / q      q = G x + H y + I
//
// Frames and units: x to the right and y down the screen, in pixels, pixel (i, j) centred at (i + 1/2, j + 1/2); s and
// t in texels of level 0 (the papers' u and v with the picture's W folded into A, B, C and H into D, E, F), texel
// (i, j) centred at (i + 1/2, j + 1/2), t growing with the picture's row.
//
// Sign and scale: the nine are homogeneous. Every function here returns them with q > 0 in front of the eye (q is then
// inversely proportional to the depth, 0 on the horizon) and with the largest of 1024 |G|, 1024 |H|, |I| in [1, 2), by
// a power of two, which changes no evaluated bit. So q stays below 260 on screens of up to 65,536 pixels a side, and
// with texel coordinates below 1e9 the numerators, the minors and the determinant all stay far from overflow in float.
//
// Errors: corners or planes that define no map throw InputError (see each function); accepted input never gives NaN.
// Clip rows that reach the horizon by clipRowToHorizon (clipping.h) before evaluating them.
#pragma once

#include <array>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace relief {

// Texture coordinates of a pixel. q is the denominator: positive in front of the eye; where it is not (on and above the
// horizon) s and t have no meaning.
struct TexelPoint {
    double s = 0.0;
    double t = 0.0;
    double q = 1.0;
};

// The nine coefficients. A name says what the coefficient multiplies; the papers' letter is given on its right.
struct Homography {
    double sx = 1.0;  // A
    double sy = 0.0;  // B
    double s1 = 0.0;  // C
    double tx = 0.0;  // D
    double ty = 1.0;  // E
    double t1 = 0.0;  // F
    double qx = 0.0;  // G
    double qy = 0.0;  // H
    double q1 = 1.0;  // I

    // The denominator q alone. It is monotone in x and in y, also in floating point.
    double denominator(double x, double y) const { return (qx * x + qy * y) + q1; }

    // Direct evaluation (the direct form of [PERSP], with one q for both). x, y: any real pixel coordinates with q !=
    // 0.
    TexelPoint at(double x, double y) const {
        const double q = denominator(x, y);
        return {((sx * x + sy * y) + s1) / q, ((tx * x + ty * y) + t1) / q, q};
    }

    // A to I in this order, converted to the kernel's scalar type (float, double, a counting scalar).
    template <typename T>
    std::array<T, 9> coefficients() const {
        return {static_cast<T>(sx), static_cast<T>(sy), static_cast<T>(s1), static_cast<T>(tx), static_cast<T>(ty),
                static_cast<T>(t1), static_cast<T>(qx), static_cast<T>(qy), static_cast<T>(q1)};
    }

    // det [A B C; D E F; G H I]: s_x t_y - s_y t_x = determinant / q^3. Positive if the front of the polygon is
    // visible. Derivatives and the footprint ellipse ([TEX]) also need the minors
    //     N = A H - B G,  A I - C G,  B I - C H    and    P = D H - E G,  D I - F G,  E I - F H
    // (two rows of the adjugate up to sign), which follow from these members.
    double determinant() const;

    // det * inverse, neither rescaled nor sign-corrected: adjugate() * (s, t, 1) = (det / q) (x, y, 1).
    Homography adjugate() const;

    // The map from texels to pixels, as a Homography whose at(s, t) returns x, y in the members s, t. Its q is positive
    // wherever this map's is, and its scale is normalised in texels. Throws InputError (MappingSingular) if the
    // determinant is zero or lost in the rounding of the coefficients. The relative error grows with the square of the
    // polygon's distance from the origin, in polygon sizes, on the screen and again in the texture; for a small,
    // distant polygon fromCorners(texture, screen) is accurate.
    Homography inverse() const;

    // The same map with the scale described above; the sign is kept. Throws InputError (MappingSingular) if a
    // coefficient is not finite or G = H = I = 0.
    Homography normalised() const;
};

// A pinhole camera. right, up, forward: orthogonal unit vectors of a right-handed frame (right x up = -forward).
// A point at camera coordinates (X, Y, Z) = (right, up, forward) . (point - eye) appears at pixel coordinates
//     x = principal.x + focal.x X / Z      y = principal.y - focal.y Y / Z      (Z > 0)
struct PinholeCamera {
    glm::dvec3 eye{0.0, 0.0, 0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0};
    glm::dvec2 focal{1.0, 1.0};      // pixels, both positive
    glm::dvec2 principal{0.0, 0.0};  // pixels

    // Returns (x Z, y Z, Z), linear in the point; the pixel is (x, y) where Z > 0.
    glm::dvec3 project(const glm::dvec3& point) const { return projectDirection(point - eye); }
    // The same for a direction (a point at infinity).
    glm::dvec3 projectDirection(const glm::dvec3& direction) const;
    // Direction of the view ray through pixel coordinates (x, y), with a run of 1 along forward; not normalised.
    glm::dvec3 rayThrough(double x, double y) const;
};

// A textured plane: texel coordinates (s, t) lie at origin + s perS + t perT, for any real s and t. On its front, to
// which frontNormal() points, s runs to the right and t down.
struct TexturedPlane {
    glm::dvec3 origin{0.0, 0.0, 0.0};  // where s = t = 0
    glm::dvec3 perS{1.0, 0.0, 0.0};    // world vector of one texel in s
    glm::dvec3 perT{0.0, -1.0, 0.0};   // world vector of one texel in t

    glm::dvec3 at(double s, double t) const { return origin + s * perS + t * perT; }
    glm::dvec3 frontNormal() const;  // perT x perS, not normalised
};

// Returns the map that takes the four screen corners (pixels) to the four texture corners (texels), both in the same
// order around. Either direction is valid; if it is mirrored, the determinant is negative (a back face). Both
// quadrilaterals must be strictly convex, as a projective image of a convex quadrilateral in front of the eye always
// is. Throws InputError: MappingCornerNotFinite; MappingCornersOnLine (three corners collinear or two equal, within the
// rounding of their coordinates); MappingNotConvex (self-intersecting or concave).
Homography fromCorners(std::span<const glm::dvec2, 4> screen, std::span<const glm::dvec2, 4> texture);

// Returns the map of a whole plane seen by a camera. q = |det| / depth up to scale, so it is positive in front of the
// eye. Agrees with fromCorners of the same plane's corners (tests: 1e-12 of the texture's size). Throws InputError:
// MappingCameraInvalid (not finite, focal lengths not positive, directions coplanar); MappingPlaneInvalid (not finite,
// perS and perT parallel or zero); MappingEdgeOn (the plane passes through the eye).
Homography fromCameraAndPlane(const PinholeCamera& camera, const TexturedPlane& plane);

}  // namespace relief
