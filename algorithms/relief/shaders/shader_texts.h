// The texts of the shaders, which the build joins from the parts in this folder (assemble.cmake).
#pragma once

#include <string>
#include <vector>

namespace relief {

struct ShaderText {
    std::string tracer;
    std::string header;  // conventions, as lines of comment
    std::string glsl;
    std::string hlsl;  // empty if the build had no converter
};

const std::vector<ShaderText>& shaderTexts();

}  // namespace relief
