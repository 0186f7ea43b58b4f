#include "measuring/diagnose/error_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "measuring/diagnose/chords.h"

namespace relief {

Color errorColor(double texels) {
    if (std::isinf(texels)) return {1, 0, 1};
    if (!(texels > kRightTexels)) return Color(0.05F);
    constexpr double kMost = 64;
    static const std::array<Color, 5> kRamp{Color(0, 0.05F, 0.6F), Color(0, 0.45F, 0.6F), Color(0.1F, 0.6F, 0.1F),
                                            Color(0.9F, 0.75F, 0), Color(0.8F, 0.02F, 0.02F)};
    const double share = std::log(texels / kRightTexels) / std::log(kMost / kRightTexels);
    const double at = std::min(share, 1.0) * static_cast<double>(kRamp.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), kRamp.size() - 2);
    const auto rest = static_cast<float>(at - static_cast<double>(below));
    return kRamp[below] * (1 - rest) + kRamp[below + 1] * rest;
}

ColorImage errorPicture(int width, int height, const std::vector<PixelChoice>& pixels,
                        const std::vector<float>& errors) {
    ColorImage picture(width, height, Color(0));
    for (std::size_t r = 0; r < errors.size(); ++r) picture(pixels[r].x, pixels[r].y) = errorColor(errors[r]);
    return picture;
}

PixelChoice entryTexel(const HeightField& field, const ViewRay& ray) {
    const auto place = [&](double at, int size) {
        return addressIndex(static_cast<std::int64_t>(std::floor(std::fmod(at, size))), size, field.address());
    };
    return {place(ray.s0, field.width()), place(ray.t0, field.height())};
}

ColorImage errorPicture(const HeightField& field, const RayBlock& rays, const std::vector<float>& errors) {
    ColorImage picture(field.width(), field.height());
    FloatImage largest(field.width(), field.height(), -1);
    for (std::size_t r = 0; r < errors.size(); ++r) {
        const PixelChoice at = entryTexel(field, rays[r]);
        float& most = largest(at.x, at.y);
        most = std::max(most, errors[r]);
    }
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i) {
            picture(i, j) = largest(i, j) < 0 ? Color(0.15F * field.texel(i, j)) : errorColor(largest(i, j));
        }
    }
    return picture;
}

}  // namespace relief
