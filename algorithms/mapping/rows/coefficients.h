// The numbers behind one pixel, by name: the nine coefficients of its polygon, the derivatives at the pixel, and the
// footprint ellipse. [PERSP], [TEX]; frames, units and formulas as in homography.h, derivatives.h and footprint.h.
#pragma once

#include <string_view>
#include <vector>

#include "mapping/footprint.h"
#include "mapping/homography.h"

namespace relief {

struct PixelCoefficients {
    Homography map;  // A to I, from pixels to texels
    double x = 0;    // the pixel's centre
    double y = 0;
    double q = 1;             // G x + H y + I
    double u = 0;             // (A x + B y + C) / q, texels
    double v = 0;             // (D x + E y + F) / q
    Jacobian derivatives;     // u_x, u_y, v_x, v_y, texels per pixel
    double m = 0;             // A H - B G: change of u_x q^2 from row to row
    double n = 0;             // D H - E G
    double o = 0;             // B G - A H
    double p = 0;             // E G - D H
    Ellipse ellipse;          // A, B, C, F of the circle of radius 1 pixel
    SemiAxes<double> axes{};  // of the ellipse, texels
};

// Computes all of them. x, y: the pixel's centre, where q > 0.
PixelCoefficients pixelCoefficients(const Homography& map, double x, double y);

// The same with the papers' names, in the order of tables: A to I, q, ux, uy, vx, vy, M, N, O, P, u, v, the ellipse's
// ellipse_A, ellipse_B, ellipse_C, ellipse_F, major, minor.
struct NamedNumber {
    std::string_view name;
    double value;
};
std::vector<NamedNumber> namedNumbers(const PixelCoefficients& pixel);

// r^2 = (A U^2 + B U V + C V^2) / F in pixels squared, for a texel centre at (U, V) texels from the ellipse's centre. 0
// for an ellipse without area.
double squaredRadius(const Ellipse& ellipse, double du, double dv);

}  // namespace relief
