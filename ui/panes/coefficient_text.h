// The mapping coefficients of a pixel as text, named as in the papers, with four significant digits.
#pragma once

#include <QStringList>

#include "mapping/rows/coefficients.h"

namespace reliefui {

// One line each: A to I; q; the derivatives; M, N, O, P; the ellipse.
QStringList coefficientLines(const relief::PixelCoefficients& pixel);

}  // namespace reliefui
