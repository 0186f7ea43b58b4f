// layers, layers-secant, layers-bisection in lanes of double, a ray a lane, finished lanes refilled: the operations of
// layers.h and HeightField::at in their order, so the same bits for any target and width. Reference:
// LayersTracerOf::trace.
#pragma once

#include <cstddef>
#include <vector>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

enum class LayerRefinement : std::uint8_t { None, Secant, Bisection };

struct LayerSearch {
    const HeightField& field;
    int layers;
    LayerRefinement refinement;
    int bisections;
};

// hits of rays first to last - 1. Returns those that are left to the reference: so far off that a period cannot be
// taken off exactly by one product.
std::vector<std::size_t> layersInLanes(const LayerSearch& search, const RayBlock& rays, std::size_t first,
                                       std::size_t last, HitBlock& hits);

}  // namespace relief
