// SIMD version of layers, layers-secant and layers-bisection in double, one ray per lane; finished lanes are refilled.
// Reference: LayersTracerOf::trace. It performs the operations of layers.h and HeightField::at in the same order, so
// the results are the same bits for any target and vector width.
#pragma once

#include <cstddef>
#include <vector>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

// How the hit is refined between the last two layers.
enum class LayerRefinement : std::uint8_t { None, Secant, Bisection };

struct LayerSearch {
    const HeightField& field;
    int layers;
    LayerRefinement refinement;
    int bisections;
};

// Sets hits for the rays first to last - 1. Returns the indices of rays that the reference has to trace: those so
// distant that one product cannot subtract their period exactly.
std::vector<std::size_t> layersSimd(const LayerSearch& search, const RayBlock& rays, std::size_t first,
                                    std::size_t last, HitBlock& hits);

}  // namespace relief
