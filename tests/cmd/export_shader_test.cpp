// relief export shader
#include "command_test.h"

namespace relief::test {

class ExportShaderTest : public CommandTest {};
INSTANTIATE_TEST_SUITE_P(Places, ExportShaderTest, testing::ValuesIn(places()), placeName);

// Where the build has no converter, HLSL is refused by one line.
TEST_P(ExportShaderTest, NeedsNoMap) {
    const std::string text = runFine({"export", "shader", "--tracer", "layers:layers=12", "--address", "clamp"});
    EXPECT_NE(text.find("\nconst int LAYERS = 12;"), std::string::npos);
    EXPECT_NE(text.find("\nconst int ADDRESS = 1;"), std::string::npos);
    EXPECT_NE(text.find("--set layers=12 --address clamp"), std::string::npos) << "the command that made it";
    EXPECT_EQ(runFine({"export", "shader", "--tracer", "layers", "--set", "layers=12", "--address", "clamp", "-o",
                       path("s.frag")}),
              "");
    EXPECT_EQ(read("s.frag"), text);
    const Result hlsl = run({"export", "shader", "--tracer", "distance", "--set", "within=0.25", "--lang", "hlsl"});
    if (hlsl.status != 0) GTEST_SKIP() << hlsl.err;
    EXPECT_NE(hlsl.out.find("static const float WITHIN = 0.25;"), std::string::npos) << "whatever the decimal sign";
    EXPECT_NE(hlsl.out.find("Hit traceDistance(Ray ray)"), std::string::npos);
}

TEST_P(ExportShaderTest, RefusesWhatItCannotWrite) {
    const auto refused = [&](std::vector<std::string> arguments, const std::vector<std::string>& parts) {
        arguments.insert(arguments.begin(), {"export", "shader"});
        expectRefusal(arguments, 2, parts);
    };
    refused({"--tracer", "exact"}, {"--tracer", "exact", "max-pyramid", "relaxed-cone"});
    refused({"--tracer", "cone:sectors=4"}, {"cone", "sectors=1"});
    refused({"--tracer", "distance", "--set", "map=refined-sampled"}, {"map=euclidean"});
    refused({"--tracer", "layers", "--unit", "ratio"}, {"--unit", "layers", "cone-dummer"});
    refused({"--tracer", "cone", "--cone-scale", "0"}, {"--cone-scale"});
    refused({"--tracer", "cone", "--lang", "msl"}, {"msl", "glsl, hlsl"});
    refused({"--tracer", "cone", "--camera", "elevation=20"}, {"--camera"});
    expectRefusal({"export", "picture"}, 2, {"picture", "shader"});
    EXPECT_TRUE(files().empty());
}

}  // namespace relief::test
