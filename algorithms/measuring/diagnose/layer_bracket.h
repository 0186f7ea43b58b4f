// How tracers of layers find the surface: the first of equal layers at or below it, and what they do between that layer
// and the one before.
#pragma once

#include <optional>

#include "relief/sampled_surface.h"

namespace relief {

// lambda of the last layer above the surface and of the first at or below it; and surface minus ray there.
struct LayerBracket {
    double above = 0, gapAbove = 0;
    double below = 0, gapBelow = 0;

    double middle() const { return 0.5 * (above + below); }
    // Returns where the line between the two meets the surface, lambda.
    double secant() const;
    // Leaves the half in which the surface is looked for.
    void halve(const SampledSurface& surface);
};

// layers: in the slab; as public shaders compute it from the view, seldom an integer: then the last layer is below the
// slab. Returns std::nullopt if the ray leaves the picture under border addressing.
std::optional<LayerBracket> firstLayer(const SampledSurface& surface, double layers);

}  // namespace relief
