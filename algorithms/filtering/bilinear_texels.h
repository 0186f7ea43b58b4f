// The texels that a bilinear sample of a texture reads.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "filtering/footprint_log.h"

namespace relief {

// A texture as a filter samples it: the size of its level 0, and how it continues.
struct SampledTexture {
    int width = 1;
    int height = 1;
    Address address = Address::Repeat;

    LevelAxis across(int level) const { return LevelAxis::of(width, level, address); }
    LevelAxis down(int level) const { return LevelAxis::of(height, level, address); }
};

// Returns the centre of the periodic copy of texel i that is nearest to x.
double unwrappedCentre(const LevelAxis& axis, int i, double x);

// Appends the texels of a bilinear sample of a level. place: texels of that level. Their places are in texels of level
// `base`; their weights sum to `weight`.
void addBilinearTexels(std::vector<FootprintTexel>& texels, const SampledTexture& texture, glm::dvec2 place, int level,
                       int base, const Color& weight);

}  // namespace relief
