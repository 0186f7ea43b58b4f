// What a shader is given: the maps that it reads, as textures in the layout that its opening comment states, the
// numbers of its uniform block, and rays in place of a picture's pixels.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "relief/height_field.h"
#include "relief/image.h"
#include "relief/map_cache.h"
#include "relief/ray.h"
#include "relief/shaders/shader_export.h"

namespace relief {

// A texture of floats with 1, 2 or 4 channels; 3-D with more than one layer. levels: MIP levels, level 0 first; level l
// has max(1, side >> l) texels on each side.
struct ShaderTexture {
    int width = 0, height = 0, layers = 1, channels = 1;
    std::vector<std::vector<float>> levels;
    bool linear = true;
};

// The texture of a picture's values.
ShaderTexture shaderTexture(const FloatImage& image);
// MIP levels of any size, each ceil(half) of the one before, in a texture with room for all of them.
ShaderTexture levelsTexture(const std::vector<FloatImage>& levels);

// The numbers of the uniform block that do not follow from the height field.
struct ShaderUniforms {
    float ambient = 0.3F, intensity = 0.7F;
    float depthConstant = 1, depthPerDistance = -1;
};

// Returns the uniform block, as std140 lays it out, and the textures by their binding, without the colours (binding 2).
// The maps are those that the method reads with its options, from the cache. choice: with `texelSlopes`, the cones are
// the method's own numbers. Throws InputError, MemoryError, Cancelled.
struct ShaderInputs {
    std::vector<float> uniforms;
    std::map<unsigned, ShaderTexture> textures;
};
ShaderInputs shaderInputs(const ShaderChoice& choice, const HeightField& field, const ShaderUniforms& uniforms,
                          MapCache& cache, Work& work);

// Rays as a shader traces them: four floats for each, and the rays that these numbers state.
struct ShaderRays {
    std::vector<float> numbers;
    RayBlock rounded;
};
ShaderRays shaderRays(const RayBlock& rays);

// Returns the exported text with a compute pass over rays in place of the pixel's part. Buffers: 0 the rays, 1 the
// answers, four floats for each: found (0 or 1), lambda, steps, 0. Groups of kRaysPerGroup.
inline constexpr unsigned kRaysPerGroup = 64;
std::string rayPassText(const std::string& shader);

}  // namespace relief
