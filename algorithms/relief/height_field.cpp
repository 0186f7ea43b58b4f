#include "relief/height_field.h"

#include <cmath>

namespace relief {

namespace {

// Whole part and rest of a coordinate, reduced first so that far-off points keep their digits.
struct Split {
    std::int64_t index;
    double rest;
};

Split split(double x, int size, Address address) {
    if (address == Address::Repeat) {
        x = std::fmod(x, size);
    } else {
        x = std::clamp(x, -1.0, size + 1.0);
    }
    const double whole = std::floor(x);
    return {static_cast<std::int64_t>(whole), x - whole};
}

}  // namespace

double HeightField::at(double s, double t) const {
    if (surface_ == Surface::Columns) {
        return texel(split(s, width(), address_).index, split(t, height(), address_).index);
    }
    const Split x = split(s - 0.5, width(), address_);
    const Split y = split(t - 0.5, height(), address_);
    const double top = (1 - x.rest) * texel(x.index, y.index) + x.rest * texel(x.index + 1, y.index);
    const double bottom = (1 - x.rest) * texel(x.index, y.index + 1) + x.rest * texel(x.index + 1, y.index + 1);
    return (1 - y.rest) * top + y.rest * bottom;
}

std::pair<double, double> HeightField::slope(double s, double t) const {
    if (surface_ == Surface::Columns) {
        const std::int64_t i = split(s, width(), address_).index;
        const std::int64_t j = split(t, height(), address_).index;
        return {(texel(i + 1, j) - texel(i - 1, j)) / 2.0, (texel(i, j + 1) - texel(i, j - 1)) / 2.0};
    }
    const Split x = split(s - 0.5, width(), address_);
    const Split y = split(t - 0.5, height(), address_);
    const double h00 = texel(x.index, y.index);
    const double h10 = texel(x.index + 1, y.index);
    const double h01 = texel(x.index, y.index + 1);
    const double h11 = texel(x.index + 1, y.index + 1);
    return {(1 - y.rest) * (h10 - h00) + y.rest * (h11 - h01), (1 - x.rest) * (h01 - h00) + x.rest * (h11 - h10)};
}

}  // namespace relief
