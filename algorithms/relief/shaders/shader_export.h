// Tracers as shaders: a whole fragment shader in GLSL 4.5, or pixel shader in HLSL (shader model 5), with the options
// of the tracer as constants.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "relief/describe.h"
#include "relief/maps/engine_codes.h"

namespace relief {

enum class ShaderLanguage : std::uint8_t { Glsl, Hlsl };
// Throws InputError naming the option.
ShaderLanguage parseShaderLanguage(std::string_view text, const std::string& option);
std::string_view shaderLanguageName(ShaderLanguage language);

// How heights and cones between texels are made: by the texture's sampler, in one fetch, whose weights have 8 bits on
// graphics cards; or from four texels in float, as the CPU's methods do.
enum class ShaderInterpolation : std::uint8_t { Sampler, Float };
// Throws InputError naming the option.
ShaderInterpolation parseShaderInterpolation(std::string_view text, const std::string& option);
std::string_view shaderInterpolationName(ShaderInterpolation interpolation);

struct ShaderChoice {
    MethodChoice method;
    Address address = Address::Repeat;
    ShaderLanguage language = ShaderLanguage::Glsl;
    HeightWhite white = HeightWhite::High;
    ConeCoding cones{};  // how the map stores its cones
    ShaderInterpolation interpolation = ShaderInterpolation::Float;
    bool texelSlopes = false;  // in place of `cones`: as heights per texel, as in the maps that tracers read
};
// Sets the unit of the cones: that of `cones`, or "texel-slope". Throws InputError naming the option.
void setConeUnit(ShaderChoice& choice, std::string_view text, const std::string& option);

// The tracers that have a shader, and those of them that read a cone map.
std::vector<std::string> shaderTracers();
bool readsCones(const std::string& tracer);

// Returns the shader. `made`: the program and its version, for the opening comment. The method must have been checked.
// Throws InputError if the tracer has no shader, or not with these options, or if the language is missing in this
// build.
std::string shaderText(const ShaderChoice& choice, const std::string& made);

// Returns the command that writes the shader, with every convention: "relief export shader --tracer ...", without -o.
// Throws as shaderText().
std::string shaderCommand(const ShaderChoice& choice);

// The depth by which a blocker must lie above the point that it shadows, in the shader of the method.
double shaderShadowBias(const MethodChoice& method);

// The line at which the shader's functions end and its inputs, outputs and main() begin: a test or another pass may put
// its own in their place.
inline constexpr std::string_view kShaderPixelPart = "// --- The pixel";

}  // namespace relief
