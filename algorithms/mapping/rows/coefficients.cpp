#include "mapping/rows/coefficients.h"

#include "mapping/rows/derivatives.h"

namespace relief {

PixelCoefficients pixelCoefficients(const Homography& map, double x, double y) {
    PixelCoefficients pixel;
    pixel.map = map;
    pixel.x = x;
    pixel.y = y;
    const TexelPoint at = map.at(x, y);
    pixel.q = at.q;
    pixel.u = at.s;
    pixel.v = at.t;
    pixel.derivatives = jacobianAt(map, x, y);
    const DerivativeTerms<double> terms = derivativeTerms<double>(map);
    pixel.m = terms.m;
    pixel.n = terms.n;
    pixel.o = terms.o;
    pixel.p = terms.p;
    pixel.ellipse = ellipseOf(pixel.derivatives);
    pixel.axes = pixel.ellipse.semiAxes();
    return pixel;
}

std::vector<NamedNumber> namedNumbers(const PixelCoefficients& pixel) {
    const Homography& f = pixel.map;
    const Jacobian& j = pixel.derivatives;
    const Ellipse& e = pixel.ellipse;
    return {{"A", f.sx},
            {"B", f.sy},
            {"C", f.s1},
            {"D", f.tx},
            {"E", f.ty},
            {"F", f.t1},
            {"G", f.qx},
            {"H", f.qy},
            {"I", f.q1},
            {"q", pixel.q},
            {"ux", j.ux},
            {"uy", j.uy},
            {"vx", j.vx},
            {"vy", j.vy},
            {"M", pixel.m},
            {"N", pixel.n},
            {"O", pixel.o},
            {"P", pixel.p},
            {"u", pixel.u},
            {"v", pixel.v},
            {"ellipse_A", e.a},
            {"ellipse_B", e.b},
            {"ellipse_C", e.c},
            {"ellipse_F", e.f},
            {"major", pixel.axes.major},
            {"minor", pixel.axes.minor}};
}

double squaredRadius(const Ellipse& ellipse, double du, double dv) {
    if (!(ellipse.f > 0)) return 0;
    return (ellipse.a * du * du + ellipse.b * du * dv + ellipse.c * dv * dv) / ellipse.f;
}

}  // namespace relief
