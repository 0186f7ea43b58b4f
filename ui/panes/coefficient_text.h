// The numbers behind a pixel in words of a read-out: as the papers call them, four figures each.
#pragma once

#include <QStringList>

#include "mapping/rows/coefficients.h"

namespace reliefui {

// A to I; q; the derivatives; M, N, O, P; the ellipse: a line each.
QStringList coefficientLines(const relief::PixelCoefficients& pixel);

}  // namespace reliefui
