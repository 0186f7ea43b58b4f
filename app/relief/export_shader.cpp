// relief export shader --tracer NAME [--set NAME=VALUE ...] [--lang glsl|hlsl] [-o FILE]
#include "export.h"
#include "output.h"

namespace relief::app {

namespace {

struct ShaderOptions {
    OptionText lang;
};

int runShader(const ShaderOptions&, const ExportOptions& given, Session& session) {
    const Scenario scenario = given.scenario.scenario();
    TextOutput output(given.output.value_or("-"), session.stop());
    output.write(scenario.method.name + "\n");
    output.commit();
    return kDone;
}

}  // namespace

ExportKind addShaderExport(CLI::App& parser) {
    auto options = std::make_shared<ShaderOptions>();
    addText(parser, "--lang", options->lang, "glsl|hlsl", "language of the shader, default glsl", "Shader (shader)");
    return {"shader",
            "shader: writes a tracer as a fragment shader.",
            "  relief export shader --tracer relaxed-cone -o relief.frag",
            {"--tracer", "--set", "--address", "--lang"},
            [options](const ExportOptions& given, Session& session) { return runShader(*options, given, session); }};
}

}  // namespace relief::app
