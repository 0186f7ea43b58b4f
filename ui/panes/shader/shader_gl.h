// OpenGL 4.5 without a window, as far as running exported shaders needs it. Uses neither Qt nor VTK, so that the tests
// of the shaders use it without a window.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "panes/egl_context.h"
#include "relief/addressing.h"
#include "relief/shaders/shader_maps.h"

namespace reliefui {

// The context has ended, as when the graphics card is reset or taken away: another one may be opened.
struct ContextLost : std::runtime_error {
    ContextLost() : std::runtime_error("the context of OpenGL is lost") {}
};

// Used on the thread that made it. Functions throw std::runtime_error with the compiler's or OpenGL's message, and
// ContextLost.
class ShaderGl {
  public:
    // Null where there is no OpenGL 4.5.
    static std::unique_ptr<ShaderGl> open(EglPlace place, EglProblem& problem);
    ~ShaderGl();
    ShaderGl(const ShaderGl&) = delete;
    ShaderGl& operator=(const ShaderGl&) = delete;

    // What draws: "llvmpipe (...)".
    std::string renderer() const;
    // Largest side of a texture, of a 3-D texture and of a picture, texels and pixels.
    struct Limits {
        int texture = 0, volume = 0, picture = 0;
    };
    Limits limits() const;

    // Binds a texture to the unit, until the next one there. mips: OpenGL makes the levels of a texture that has one.
    void setTexture(unsigned unit, const relief::ShaderTexture& data, relief::Address address, bool mips = false);
    // Binds the numbers to a uniform block, until the next ones there.
    void setUniforms(const std::vector<float>& numbers, unsigned binding = 0);
    // Runs a pass over rays (relief::rayPassText()), four numbers each, and returns its four numbers for each.
    std::vector<float> compute(const std::string& text, std::span<const float> rays);

    // RGBA, row 0 of OpenGL, the lowest, first.
    struct Picture {
        std::vector<float> color, depth;
    };
    // A picture that a vertex shader, which makes triangle strips of four vertices from gl_VertexID, and a fragment
    // shader draw. Each is compiled and linked once.
    class Drawing {
      public:
        Drawing(const std::string& vertexText, const std::string& fragmentText, int width, int height, int strips = 1);
        ~Drawing();
        Drawing(const Drawing&) = delete;
        Drawing& operator=(const Drawing&) = delete;

        void clear();
        // Draws rows [first, last). Returns the seconds until OpenGL has finished them.
        double draw(int first, int last);
        Picture read() const;

      private:
        struct Names;
        std::unique_ptr<Names> names_;
        int width_, height_, strips_;
    };
    Picture draw(const std::string& vertexText, const std::string& fragmentText, int width, int height);

  private:
    struct Handles;
    explicit ShaderGl(std::unique_ptr<EglContext> context);

    std::unique_ptr<EglContext> context_;
    std::unique_ptr<Handles> handles_;
};

}  // namespace reliefui
