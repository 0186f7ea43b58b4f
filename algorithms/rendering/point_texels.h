// The texels that filters without a list of their own read: samples of the texture at one point.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "filtering/footprint_log.h"
#include "rendering/frame.h"

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

// Appends the texels that the filter reads for a sample at `place` (texels of level 0), with weights that sum to
// `weight`. filter: nearest, bilinear, trilinear, or any other, whose point samples are bilinear on level 0. level:
// that of the footprint, finer one of the two that trilinear reads. j: of the pixel, in texels of level 0. Without a
// colour picture the texels are heights, which are sampled like the request's surface.
void addPointTexels(std::vector<FootprintTexel>& texels, const FrameRequest& request, const SampledTexture& texture,
                    const std::string& filter, int level, const Jacobian& j, glm::dvec2 place, const Color& weight);

}  // namespace relief
