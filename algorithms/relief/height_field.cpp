#include "relief/height_field.h"

#include <cmath>

#include "images/tiled_heights.h"
#include "relief/errors.h"

namespace relief {

namespace {

// Integer and fractional part of a coordinate. It is reduced first, so that distant points keep their precision.
struct Split {
    std::int64_t index;
    double rest;
};

Split split(double x, int size, Address address) {
    if (address == Address::Repeat) {
        // Within a period fmod() would return x itself.
        if (!(std::abs(x) < size)) x = std::fmod(x, size);
    } else {
        x = std::clamp(x, -1.0, size + 1.0);
    }
    const double whole = std::floor(x);
    return {static_cast<std::int64_t>(whole), x - whole};
}

// The heights of the four texels around a point of the bilinear surface.
struct Corners {
    double h00, h10, h01, h11;
};

Corners cornersAt(const HeightField& field, std::int64_t i, std::int64_t j) {
    if (field.tiles() != nullptr)
        return {field.texel(i, j), field.texel(i + 1, j), field.texel(i, j + 1), field.texel(i + 1, j + 1)};
    const FloatImage& heights = field.heights();
    if (i >= 0 && j >= 0 && i + 1 < heights.width() && j + 1 < heights.height()) {
        const float* at = &heights(static_cast<int>(i), static_cast<int>(j));
        return {at[0], at[1], at[heights.width()], at[heights.width() + 1]};
    }
    return {field.texel(i, j), field.texel(i + 1, j), field.texel(i, j + 1), field.texel(i + 1, j + 1)};
}

}  // namespace

HeightField::HeightField(std::shared_ptr<const TiledHeights> tiles, Surface surface, Address address,
                         double reliefDepth)
    : tiles_(std::move(tiles)),
      width_(tiles_->width()),
      height_(tiles_->height()),
      surface_(surface),
      address_(address),
      reliefDepth_(reliefDepth) {}

void HeightField::refuseTiles() const {
    throw InputError(tiles_->path(), Message(MessageId::TiledNeedsWhole));
}

float HeightField::tileTexel(int x, int y) const {
    return tiles_->height(x, y);
}

double HeightField::at(double s, double t) const {
    if (surface_ == Surface::Columns) {
        return texel(split(s, width(), address_).index, split(t, height(), address_).index);
    }
    const Split x = split(s - 0.5, width(), address_);
    const Split y = split(t - 0.5, height(), address_);
    const auto [h00, h10, h01, h11] = cornersAt(*this, x.index, y.index);
    const double top = (1 - x.rest) * h00 + x.rest * h10;
    const double bottom = (1 - x.rest) * h01 + x.rest * h11;
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
    const auto [h00, h10, h01, h11] = cornersAt(*this, x.index, y.index);
    return {(1 - y.rest) * (h10 - h00) + y.rest * (h11 - h01), (1 - x.rest) * (h01 - h00) + x.rest * (h11 - h10)};
}

}  // namespace relief
