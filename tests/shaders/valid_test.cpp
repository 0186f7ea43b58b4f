// The exported shaders are valid for the compilers of others: Khronos' reference compiler takes the GLSL for OpenGL and
// for Vulkan, and the HLSL; the SPIR-V that it makes is valid, and SPIRV-Cross turns it into HLSL.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "relief/files.h"
#include "relief/shaders/shader_export.h"
#include "relief/tracers.h"

namespace relief::test {
namespace {

class ShaderText : public testing::Test {
  protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        for (const std::string program : {"glslangValidator", "spirv-val", "spirv-cross"}) {
            if (std::system(("command -v " + program + " >/dev/null").c_str()) != 0) {
                GTEST_SKIP() << "there is no " << program << " (packages glslang-tools, spirv-tools, spirv-cross)";
            }
        }
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    // Runs a command of a shell in the folder.
    bool runs(const std::string& command) const {
        return std::system(("cd '" + folder_.string() + "' && { " + command + "; } >said 2>&1").c_str()) == 0;
    }
    std::string said() const { return readTextFile(path("said")); }

    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / "relief_shader_text";
};

// The method with every option that the shader takes at another value than its default.
ShaderChoice unusual(const std::string& tracer) {
    ShaderChoice choice;
    choice.method.name = tracer;
    choice.address = Address::Border;
    choice.white = HeightWhite::Deep;
    choice.interpolation = ShaderInterpolation::Sampler;
    choice.cones = {ConeUnit::SqrtRatio, ConeLength::Width, 0.5};
    for (const OptionDescription& option : findTracer(tracer).options) {
        if (option.name == "layers" || option.name == "iterations") choice.method.options[option.name] = "37";
        if (option.name == "bisections") choice.method.options[option.name] = "5";
        if (option.name == "stop") choice.method.options[option.name] = "distance";
        if (option.name == "within") choice.method.options[option.name] = "0.25";
    }
    return choice;
}

TEST_F(ShaderText, IsValidForTheCompilers) {
    for (const std::string& tracer : shaderTracers()) {
        for (ShaderChoice choice : {ShaderChoice{{tracer, {}}, {}, {}, {}}, unusual(tracer)}) {
            writeTextFile(path("s.frag"), shaderText(choice, "test"));
            EXPECT_TRUE(
                runs("glslangValidator -S frag s.frag && glslangValidator -V -o s.spv s.frag && "
                     "spirv-val s.spv && spirv-cross --hlsl --shader-model 50 s.spv"))
                << tracer << ": " << said();
            choice.language = ShaderLanguage::Hlsl;
            writeTextFile(path("s.hlsl"), shaderText(choice, "test"));
            EXPECT_TRUE(runs("glslangValidator -D -V -S frag -e main -o h.spv s.hlsl && spirv-val h.spv"))
                << tracer << ": " << said();
        }
    }
}

// The text with the recorder in front, and calls of it at the beginning of `main`, as it is written there.
std::string recorded(const std::string& head, const std::string& text, const std::string& main) {
    std::string all = head + readTextFile(RELIEF_RECORDER "/relief_recorder.glsl") + text;
    const std::size_t at = all.find(main);
    EXPECT_NE(at, std::string::npos);
    return all.insert(at + main.size(), "reliefBegin(0u); reliefStep(0.0, 0.5, 0.25); reliefHit(0.5); reliefMiss();\n");
}

TEST_F(ShaderText, TakesTheRecorder) {
    for (const std::string& tracer : shaderTracers()) {
        ShaderChoice choice{{tracer, {}}, {}, {}, {}};
        std::string text = shaderText(choice, "test");
        // In GLSL the version comes first.
        const std::string version = "#version 450\n";
        text.erase(text.find(version), version.size());
        writeTextFile(path("s.frag"), recorded(version, text, "void main() {\n"));
        EXPECT_TRUE(runs("glslangValidator -S frag s.frag && glslangValidator -V -o s.spv s.frag"))
            << tracer << ": " << said();
        choice.language = ShaderLanguage::Hlsl;
        writeTextFile(path("s.hlsl"),
                      recorded("#define RELIEF_HLSL\n", shaderText(choice, "test"), "void frag_main()\n{\n"));
        EXPECT_TRUE(runs("glslangValidator -D -V -S frag -e main -o h.spv s.hlsl")) << tracer << ": " << said();
    }
}

TEST_F(ShaderText, HoldsTheOptionsInBothLanguages) {
    for (const std::string& tracer : shaderTracers()) {
        ShaderChoice choice = unusual(tracer);
        for (const ShaderLanguage language : {ShaderLanguage::Glsl, ShaderLanguage::Hlsl}) {
            choice.language = language;
            const std::string text = shaderText(choice, "test");
            EXPECT_NE(text.find("const int ADDRESS = 2;"), std::string::npos) << tracer;
            EXPECT_NE(text.find("const int WHITE = 1;"), std::string::npos) << tracer;
            EXPECT_NE(text.find("const int INTERPOLATION = 0;"), std::string::npos) << tracer;
            for (const char* constant : {"int CONE_UNIT = 1;", "int CONE_LENGTH = 1;", "float CONE_SCALE = 0.5;"}) {
                EXPECT_EQ(text.find(constant) != std::string::npos, readsCones(tracer)) << tracer << constant;
            }
            for (const auto& [name, value] : choice.method.options) {
                std::string constant = name == "stop" ? "int STOP = 1" : name == "within" ? "float WITHIN = 0.25" : "";
                for (const char* whole : {"layers", "iterations", "bisections"}) {
                    if (name != whole) continue;
                    constant = "int " + name + " = " + value;
                    for (std::size_t i = 4; i < 4 + name.size(); ++i)
                        constant[i] = static_cast<char>(constant[i] - 'a' + 'A');
                }
                // The layers of distance are those of its map.
                if (tracer == "distance" && name == "layers") continue;
                EXPECT_NE(text.find("const " + constant + ";"), std::string::npos) << tracer << " " << constant;
            }
        }
    }
}

}  // namespace
}  // namespace relief::test
