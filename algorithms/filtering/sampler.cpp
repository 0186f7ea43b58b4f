#include "filtering/sampler.h"

#include <cmath>

namespace relief {

namespace {

// Integer and fractional part. Under repeat the coordinate is reduced first, so that distant points keep their
// precision.
struct Split {
    std::int64_t index;
    float rest;
};

Split split(double x, int size, Address address) {
    if (address == Address::Repeat) {
        if (x < 0 || x >= size) x = std::fmod(x, size);
    } else {
        x = std::clamp(x, -1.0, size + 1.0);
    }
    const double whole = std::floor(x);
    return {static_cast<std::int64_t>(whole), static_cast<float>(x - whole)};
}

}  // namespace

Color sampleNearest(const ColorImage& image, double s, double t, Address address) {
    const int x = addressIndex(split(s, image.width(), address).index, image.width(), address);
    const int y = addressIndex(split(t, image.height(), address).index, image.height(), address);
    return image(x, y);
}

Color sampleBilinear(const ColorImage& image, double s, double t, Address address) {
    const Split x = split(s - 0.5, image.width(), address);
    const Split y = split(t - 0.5, image.height(), address);
    const int x0 = addressIndex(x.index, image.width(), address);
    const int x1 = addressIndex(x.index + 1, image.width(), address);
    const int y0 = addressIndex(y.index, image.height(), address);
    const int y1 = addressIndex(y.index + 1, image.height(), address);
    const Color top = (1 - x.rest) * image(x0, y0) + x.rest * image(x1, y0);
    const Color bottom = (1 - x.rest) * image(x0, y1) + x.rest * image(x1, y1);
    return (1 - y.rest) * top + y.rest * bottom;
}

}  // namespace relief
