#include "measuring/diagnose/layer_bracket.h"

#include <algorithm>

namespace relief {

double LayerBracket::secant() const {
    if (!(gapBelow > gapAbove)) return below;
    return above + gapAbove / (gapAbove - gapBelow) * (below - above);
}

void LayerBracket::halve(const SampledSurface& surface) {
    const double at = middle();
    const double gap = surface.gapAt(at);
    (gap < 0 ? above : below) = at;
    (gap < 0 ? gapAbove : gapBelow) = gap;
}

std::optional<LayerBracket> firstLayer(const SampledSurface& surface, double layers) {
    LayerBracket bracket;
    for (int n = 0;; ++n) {
        bracket.below = n / layers;
        if (!surface.inside(std::min(bracket.below, 1.0))) return std::nullopt;
        bracket.gapBelow = surface.gapAt(bracket.below);
        if (bracket.gapBelow >= 0 || bracket.below >= 1) break;
        bracket.above = bracket.below;
        bracket.gapAbove = bracket.gapBelow;
    }
    // The entry is at or below the surface: there is no layer before.
    if (bracket.below == 0) bracket.gapAbove = bracket.gapBelow;
    return bracket;
}

}  // namespace relief
