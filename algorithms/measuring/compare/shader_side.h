// The CPU's side of a comparison with an exported shader: the frame that the shader can draw, the view that it draws,
// and the differences.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/shaders/shader_maps.h"
#include "rendering/frame.h"
#include "scenario/scenario.h"

namespace relief {

// The request with what the shader has, so that like is compared with like: bilinear surface; filter nearest, bilinear
// or trilinear; texture coordinates of every pixel computed directly; no approximations. notes: what differs from the
// given request, one clause each.
struct ShaderRequest {
    FrameRequest request;
    std::vector<Message> notes;
};
ShaderRequest shaderRequest(FrameRequest request);

// The shader of the request's method. Throws InputError if there is none, see shaderText().
ShaderChoice shaderChoice(const FrameRequest& request);

// The view as the shader gets it: the text of a vertex shader that draws the frame's polygons, one triangle strip of
// four vertices per instance, row 0 of the picture first; the numbers of its uniform block (binding 1); and what the
// fragment shader's own block needs.
struct ShaderView {
    std::string vertexText;
    std::vector<float> numbers;
    int polygons = 0;
    ShaderUniforms uniforms;
};
ShaderView shaderView(const Frame& frame, const FrameRequest& request);

// Returns the frame's picture with the shader's light: by height differences over one texel, and with its self-shadow,
// for which the tracer follows the light's ray down from the top of the slab; at the border, where that ray begins at
// the map's side, whether it is blocked is decided exactly. tracer: the frame's. Throws Cancelled.
ColorImage shaderLight(const Frame& frame, const FrameRequest& request, const Tracer& tracer, MapCache& maps,
                       Work& work);

// Returns the colour texture (binding 2) of a request, with four channels and without MIP levels.
ShaderTexture colorTexture(const FrameRequest& request);

// The differences of all pixels: of the hits, texels, positive where the shader's lies behind the CPU's (NaN where
// neither hits or no polygon is seen, infinite where only one hits); and of the colours as displayed, the mean over the
// channels, 0 to 1. far: hits farther apart than kSameAnswer; otherOutcome: pixels where only one hits.
struct ShaderDifferences {
    FloatImage hits, colors;
    std::size_t compared = 0, far = 0, otherOutcome = 0;
    double largestHit = 0;  // texels, finite
    double meanColor = 0, largestColor = 0;
    // Pixels with the largest difference; another outcome counts as larger than any number.
    std::optional<PixelChoice> worstHit, worstColor;
};
// answers: of the pass over the frame's rays (rayPassText()), four numbers for each pixel. shader: the picture that it
// drew; cpu: shaderLight().
ShaderDifferences shaderDifferences(const Frame& frame, const std::vector<float>& answers, const ColorImage& shader,
                                    const ColorImage& cpu);

}  // namespace relief
