// Tracers as shaders: a whole fragment shader in GLSL 4.5, or pixel shader in HLSL (shader model 5), with the options
// of the tracer as constants.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "relief/describe.h"

namespace relief {

enum class ShaderLanguage : std::uint8_t { Glsl, Hlsl };
// Throws InputError naming the option.
ShaderLanguage parseShaderLanguage(std::string_view text, const std::string& option);
std::string_view shaderLanguageName(ShaderLanguage language);

// How a map stores its cones; as in `relief map` for engines. Ratio: radius per height; SqrtRatio: its root, which
// gives narrow cones more of 8 bits; Slope: one over the ratio; TexelSlope: heights per texel, as the maps that tracers
// read.
enum class ShaderConeUnit : std::uint8_t { Ratio, SqrtRatio, Slope, TexelSlope };
// The unit of length of ratio and slope: texture coordinates, or texture widths on both axes.
enum class ShaderConeLength : std::uint8_t { Uv, Width };
// What white means in a height map.
enum class ShaderWhite : std::uint8_t { High, Deep };
// Throw InputError naming the option.
ShaderConeUnit parseShaderConeUnit(std::string_view text, const std::string& option);
ShaderConeLength parseShaderConeLength(std::string_view text, const std::string& option);
ShaderWhite parseShaderWhite(std::string_view text, const std::string& option);

struct ShaderChoice {
    MethodChoice method;
    Address address = Address::Repeat;
    ShaderLanguage language = ShaderLanguage::Glsl;
    ShaderWhite white = ShaderWhite::High;
    ShaderConeUnit coneUnit = ShaderConeUnit::Ratio;
    ShaderConeLength coneLength = ShaderConeLength::Uv;
    double coneScale = 1;
};

// The tracers that have a shader, and those of them that read a cone map.
std::vector<std::string> shaderTracers();
bool readsCones(const std::string& tracer);

// Returns the shader. `made`: the program and its version, for the opening comment. The method must have been checked.
// Throws InputError if the tracer has no shader, or not with these options, or if the language is missing in this
// build.
std::string shaderText(const ShaderChoice& choice, const std::string& made);

// The line at which the shader's functions end and its inputs, outputs and main() begin: a test or another pass may put
// its own in their place.
inline constexpr std::string_view kShaderPixelPart = "// --- The pixel";

}  // namespace relief
