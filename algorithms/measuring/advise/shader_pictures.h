// The pictures by which techniques for shaders are compared: those of the views, as drawn with the exact hits and with
// a technique's hits.
#pragma once

#include <memory>
#include <vector>

#include "measuring/advise/shader_forms.h"
#include "rendering/frame.h"

namespace relief {

class ShaderPictures {
  public:
    // Draws the exact pictures. Keeps a reference to options. Throws Cancelled, MemoryError.
    ShaderPictures(const ShaderAdviceOptions& options, Work& work);

    // Draws the pictures of a form, counts its rays, and sets all numbers that are measured.
    void measure(ShaderForm& form, const ShaderStore& store, Work& work) const;

    int pictures() const { return static_cast<int>(exact_.size()); }
    std::int64_t rays() const;

  private:
    struct Exact {
        FrameRequest request;
        std::shared_ptr<const Frame> frame;
        std::vector<std::size_t> pixels;  // that a polygon covers
    };
    struct Totals;
    void compare(const Exact& exact, const Frame& frame, Totals& totals, Work& work) const;

    std::vector<Exact> exact_;
};

}  // namespace relief
