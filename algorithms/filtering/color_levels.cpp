#include "filtering/color_levels.h"

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "base/parallel.h"
#include "images/pyramid.h"

namespace relief {

namespace {

// Number of level-0 texels below texel i of level l along one axis of `size` texels.
std::int64_t covered(std::int64_t i, int l, std::int64_t size) {
    return std::min(size, (i + 1) << l) - (i << l);
}

// The mean of up to four texels of the level below, each weighted by the number of level-0 texels that it covers.
ColorImage meanLevel(const ColorImage& below, int l, int width0, int height0, Work& work) {
    ColorImage level((below.width() + 1) / 2, (below.height() + 1) / 2);
    const int grain = std::max(1, (1 << 13) / level.width());
    const auto row = [&](int y) {
        for (int x = 0; x < level.width(); ++x) {
            glm::dvec3 sum(0);
            double area = 0;
            for (int j = 2 * y; j < std::min(2 * y + 2, below.height()); ++j) {
                for (int i = 2 * x; i < std::min(2 * x + 2, below.width()); ++i) {
                    const auto share = static_cast<double>(covered(i, l - 1, width0) * covered(j, l - 1, height0));
                    sum += share * glm::dvec3(below(i, j));
                    area += share;
                }
            }
            level(x, y) = Color(sum / area);
        }
    };
    parallelFor(work, level.height(), row, grain);
    return level;
}

}  // namespace

ColorLevels::ColorLevels(std::shared_ptr<const ColorImage> picture, Work& work) : picture_(std::move(picture)) {
    assert(picture_ && !picture_->empty());
    const int count = Pyramid::levelCount(width(), height());
    above_.reserve(static_cast<std::size_t>(count));
    for (int l = 1; l < count; ++l) above_.push_back(meanLevel(level(l - 1), l, width(), height(), work));
}

Color ColorLevels::bilinear(int l, glm::dvec2 place, Address address) const {
    const double scale = std::ldexp(1.0, -l);
    const BilinearSupport x = across(l, address).support(place.x * scale);
    const BilinearSupport y = down(l, address).support(place.y * scale);
    const ColorImage& image = level(l);
    const Color upper = (1 - x.share) * image(x.first, y.first) + x.share * image(x.second, y.first);
    const Color lower = (1 - x.share) * image(x.first, y.second) + x.share * image(x.second, y.second);
    return (1 - y.share) * upper + y.share * lower;
}

Color ColorLevels::trilinear(double level, glm::dvec2 place, Address address) const {
    if (!(level > 0)) return bilinear(0, place, address);
    if (level >= top()) return bilinear(top(), place, address);
    const int below = static_cast<int>(level);
    const auto share = static_cast<float>(level - below);
    return (1 - share) * bilinear(below, place, address) + share * bilinear(below + 1, place, address);
}

}  // namespace relief
