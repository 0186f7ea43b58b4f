#include "measuring/compare/picture_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "measuring/compare/flip.h"
#include "relief/files.h"

namespace relief {

namespace {

double encoded(float linear) {
    return static_cast<double>(srgbFromLinear(std::clamp(linear, 0.0F, 1.0F)));
}

}  // namespace

PictureError pictureError(const ColorImage& reference, const ColorImage& test, double pixelsPerDegree,
                          FloatImage& flipMap, Work& work) {
    assert(reference.width() == test.width() && reference.height() == test.height() && !reference.empty());
    PictureError error;
    double squares = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double difference = encoded(reference.pixels()[i][c]) - encoded(test.pixels()[i][c]);
            squares += difference * difference;
        }
    }
    error.rmse = std::sqrt(squares / (3.0 * static_cast<double>(reference.size())));
    error.psnr = -20 * std::log10(error.rmse);
    flipMap = flipErrors(reference, test, pixelsPerDegree, work);
    double sum = 0;
    for (const float value : flipMap.pixels()) sum += static_cast<double>(value);
    error.flip = sum / static_cast<double>(flipMap.size());
    return error;
}

}  // namespace relief
