#include "filtering/bilinear_texels.h"

#include <cmath>

namespace relief {

double unwrappedCentre(const LevelAxis& axis, int i, double x) {
    const double centre = axis.centre(i);
    if (axis.address != Address::Repeat) return centre;
    return centre + std::round((x - centre) / axis.extent) * axis.extent;
}

void addBilinearTexels(std::vector<FootprintTexel>& texels, const SampledTexture& texture, glm::dvec2 place, int level,
                       int base, const Color& weight) {
    const LevelAxis across = texture.across(level);
    const LevelAxis down = texture.down(level);
    const BilinearSupport x = across.support(place.x);
    const BilinearSupport y = down.support(place.y);
    for (const bool lower : {false, true}) {
        for (const bool right : {false, true}) {
            const float share = (right ? x.share : 1 - x.share) * (lower ? y.share : 1 - y.share);
            if (!(share > 0)) continue;
            FootprintTexel texel;
            texel.i = right ? x.second : x.first;
            texel.j = lower ? y.second : y.first;
            texel.level = level;
            texel.u = std::ldexp(unwrappedCentre(across, texel.i, place.x), level - base);
            texel.v = std::ldexp(unwrappedCentre(down, texel.j, place.y), level - base);
            texel.weight = share * weight;
            texels.push_back(texel);
        }
    }
}

}  // namespace relief
