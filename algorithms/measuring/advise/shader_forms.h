// The techniques that a shader may use: their bounds of steps and fetches, their textures, and the commands that make
// them.
#pragma once

#include "measuring/advise/recommend_shader.h"
#include "relief/shaders/shader_export.h"

namespace relief {

// The textures of a technique as a tracer of this library reads them.
struct ShaderStore {
    HeightField field;  // the heights as the texture holds them
    std::shared_ptr<MapCache> maps;
    double coneScale = 1;  // EngineConventions::cone.scale
    double seconds = 0;
};
// Builds the maps that `relief map` would write, and decodes them. form: names method, map and bits. Throws Cancelled,
// MemoryError, InputError.
ShaderStore shaderStore(const ShaderForm& form, const HeightField& field, Work& work);

// The shader that reads the form's textures. coneScale: that of the form's store.
ShaderChoice shaderChoiceOf(const ShaderForm& form, Address address, double coneScale);
// Sets the commands.
void setCommands(ShaderForm& form, const ShaderAdviceOptions& options, double coneScale);

// Returns the texture fetches of a ray of this form from the counts of its method; of FetchKind::Texels by
// `max-pyramid` from its steps.
std::int64_t fetchesOf(const ShaderForm& form, std::int64_t steps, std::int64_t reads, Outcome outcome);
std::int64_t pyramidFetches(std::span<const Step> steps);

}  // namespace relief
