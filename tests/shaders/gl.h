// OpenGL without a window or a display (EGL, surfaceless; Mesa's llvmpipe), as far as the tests of shaders need it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "relief/addressing.h"

namespace relief::test {

// A texture of floats with one or two channels; 3-D with more than one layer. levels: of MIP levels, level 0 first.
struct TextureData {
    int width = 0, height = 0, layers = 1, channels = 1;
    std::vector<std::vector<float>> levels;
    bool linear = true;
};

class Gl {
  public:
    // Null, with the reason in `why`, where there is no OpenGL 4.5.
    static std::unique_ptr<Gl> open(std::string& why);
    ~Gl();
    Gl(const Gl&) = delete;
    Gl& operator=(const Gl&) = delete;

    // What draws: "llvmpipe (...)".
    std::string renderer() const;
    // Binds a texture to the unit, until the next one there.
    void setTexture(unsigned unit, const TextureData& data, Address address);
    // Binds the numbers to uniform block 0.
    void setUniforms(const std::vector<float>& numbers);
    // Runs a compute shader over the rays, four numbers each, in groups of 64, and returns its four numbers for each.
    // Buffers: 0 rays, 1 results. Throws std::runtime_error with the compiler's message.
    std::vector<float> compute(const std::string& text, const std::vector<float>& rays);
    // A picture of RGBA and depth, bottom row first.
    struct Picture {
        std::vector<float> color, depth;
    };
    // Draws a triangle strip of four vertices that the vertex shader makes from gl_VertexID.
    Picture draw(const std::string& vertexText, const std::string& fragmentText, int width, int height);

  private:
    Gl() = default;
    struct Handles;
    std::unique_ptr<Handles> handles_;
};

}  // namespace relief::test
