#include "relief/shaders/shader_export.h"

#include <algorithm>
#include <array>

#include "relief/shaders/shader_texts.h"
#include "relief/tracers.h"

namespace relief {

namespace {

// Options for which the shader has one value only, in place of any default.
struct FixedOption {
    std::string_view tracer, option, value;
};
constexpr FixedOption kFixed[]{{"cone", "layout", kStoredLayout},
                               {"cone", "sectors", "1"},
                               {"distance", "map", "euclidean"},
                               {"max-pyramid", "base", "0"}};

constexpr double kShadowBias = 0.01;  // that of main.glsl
// Units of cones in the order of CONE_UNIT of cones.glsl: those of ConeUnit, then kTexelSlope.
constexpr std::array kConeUnits{ConeUnit::Ratio, ConeUnit::SqrtRatio, ConeUnit::Slope};
constexpr std::string_view kTexelSlope = "texel-slope";

std::string upperCase(std::string name) {
    for (char& c : name) c = c == '-' ? '_' : static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    return name;
}

// Sets the constant, which has this form in both languages: "const int NAME = 64;". Returns false if there is none.
bool setConstant(std::string& text, const std::string& name, const std::string& value) {
    for (const char* type : {"int", "float"}) {
        const std::string head = "const " + std::string(type) + " " + name + " = ";
        const std::size_t at = text.find(head);
        if (at == std::string::npos) continue;
        const bool whole = type == std::string("int") || value.find_first_of(".e") != std::string::npos;
        text.replace(at + head.size(), text.find(';', at) - at - head.size(), whole ? value : value + ".0");
        return true;
    }
    return false;
}

// The value of an option as a number in the shader: for a choice, its place among the choices.
std::string constantOf(const OptionDescription& option, const std::string& text) {
    if (option.kind == OptionKind::Choice) {
        const auto at = std::find(option.choices.begin(), option.choices.end(), text);
        return std::to_string(at - option.choices.begin());
    }
    // Written anew: "1e2" is no integer for a compiler.
    const double number = parseNumber(text, option.name);
    return option.kind == OptionKind::Integer ? std::to_string(static_cast<int>(number))
                                              : MessageValue("", number).text;
}

const FixedOption* fixedOption(const std::string& tracer, const std::string& option) {
    const auto found = std::find_if(std::begin(kFixed), std::end(kFixed), [&](const FixedOption& fixed) {
        return fixed.tracer == tracer && fixed.option == option;
    });
    return found == std::end(kFixed) ? nullptr : found;
}

// The value of an option. Throws InputError if the shader does not exist for it.
std::string checkedValue(const MethodChoice& choice, const MethodDescription& method, const std::string& option) {
    const auto given = choice.options.find(option);
    const bool isGiven = given != choice.options.end();
    const FixedOption* fixed = fixedOption(choice.name, option);
    if (fixed == nullptr) return isGiven ? given->second : method.defaults.at(option);
    std::string value(fixed->value);
    if (!isGiven || given->second == value) return value;
    throw InputError("--set " + option, Message(MessageId::ShaderOptionFixed,
                                                {{"method", choice.name}, {"option", option}, {"value", value}}));
}

const ShaderText& findShader(const ShaderChoice& choice) {
    const std::vector<ShaderText>& all = shaderTexts();
    const std::string& name = choice.method.name;
    const auto found = std::find_if(all.begin(), all.end(), [&](const ShaderText& one) { return one.tracer == name; });
    if (found == all.end()) {
        throw InputError("--tracer",
                         Message(MessageId::ShaderMissing, {{"method", name}, {"known", commaList(shaderTracers())}}));
    }
    if (choice.language == ShaderLanguage::Hlsl && found->hlsl.empty()) {
        throw InputError("--lang", Message(MessageId::ShaderNoHlsl));
    }
    return *found;
}

}  // namespace

ShaderLanguage parseShaderLanguage(std::string_view text, const std::string& option) {
    for (const ShaderLanguage language : {ShaderLanguage::Glsl, ShaderLanguage::Hlsl}) {
        if (text == shaderLanguageName(language)) return language;
    }
    throw InputError(option, unknownName({"what", MessageId::WordShaderLanguage}, std::string(text), "glsl, hlsl"));
}

std::string_view shaderLanguageName(ShaderLanguage language) {
    return language == ShaderLanguage::Glsl ? "glsl" : "hlsl";
}

ShaderInterpolation parseShaderInterpolation(std::string_view text, const std::string& option) {
    for (const auto interpolation : {ShaderInterpolation::Sampler, ShaderInterpolation::Float}) {
        if (text == shaderInterpolationName(interpolation)) return interpolation;
    }
    throw InputError(option, unknownName({"what", MessageId::WordValue}, std::string(text), "float, sampler"));
}

std::string_view shaderInterpolationName(ShaderInterpolation interpolation) {
    return interpolation == ShaderInterpolation::Sampler ? "sampler" : "float";
}

void setConeUnit(ShaderChoice& choice, std::string_view text, const std::string& option) {
    choice.texelSlopes = text == kTexelSlope;
    if (choice.texelSlopes) return;
    std::vector<std::string> known;
    for (const ConeUnit unit : kConeUnits) {
        choice.cones.unit = unit;
        if (text == coneUnitName(unit)) return;
        known.emplace_back(coneUnitName(unit));
    }
    known.emplace_back(kTexelSlope);
    throw InputError(option, unknownName({"what", MessageId::WordValue}, std::string(text), commaList(known)));
}

std::vector<std::string> shaderTracers() {
    std::vector<std::string> names;
    for (const ShaderText& one : shaderTexts()) names.push_back(one.tracer);
    return names;
}

bool readsCones(const std::string& tracer) {
    return std::ranges::any_of(shaderTexts(), [&](const ShaderText& one) {
        return one.tracer == tracer && one.glsl.find("CONE_UNIT") != std::string::npos;
    });
}

double shaderShadowBias(const MethodChoice& method) {
    if (method.name != "layers") return kShadowBias;
    // The hit lies up to one layer behind the surface, which must not shadow it.
    return std::max(kShadowBias, 1 / parseNumber(checkedValue(method, findTracer(method.name), "layers"), "layers"));
}

namespace {

// The shader below its opening comment, the command that makes it, and the options that only its map has.
struct Export {
    std::string text, command, ofMap;
};

Export exported(const ShaderChoice& choice, const ShaderText& shader, const MethodDescription& method) {
    Export made;
    auto& [text, command, ofMap] = made;
    text = choice.language == ShaderLanguage::Glsl ? shader.glsl : shader.hlsl;
    command = "relief export shader --tracer " + shader.tracer;
    for (const OptionDescription& option : method.options) {
        const std::string value = checkedValue(choice.method, method, option.name);
        if (choice.method.options.contains(option.name)) command += " --set " + option.name + "=" + value;
        if (setConstant(text, upperCase(option.name), constantOf(option, value))) continue;
        ofMap += (ofMap.empty() ? "" : ", ") + option.name + "=" + value;
    }
    setConstant(text, "SHADOW_BIAS", numberText(shaderShadowBias(choice.method)));
    const auto set = [&](const char* constant, const char* option, std::size_t index, std::string_view name) {
        if (setConstant(text, constant, std::to_string(index))) command += std::string(option) + std::string(name);
    };
    const ConeCoding& cones = choice.cones;
    set("ADDRESS", " --address ", static_cast<std::size_t>(choice.address), addressName(choice.address));
    set("WHITE", " --white ", static_cast<std::size_t>(choice.white), heightWhiteName(choice.white));
    set("INTERPOLATION", " --interpolation ", static_cast<std::size_t>(choice.interpolation),
        shaderInterpolationName(choice.interpolation));
    if (choice.texelSlopes) {
        set("CONE_UNIT", " --unit ", kConeUnits.size(), kTexelSlope);
    } else {
        set("CONE_UNIT", " --unit ", static_cast<std::size_t>(cones.unit), coneUnitName(cones.unit));
    }
    set("CONE_LENGTH", " --length ", static_cast<std::size_t>(cones.length), coneLengthName(cones.length));
    const std::string scale = numberText(cones.scale);
    if (setConstant(text, "CONE_SCALE", scale)) command += " --cone-scale " + scale;
    command += " --lang " + std::string(shaderLanguageName(choice.language));
    return made;
}

}  // namespace

std::string shaderCommand(const ShaderChoice& choice) {
    const ShaderText& shader = findShader(choice);
    return exported(choice, shader, findTracer(shader.tracer)).command;
}

std::string shaderText(const ShaderChoice& choice, const std::string& made) {
    const ShaderText& shader = findShader(choice);
    const MethodDescription& method = findTracer(shader.tracer);
    const auto [text, command, ofMap] = exported(choice, shader, method);
    std::string opening = "// " + shader.tracer + ", " + method.title + " (" + method.source + "): " + method.help +
                          "\n// Made by " + made + ": " + command + "\n//\n" + shader.header;
    if (!method.maps.empty()) {
        opening += "// Map: relief map " + method.maps.front() + (ofMap.empty() ? "" : " with " + ofMap) + ".\n";
    }
    return opening + text;
}

}  // namespace relief
