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
constexpr std::array kConeUnitNames{"slope", "ratio", "sqrt"};
constexpr std::array kLanguageNames{"glsl", "hlsl"};

// Returns the index of the name. Throws InputError.
template <std::size_t kCount>
std::size_t indexOf(const std::array<const char*, kCount>& names, std::string_view text, MessageId what,
                    const std::string& option) {
    for (std::size_t i = 0; i < kCount; ++i) {
        if (text == names[i]) return i;
    }
    throw InputError(option, unknownName({"what", what}, std::string(text), commaList({names.begin(), names.end()})));
}

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
    return static_cast<ShaderLanguage>(indexOf(kLanguageNames, text, MessageId::WordShaderLanguage, option));
}

std::string_view shaderLanguageName(ShaderLanguage language) {
    return kLanguageNames[static_cast<std::size_t>(language)];
}

ConeUnits parseConeUnits(std::string_view text, const std::string& option) {
    return static_cast<ConeUnits>(indexOf(kConeUnitNames, text, MessageId::WordConeUnits, option));
}

std::vector<std::string> shaderTracers() {
    std::vector<std::string> names;
    for (const ShaderText& one : shaderTexts()) names.push_back(one.tracer);
    return names;
}

bool readsCones(const std::string& tracer) {
    return std::ranges::any_of(shaderTexts(), [&](const ShaderText& one) {
        return one.tracer == tracer && one.glsl.find("CONE_UNITS") != std::string::npos;
    });
}

std::string shaderText(const ShaderChoice& choice, const std::string& made) {
    const ShaderText& shader = findShader(choice);
    const std::string& tracer = shader.tracer;
    const MethodDescription& method = findTracer(tracer);
    std::string text = choice.language == ShaderLanguage::Glsl ? shader.glsl : shader.hlsl;
    std::string command = "relief export shader --tracer " + tracer;
    std::string ofMap;
    for (const OptionDescription& option : method.options) {
        const auto given = choice.method.options.find(option.name);
        std::string value = given == choice.method.options.end() ? method.defaults.at(option.name) : given->second;
        if (const FixedOption* fixed = fixedOption(tracer, option.name)) {
            if (given != choice.method.options.end() && value != fixed->value) {
                throw InputError(
                    "--set " + option.name,
                    Message(MessageId::ShaderOptionFixed,
                            {{"method", tracer}, {"option", option.name}, {"value", std::string(fixed->value)}}));
            }
            value = fixed->value;
        }
        if (given != choice.method.options.end()) command += " --set " + option.name + "=" + value;
        if (setConstant(text, upperCase(option.name), constantOf(option, value))) continue;
        ofMap += (ofMap.empty() ? "" : ", ") + option.name + "=" + value;
    }
    // The hit of layers lies up to one layer behind the surface, which must not shadow it.
    if (tracer == "layers") {
        const auto given = choice.method.options.find("layers");
        const std::string& layers = given == choice.method.options.end() ? method.defaults.at("layers") : given->second;
        setConstant(text, "SHADOW_BIAS", numberText(std::max(kShadowBias, 1 / parseNumber(layers, "layers"))));
    }
    setConstant(text, "ADDRESS", std::to_string(static_cast<int>(choice.address)));
    command += " --address " + std::string(addressName(choice.address));
    if (setConstant(text, "CONE_UNITS", std::to_string(static_cast<int>(choice.coneUnits)))) {
        command += " --cone-units " + std::string(kConeUnitNames[static_cast<std::size_t>(choice.coneUnits)]);
    }
    command += " --lang " + std::string(shaderLanguageName(choice.language));
    std::string opening = "// " + method.title + " (" + method.source + "): " + method.help + "\n// Made by " + made +
                          ": " + command + "\n//\n" + shader.header;
    if (!method.maps.empty()) {
        opening += "// Map: relief map " + method.maps.front() + (ofMap.empty() ? "" : " with " + ofMap) + ".\n";
    }
    return opening + text;
}

}  // namespace relief
