#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "filtering/grid_tile.h"

namespace relief {

// The slots that the one pixel there is sums, each with what it counts: means as their centres.
std::vector<std::pair<std::size_t, float>> GridKernel::summedSlots(const FilterQuery& query, const Tile& tile) const {
    const std::size_t points = lattice_.places.size(), row = static_cast<std::size_t>(tile.width);
    std::vector<std::pair<std::size_t, float>> slots;
    for (const PointLattice::Term& term : lattice_.terms) {
        const std::size_t cell = tile.cell(query.x + term.dx, query.y + term.dy);
        const auto k = static_cast<std::size_t>(term.point);
        if ((tile.mean[cell] >> k & 1) == 0) {
            slots.emplace_back(cell * points + k, term.weight);
            continue;
        }
        const std::size_t at = cell - static_cast<std::size_t>(lattice_.squareOf(k, tile.width));
        const std::array<std::size_t, 4> corners{at, at + 1, at + row, at + row + 1};
        for (std::size_t n = 0; n < corners.size(); ++n) {
            slots.emplace_back(corners[n] * points, term.weight * static_cast<float>(lattice_.shares[k][n]));
        }
    }
    return slots;
}

// The texels of the one pixel there is, as parts of its points' shares.
void GridKernel::logPoints(const FilterQuery& query, const Tile& tile, FootprintLog& log) const {
    const glm::dvec2 own = query.place * tile.scale;
    const double toLevel = std::ldexp(1.0, -log.footprint.level);
    float total = 0;
    for (const auto& [slot, weight] : summedSlots(query, tile)) {
        if (!(tile.color[slot].channel[3] > 0)) continue;
        total += weight;
        const auto read = std::find_if(tile.read.begin(), tile.read.end(),
                                       [slot = slot](const ReadPoint& point) { return point.slot == slot; });
        const PointTaps taps = reader_.taps(read->jacobian);
        const double size = std::ldexp(1.0, taps.level);
        for (int k = 0; k < taps.count; ++k) {
            const glm::dvec2 place = read->place + taps.offset(k);
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
                texel.weight = Color(weight / static_cast<float>(taps.count) * (right ? x.share : 1 - x.share) *
                                     (below ? y.share : 1 - y.share));
                texel.tested = true;
                log.texels.push_back(texel);
            }
        }
    }
    log.allHidden = !(total > 0);
}

}  // namespace relief
