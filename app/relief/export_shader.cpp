// relief export shader --tracer NAME [--set NAME=VALUE ...] [--address ...] [--lang glsl|hlsl] [-o FILE]
#include "export.h"
#include "output.h"
#include "relief/shaders/shader_export.h"

namespace relief::app {

namespace {

struct ShaderOptions {
    OptionText lang, coneUnits;
};

int runShader(const ShaderOptions& options, const ExportOptions& given, Session& session) {
    const Scenario scenario = given.scenario.scenario();
    ShaderChoice choice{scenario.method, scenario.address, {}, {}};
    if (options.lang) choice.language = parseShaderLanguage(*options.lang, "--lang");
    if (options.coneUnits) {
        choice.coneUnits = parseConeUnits(*options.coneUnits, "--cone-units");
        if (!readsCones(choice.method.name)) {
            std::vector<std::string> known;
            for (const std::string& name : shaderTracers()) {
                if (readsCones(name)) known.push_back(name);
            }
            throw InputError("--cone-units", Message(MessageId::ShaderNoCones,
                                                     {{"method", choice.method.name}, {"known", commaList(known)}}));
        }
    }
    const std::string text = shaderText(choice, "Reliefscope " RELIEF_VERSION);
    TextOutput output(given.output.value_or("-"), session.stop());
    output.write(text);
    output.commit();
    return kDone;
}

}  // namespace

ExportKind addShaderExport(CLI::App& parser) {
    auto options = std::make_shared<ShaderOptions>();
    const char* group = "Shader";
    addText(
        parser, "--lang", options->lang, "glsl|hlsl",
        "language. glsl: GLSL 4.5, valid for OpenGL and, by glslangValidator -V, for Vulkan (default); hlsl: shader "
        "model 5",
        group);
    addText(parser, "--cone-units", options->coneUnits, "slope|ratio|sqrt",
            "numbers by which your map stores cones. slope: heights per texel, as relief map stores them (default); "
            "ratio: radius in texture widths per unit of height; sqrt: the root of the ratio",
            group);
    return {"shader",
            "shader: writes a tracer as a whole fragment shader (HLSL: pixel shader), with self-shadow, silhouette at "
            "the map's border, and depth. The method's options, the addressing and the units of cones are constants on "
            "top; sizes and numbers of levels are uniforms, so that no map is needed here. The opening comment states "
            "the layout of the maps and all conventions. Tracers that have a shader: " +
                commaList(shaderTracers()) + ".",
            "  relief export shader --tracer layers-bisection --set layers=32 -o relief.frag\n"
            "  relief export shader --tracer relaxed-cone --cone-units sqrt --lang hlsl -o relief.hlsl",
            {"--tracer", "--set", "--address", "--lang", "--cone-units"},
            [options](const ExportOptions& given, Session& session) { return runShader(*options, given, session); }};
}

}  // namespace relief::app
