#include "painting/picture_values.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "rendering/display.h"

namespace reliefui {

std::shared_ptr<const relief::FloatImage> pictureValues(const relief::ColorImage& picture) {
    std::vector<std::uint32_t> codes(picture.size());
    relief::toSrgb32(picture.pixels(), codes);
    auto values = std::make_shared<relief::FloatImage>(picture.width(), picture.height());
    constexpr std::uint32_t kColors = 0xffffff;
    std::ranges::transform(codes, values->pixels().begin(),
                           [](std::uint32_t code) { return static_cast<float>(code & kColors); });
    return values;
}

}  // namespace reliefui
