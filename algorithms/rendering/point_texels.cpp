#include "rendering/point_texels.h"

#include <algorithm>
#include <cmath>

#include "relief/addressing.h"

namespace relief {

void addPointTexels(std::vector<FootprintTexel>& texels, const FrameRequest& request, const SampledTexture& texture,
                    const std::string& filter, int level, const Jacobian& j, glm::dvec2 place, const Color& weight) {
    const auto bilinear = [&](int l, double part) {
        addBilinearTexels(texels, texture, {std::ldexp(place.x, -l), std::ldexp(place.y, -l)}, l, level,
                          static_cast<float>(part) * weight);
    };
    // Without a colour picture, the colour is a height of the relief, sampled like its surface.
    const bool nearest = request.color ? filter == "nearest" : request.field.surface() == Surface::Columns;
    if (nearest && !findFilter(filter).footprint) {
        const auto at = [&](double x, int size) {
            return addressIndex(static_cast<std::int64_t>(std::floor(x)), size, texture.address);
        };
        texels.push_back({at(place.x, texture.width), at(place.y, texture.height), 0, std::floor(place.x) + 0.5,
                          std::floor(place.y) + 0.5, weight});
        return;
    }
    if (filter != "trilinear") return bilinear(0, 1);
    // The same choice of level as in the filter.
    const double side = std::max(std::hypot(j.ux, j.vx), std::hypot(j.uy, j.vy));
    const double share = (side > 1 ? std::log2(side) : 0) - level;
    const bool both = share > 0 && share < 1 && texture.across(level).size + texture.down(level).size > 2;
    bilinear(level, both ? 1 - share : 1);
    if (both) bilinear(level + 1, share);
}

}  // namespace relief
