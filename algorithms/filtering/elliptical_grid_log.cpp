#include <algorithm>
#include <cmath>

#include "filtering/grid_tile.h"

namespace relief {

// The texels of the one pixel there is, as parts of its points' shares.
void GridKernel::logPoints(const FilterQuery& query, const Tile& tile, FootprintLog& log) const {
    const std::size_t points = lattice_.places.size();
    const glm::dvec2 own = query.place * tile.scale;
    const double toLevel = std::ldexp(1.0, -log.footprint.level);
    float total = 0;
    for (const PointLattice::Term& term : lattice_.terms) {
        const std::size_t cell = tile.cell(query.x + term.dx, query.y + term.dy);
        const auto slot = static_cast<std::uint32_t>(cell * points + static_cast<std::size_t>(term.point));
        if (!(tile.color[slot].channel[3] > 0)) continue;
        total += term.weight;
        const std::vector<std::uint32_t>& slots = tile.points.slots;
        const auto last = slots.begin() + static_cast<std::ptrdiff_t>(tile.points.count);
        const auto n = static_cast<std::size_t>(std::find(slots.begin(), last, slot) - slots.begin());
        const PointTaps taps = reader_.taps(tile.footprints.jacobian(n));
        const double size = std::ldexp(1.0, taps.level);
        for (int k = 0; k < taps.count; ++k) {
            const glm::dvec2 place = glm::dvec2(tile.footprints.s[n], tile.footprints.t[n]) + taps.offset(k);
            const BilinearSupport x = plain_.across(taps.level).support(place.x / size);
            const BilinearSupport y = plain_.down(taps.level).support(place.y / size);
            for (int c = 0; c < 4; ++c) {
                const bool right = c % 2 == 1, below = c / 2 == 1;
                FootprintTexel texel;
                texel.i = right ? x.second : x.first;
                texel.j = below ? y.second : y.first;
                texel.level = taps.level;
                const glm::dvec2 off{(right ? 1 : 0) - x.share, (below ? 1 : 0) - y.share};
                const glm::dvec2 at = log.footprint.centre + (place - own + size * off) * toLevel;
                texel.u = at.x, texel.v = at.y;
                texel.weight = Color(term.weight / static_cast<float>(taps.count) * (right ? x.share : 1 - x.share) *
                                     (below ? y.share : 1 - y.share));
                texel.tested = true;
                log.texels.push_back(texel);
            }
        }
    }
    log.allHidden = !(total > 0);
}

}  // namespace relief
