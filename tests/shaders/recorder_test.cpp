// The recorder for shaders: a marcher in GLSL with a fault put in, run by Mesa's software OpenGL and recorded by
// app/recorder/relief_recorder.glsl; the doctor names the fault.
#include <cstring>

#include <gtest/gtest.h>

#include "measuring/diagnose/diagnose.h"
#include "measuring/random_rays.h"
#include "relief/files.h"
#include "relief/reliefs.h"
#include "shaders/shader_fixture.h"

namespace relief::test {

namespace {

constexpr int kRays = 600;

// Marches through layers with bisection. flipped: over a map that is read upside down. The buffer of the results is the
// recorder's: its first four numbers, which a program would write, are written by every ray alike.
std::string marcher(bool flipped) {
    return "#version 450\nlayout(local_size_x = 64) in;\n#define RELIEF_RECORDER_BINDING 1\n" +
           readTextFile(RELIEF_RECORDER "/relief_recorder.glsl") +
           "layout(std430, binding = 0) readonly buffer Rays { vec4 rays[]; };\n"
           "layout(binding = 0) uniform sampler2D heights;\n"
           "float gap(vec4 ray, float lambda) {\n"
           "    vec2 place = (ray.xy + lambda * ray.zw) / vec2(textureSize(heights, 0));\n"
           "    return textureLod(heights, vec2(place.x, " +
           std::string(flipped ? "1.0 - place.y" : "place.y") +
           "), 0.0).r - (1.0 - lambda);\n"
           "}\n"
           "void main() {\n"
           "    uint number = gl_GlobalInvocationID.x;\n"
           "    if (number >= " +
           std::to_string(kRays) +
           "u) return;\n"
           "    reliefRecords = " +
           std::to_string(kRays) +
           ";\n    reliefCount = 0;\n    reliefChosenRay = -1;\n"
           "    reliefRays = " +
           std::to_string(kRays) +
           ";\n"
           "    vec4 ray = rays[number];\n"
           "    reliefBegin(number);\n"
           "    float low = 0.0, high = 0.0;\n"
           "    for (int n = 1; n <= 2048 && gap(ray, high) < 0.0; ++n) {\n"
           "        low = high;\n        high = float(n) / 2048.0;\n"
           "        reliefStep(low, high, gap(ray, high) + 1.0 - high);\n    }\n"
           "    for (int n = 0; n < 12; ++n) {\n"
           "        float middle = 0.5 * (low + high);\n"
           "        if (gap(ray, middle) < 0.0) low = middle; else high = middle;\n    }\n"
           "    reliefHit(high);\n}\n";
}

}  // namespace

TEST(Recorder, AShaderIsRecordedAndDiagnosed) {
    std::string why;
    const auto gl = openGl(why);
    if (!gl) GTEST_SKIP() << why;
    const FloatImage heights = makeRelief("fractal", 128, 128, 3);
    const HeightField field(std::make_shared<const FloatImage>(heights), Surface::Bilinear, Address::Repeat, 0.15);
    ShaderTexture texture;
    texture.width = 128;
    texture.height = 128;
    texture.levels = {std::vector<float>(heights.pixels().begin(), heights.pixels().end())};
    gl->setTexture(0, texture, Address::Repeat);
    TracerRecord record;
    record.rays = randomRays(11, field, kRays, 20);
    // One more ray makes room for the buffer's first numbers.
    std::vector<float> rays = shaderRays(record.rays).numbers;
    rays.resize(rays.size() + 4);
    for (const bool flipped : {true, false}) {
        const std::vector<float> buffer = gl->compute(marcher(flipped), rays);
        ASSERT_EQ(buffer.size(), 4U * (kRays + 1));
        std::int32_t records = 0;
        std::memcpy(&records, buffer.data(), sizeof records);
        EXPECT_EQ(records, kRays);
        record.hits.resize(kRays);
        for (std::size_t r = 0; r < kRays; ++r) {
            const float* const answer = &buffer[4 * (r + 1)];
            ASSERT_EQ(answer[0], 1) << "ray " << r;
            record.hits.set(r, Hit::at(record.rays[r], static_cast<double>(answer[1])));
            EXPECT_GE(answer[2], 1);
        }
        Work work;
        const Diagnosis diagnosis = diagnose(record, field, work);
        if (!flipped) {
            EXPECT_TRUE(diagnosis.healthy()) << diagnosis.wrong << " wrong";
            continue;
        }
        ASSERT_FALSE(diagnosis.findings.empty());
        EXPECT_EQ(faultName(diagnosis.findings[0].fault.fault), "y-flipped");
    }
}

}  // namespace relief::test
