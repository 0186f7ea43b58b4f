// relief export shader --tracer NAME [--set NAME=VALUE ...] [--address ...] [--lang glsl|hlsl] [-o FILE]
#include "export.h"
#include "output.h"
#include "relief/shaders/shader_export.h"

namespace relief::app {

namespace {

struct ShaderOptions {
    OptionText lang, white, interpolation, unit, length, scale;
};

// Throws InputError if an option for cones is given to a tracer that reads none.
void refuseCones(const std::string& tracer, const std::string& option) {
    if (readsCones(tracer)) return;
    std::vector<std::string> known;
    for (const std::string& name : shaderTracers()) {
        if (readsCones(name)) known.push_back(name);
    }
    throw InputError(option, Message(MessageId::ShaderNoCones, {{"method", tracer}, {"known", commaList(known)}}));
}

int runShader(const ShaderOptions& options, const ExportOptions& given, Session& session) {
    const Scenario scenario = given.scenario.withoutHeights();
    ShaderChoice choice;
    choice.method = scenario.method;
    choice.address = scenario.address;
    if (options.lang) choice.language = parseShaderLanguage(*options.lang, "--lang");
    if (options.white) choice.white = parseHeightWhite(*options.white, "--white");
    if (options.interpolation) {
        choice.interpolation = parseShaderInterpolation(*options.interpolation, "--interpolation");
    }
    if (options.unit) setConeUnit(choice, *options.unit, "--unit");
    if (options.length) choice.cones.length = parseConeLength(*options.length, "--length");
    if (options.scale) {
        choice.cones.scale = parseNumber(*options.scale, "--cone-scale");
        if (!(choice.cones.scale > 0)) {
            throw InputError("--cone-scale", Message(MessageId::OutOfRange,
                                                     {{"what", "S"}, {"value", choice.cones.scale}, {"range", "> 0"}}));
        }
    }
    const std::string text = shaderText(choice, "Reliefscope " RELIEF_VERSION);
    for (const auto& [name, value] : {std::pair("--unit", &options.unit), std::pair("--length", &options.length),
                                      std::pair("--cone-scale", &options.scale)}) {
        if (*value) refuseCones(choice.method.name, name);
    }
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
    addText(parser, "--white", options->white, "high|deep",
            "what white means in your height map, high (default) or deep", group);
    addText(parser, "--interpolation", options->interpolation, "float|sampler",
            "how heights, cones and distances between texels are interpolated. float: from four texels, or eight "
            "voxels, with weights in float, as this program does (default); sampler: by the texture's sampler, in one "
            "fetch; graphics cards round its weights to 8 bits",
            group);
    addText(parser, "--unit", options->unit, "ratio|sqrt-ratio|slope|texel-slope",
            "numbers by which your map stores cones. ratio: radius per unit of height (default); sqrt-ratio: its root; "
            "slope: one over the ratio; texel-slope: heights per texel, as this program's own maps",
            group);
    addText(parser, "--length", options->length, "uv|width",
            "unit of the cones' radius: texture coordinates (uv, default), or texture widths on both axes", group);
    addText(parser, "--cone-scale", options->scale, "S", "the ratio or slope that white stands for, default 1", group);
    return {
        "shader",
        "shader: writes a tracer as a whole fragment shader (HLSL: pixel shader), with self-shadow, silhouette at "
        "the map's border, and depth. The method's options, the addressing and the layout of the map are constants on "
        "top; sizes and numbers of levels are uniforms, so that no map is needed here. The opening comment states "
        "the layout of the maps and all conventions. Tracers that have a shader: " +
            commaList(shaderTracers()) + ".",
        "  relief export shader --tracer layers-bisection --set layers=32 -o relief.frag\n"
        "  relief export shader --tracer relaxed-cone --unit sqrt-ratio --lang hlsl -o relief.hlsl",
        {"--tracer", "--set", "--address", "--lang", "--white", "--interpolation", "--unit", "--length",
         "--cone-scale"},
        [options](const ExportOptions& given, Session& session) { return runShader(*options, given, session); }};
}

}  // namespace relief::app
