#include "filtering/lane_levels.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"

namespace relief {

namespace {

bool holds(const ColorImage& picture, Work& work) {
    std::atomic<bool> all{true};
    const auto row = [&](int y) {
        bool good = true;
        // The comparison fails for NaN.
        for (const Color& c : picture.row(y)) {
            for (int k = 0; k < 3; ++k) good = good && c[k] >= 0 && c[k] <= 1;
        }
        if (!good) all = false;
    };
    parallelFor(work, picture.height(), row, 64);
    return all;
}

std::uint64_t packed(const Color& color) {
    std::uint64_t texel = 0;
    for (int c = 0; c < 3; ++c) {
        // A mean may exceed 1 by rounding.
        const auto value = static_cast<std::uint64_t>(std::min(color[c], 1.0F) * kLaneWhite + 0.5F);
        texel |= value << (16 * c);
    }
    return texel;
}

}  // namespace

std::shared_ptr<const LaneLevels> laneLevels(const ColorLevels& levels, Address address, Work& work) {
    if (levels.count() > kMostLaneLevels || !holds(*levels.picture(), work)) return nullptr;
    auto out = std::make_shared<LaneLevels>();
    out->count = levels.count();
    out->address = address;
    const int left = address == Address::Repeat ? 0 : kLanePad;
    std::int64_t end = 0;
    for (int l = 0; l < levels.count(); ++l) {
        const auto n = static_cast<std::size_t>(l);
        const ColorImage& image = levels.level(l);
        out->width[n] = image.width();
        out->height[n] = image.height();
        out->stride[n] = left + image.width() + kLanePad;
        out->origin[n] = static_cast<std::int32_t>(end) + left;
        out->whole[n] = levels.across(l, address).lastShare() == 1 && levels.down(l, address).lastShare() == 1 ? 1 : 0;
        end += std::int64_t{out->stride[n]} * image.height();
        if (end + kLanePad > std::numeric_limits<std::int32_t>::max()) return nullptr;
    }
    // Texels are read in pairs, and up to the length of a pad beyond a row's pad.
    out->texels.resize(static_cast<std::size_t>(end) + kLanePad + 2);
    for (int l = 0; l < levels.count(); ++l) {
        const auto n = static_cast<std::size_t>(l);
        const ColorImage& image = levels.level(l);
        const auto row = [&](int y) {
            std::uint64_t* to = out->texels.data() + out->origin[n] + std::int64_t{out->stride[n]} * y;
            for (int x = 0; x < image.width(); ++x) to[x] = packed(image(x, y));
            for (int x = image.width(); x < image.width() + kLanePad; ++x) {
                to[x] = to[addressIndex(x, image.width(), address)];
            }
            for (int x = -left; x < 0; ++x) to[x] = to[0];
        };
        parallelFor(work, image.height(), row, 16);
    }
    work.throwIfStopped();
    return out;
}

}  // namespace relief
