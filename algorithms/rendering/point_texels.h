// The texels that filters without a list of their own read: samples of the texture at one point.
#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "filtering/bilinear_texels.h"
#include "rendering/frame.h"

namespace relief {

// Appends the texels that the filter reads for a sample at `place` (texels of level 0), with weights that sum to
// `weight`. filter: nearest, bilinear, trilinear, or any other, whose point samples are bilinear on level 0. level:
// that of the footprint, finer one of the two that trilinear reads. j: of the pixel, in texels of level 0. Without a
// colour picture the texels are heights, which are sampled like the request's surface.
void addPointTexels(std::vector<FootprintTexel>& texels, const FrameRequest& request, const SampledTexture& texture,
                    const std::string& filter, int level, const Jacobian& j, glm::dvec2 place, const Color& weight);

}  // namespace relief
