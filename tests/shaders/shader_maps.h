// The maps of a shader as textures, in the layout that its opening comment states.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "relief/height_field.h"
#include "relief/image.h"
#include "relief/map_cache.h"
#include "relief/ray.h"
#include "relief/shaders/shader_export.h"
#include "shaders/gl.h"

namespace relief::test {

// Skipped, with the reason, where there is no OpenGL.
class ShaderTest : public testing::Test {
  protected:
    static void SetUpTestSuite() { gl_ = Gl::open(why_); }
    static void TearDownTestSuite() { gl_.reset(); }
    void SetUp() override {
        if (!gl_) GTEST_SKIP() << why_;
    }
    inline static std::unique_ptr<Gl> gl_;
    inline static std::string why_;
    Work work_;
    MapCache maps_;
};

// Rays as a shader traces them.
struct ShaderRays {
    std::vector<float> numbers;  // four for each ray, for Gl::compute()
    RayBlock rounded;            // the rays that these numbers state
};
ShaderRays shaderRays(const RayBlock& rays);
// Texels that a ray runs along the map from the top of the slab to its floor; at least 1.
double texelsOf(const ViewRay& ray);

// The numbers of the uniform block.
struct ShaderUniforms {
    float ambient = 0.3F, intensity = 0.7F;
    float depthConstant = 1, depthPerDistance = -1;
};

// The exported text with a compute pass over rays in place of the pixel's part; see Gl::compute(). Of each hit: found,
// lambda, steps.
std::string computeText(const std::string& shader);

// MIP levels of any size, each ceil(half) of the one before.
TextureData levelsTexture(const std::vector<FloatImage>& levels);

// Builds and binds the maps that the tracer reads, and the uniform block.
void bindMaps(Gl& gl, const ShaderChoice& choice, const HeightField& field, const ShaderUniforms& uniforms, Work& work);

}  // namespace relief::test
