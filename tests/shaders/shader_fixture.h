// OpenGL for the tests of shaders: Mesa, in software; where there is no Mesa, a graphics card.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "panes/shader/shader_gl.h"
#include "relief/height_field.h"
#include "relief/map_cache.h"
#include "relief/ray.h"
#include "relief/shaders/shader_export.h"
#include "relief/shaders/shader_maps.h"

namespace relief::test {

using Gl = reliefui::ShaderGl;

// Null, with the reason in `why`, where there is no OpenGL 4.5.
inline std::unique_ptr<Gl> openGl(std::string& why) {
    // The same renderer on every machine that has Mesa.
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    reliefui::EglProblem problem{};
    auto gl = Gl::open(reliefui::EglPlace::Nowhere, problem);
    if (!gl) {
        why = problem == reliefui::EglProblem::NoEgl
                  ? "there is no EGL without a display (packages libegl1, libgl1-mesa-dri)"
                  : "there is no OpenGL 4.5";
    }
    return gl;
}

// Skipped, with the reason, where there is no OpenGL.
class ShaderTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        gl_ = openGl(why_);
        if (gl_) std::cout << "OpenGL of " << gl_->renderer() << "\n";
    }
    static void TearDownTestSuite() { gl_.reset(); }
    // Mesa's software weights texels in float, where a graphics card has 8 bits.
    static bool samplesInFloat() { return gl_->renderer().find("llvmpipe") != std::string::npos; }
    void SetUp() override {
        if (!gl_) GTEST_SKIP() << why_;
    }
    inline static std::unique_ptr<Gl> gl_;
    inline static std::string why_;
    Work work_;
    MapCache maps_;
};

// Texels that a ray runs along the map from the top of the slab to its floor; at least 1.
inline double texelsOf(const ViewRay& ray) {
    return std::max(1.0, std::hypot(ray.a, ray.b));
}

// Builds and binds the maps that the tracer reads, and the uniform block.
inline void bindMaps(Gl& gl, const ShaderChoice& choice, const HeightField& field, const ShaderUniforms& uniforms,
                     Work& work) {
    MapCache maps;
    const ShaderInputs inputs = shaderInputs(choice, field, uniforms, maps, work);
    for (const auto& [unit, texture] : inputs.textures) gl.setTexture(unit, texture, choice.address);
    gl.setUniforms(inputs.uniforms);
}

}  // namespace relief::test
