// relief list [--json]
#include <nlohmann/json.hpp>

#include "filtering/filters/filter_choice.h"
#include "help_formatter.h"
#include "options_common.h"
#include "output.h"
#include "relief/reliefs.h"
#include "relief/visibility/any_hit.h"
#include "scenario/row_methods.h"

namespace relief::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kColumns = 80;

std::string_view optionKindName(OptionKind kind) {
    switch (kind) {
        case OptionKind::Integer:
            return "integer";
        case OptionKind::Real:
            return "real";
        case OptionKind::Choice:
            return "choice";
        case OptionKind::Method:
            break;
    }
    return "method";
}

bool isNumber(const OptionDescription& option) {
    return option.kind == OptionKind::Integer || option.kind == OptionKind::Real;
}

Json optionJson(const OptionDescription& option, const Json& defaultValue) {
    Json json{{"name", option.name}, {"kind", optionKindName(option.kind)}, {"unit", option.unit}};
    if (isNumber(option)) {
        json["low"] = option.low;
        json["high"] = option.high;
        json["step"] = option.step;
    }
    if (!isNumber(option) || !option.choices.empty()) json["choices"] = option.choices;
    json["default"] = defaultValue;
    json["help"] = option.help;
    return json;
}

Json methodJson(const MethodDescription& method) {
    Json json{{"name", method.name},
              {"title", method.title},
              {"help", method.help},
              {"source", method.source},
              {"kind", methodKindName(method.kind)},
              {"guarantee", guaranteeName(method.guarantee)},
              {"rays", rayClassName(method.rayClass)},
              {"surfaces", Json::array()},
              {"addresses", Json::array()},
              {"maps", method.maps},
              {"options", Json::array()}};
    for (const Surface surface : method.surfaces) json["surfaces"].push_back(surfaceName(surface));
    for (const Address address : method.addresses) json["addresses"].push_back(addressName(address));
    for (const OptionDescription& option : method.options) {
        json["options"].push_back(optionJson(option, method.defaults.at(option.name)));
    }
    if (method.kind != MethodKind::AnyHit) json["form"] = formName(methodForm({method.name, {}}));
    return json;
}

Json rowMethodJson(const RowMethodDescription& method) {
    Json json{{"name", method.name},   {"title", method.title},   {"help", method.help},     {"counts", method.counts},
              {"paper", method.paper}, {"source", method.source}, {"options", Json::array()}};
    for (const OptionDescription& option : method.options) {
        json["options"].push_back(optionJson(option, method.defaults.at(option.name)));
    }
    return json;
}

std::string listJson() {
    Json json{{"version", RELIEF_VERSION}};
    for (const MethodDescription& method : tracerList()) json["tracers"].push_back(methodJson(method));
    for (const MethodDescription& method : anyHitList()) json["any_hit"].push_back(methodJson(method));
    for (const RowMethodDescription& method : rowMethodList()) json["rows"].push_back(rowMethodJson(method));
    for (const FilterDescription& filter : filterList()) {
        Json entry{{"name", filter.name}, {"help", filter.help}, {"source", filter.source}, {"options", Json::array()}};
        for (const OptionDescription& option : filter.options) {
            entry["options"].push_back(optionJson(option, filter.defaults.at(option.name)));
        }
        json["filters"].push_back(entry);
    }
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        json["reliefs"].push_back({{"name", recipe.name},
                                   {"help", recipe.help},
                                   {"default_size", recipe.defaultSize},
                                   {"any_size", recipe.anySize}});
    }
    for (const ScenarioNumber& number : scenarioNumbers()) {
        json["numbers"].push_back(optionJson(number.description, number.get(Scenario{})));
    }
    json["layers"] = layerNames();
    return json.dump(2) + "\n";
}

// "name          text", the text wrapped beside the name.
std::string entry(const std::string& name, const std::string& text, std::size_t indent, std::size_t width) {
    std::string out = std::string(indent, ' ') + name;
    out.resize(std::max(out.size() + 2, indent + width), ' ');
    // A name too long for its column has the text below it.
    if (name.size() + 2 > width) out = std::string(indent, ' ') + name + "\n" + std::string(indent + width, ' ');
    const std::string lines = wrapped(text, kColumns - indent - width);
    for (const char c : lines) {
        out += c;
        if (c == '\n') out += std::string(indent + width, ' ');
    }
    return out + "\n";
}

std::string optionText(const OptionDescription& option, const std::string& defaultValue) {
    std::string text = option.help;
    if (!option.unit.empty()) text += ", " + option.unit;
    text += isNumber(option) ? ", " + numberText(option.low) + " to " + numberText(option.high)
                             : ": " + commaList(option.choices);
    if (isNumber(option) && !option.choices.empty()) text += " or " + commaList(option.choices);
    return text + ", default " + defaultValue;
}

std::string methodText(const MethodDescription& method) {
    std::vector<std::string> surfaces;
    for (const Surface surface : method.surfaces) surfaces.emplace_back(surfaceName(surface));
    std::string out = entry(method.name, method.title + ". " + method.help, 2, 4);
    out += entry("guarantee", std::string(guaranteeName(method.guarantee)), 6, 12);
    if (method.kind != MethodKind::AnyHit) {
        out += entry("form", std::string(formName(methodForm({method.name, {}}))), 6, 12);
    }
    out += entry("surfaces", commaList(surfaces), 6, 12);
    std::vector<std::string> addresses;
    for (const Address address : method.addresses) addresses.emplace_back(addressName(address));
    if (addresses.size() < 3) out += entry("addressing", commaList(addresses), 6, 12);
    out += entry("rays", std::string(rayClassName(method.rayClass)), 6, 12);
    if (!method.maps.empty()) out += entry("maps", commaList(method.maps), 6, 12);
    if (!method.source.empty()) out += entry("source", method.source, 6, 12);
    for (const OptionDescription& option : method.options) {
        out += entry("--set " + option.name + "=..", optionText(option, method.defaults.at(option.name)), 6, 22);
    }
    return out;
}

std::string rowMethodText(const RowMethodDescription& method) {
    std::string out = entry(method.name, method.title + ". " + method.help, 2, 4);
    out += entry("mul / add / div", method.counts, 6, 18);
    if (!method.paper.empty()) out += entry("in the papers", method.paper, 6, 18);
    if (!method.source.empty()) out += entry("source", method.source, 6, 18);
    for (const OptionDescription& option : method.options) {
        out += entry(option.name + "=..", optionText(option, method.defaults.at(option.name)), 6, 18);
    }
    return out;
}

std::string listText() {
    const auto ofKind = [](MethodKind kind) {
        std::string text;
        for (const MethodDescription& method : tracerList()) {
            if (method.kind == kind) text += methodText(method);
        }
        return text;
    };
    std::string out = "Tracers: how rays meet the relief (--tracer NAME)\n" + ofKind(MethodKind::Tracer);
    out += "\nShading only: the ray stays on the polygon (--tracer NAME)\n" + ofKind(MethodKind::Shading);
    out += "\nMeshes: the relief made of triangles (--tracer NAME)\n" + ofKind(MethodKind::Mesh);
    out += "\nAny-hit queries: whether something is in the way, for shadows and back-tracing\n";
    for (const MethodDescription& method : anyHitList()) out += methodText(method);
    out += "\nRows: texture coordinates along a row (relief bench rows --variants NAME:OPTION=VALUE)\n";
    for (const RowMethodDescription& method : rowMethodList()) out += rowMethodText(method);
    out += "\nFilters: how colours are sampled (--filter NAME)\n";
    for (const FilterDescription& filter : filterList()) {
        out += entry(filter.name, filter.help, 2, 14);
        if (!filter.source.empty()) out += entry("source", filter.source, 6, 12);
        for (const OptionDescription& option : filter.options) {
            out += entry("--filter-set " + option.name + "=..", optionText(option, filter.defaults.at(option.name)), 6,
                         22);
        }
    }
    out += "\nReliefs: procedural height maps (relief make NAME, --relief NAME)\n";
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        const std::string size = std::to_string(recipe.defaultSize) + " x " + std::to_string(recipe.defaultSize);
        const std::string sizes = recipe.anySize ? "any size, " + size + " by itself" : size + " only";
        out += entry(std::string(recipe.name), std::string(recipe.help) + " (" + sizes + ")", 2, 14);
    }
    out += "\nNumbers of a view: unit, range, default\n";
    for (const ScenarioNumber& number : scenarioNumbers()) {
        out +=
            entry(number.description.name, optionText(number.description, numberText(number.get(Scenario{}))), 2, 18);
    }
    return out + "\nLayers of relief render --layers: " + commaList(layerNames()) + "\n";
}

}  // namespace

void addListCommand(CLI::App& program, Commands& commands) {
    struct ListOptions {
        bool json = false;
    };
    auto options = std::make_shared<ListOptions>();
    CLI::App* parser = addCommand(
        program, "list", "tracers, rows, filters, reliefs: guarantees, options, units",
        "Lists every tracer with what it promises, the surfaces and rays it is valid for, the maps it needs and its "
        "options with unit, range and default; then row variants with their operations a pixel, filters, procedural "
        "reliefs, the numbers of a view and the layers.",
        "  relief list --json | less");
    addFlag(*parser, "--json", options->json, "the same for programs", "Output");
    addLanguage(*parser);
    commands.push_back({parser, [options](Session& session) {
                            writeStandardOutput(options->json ? listJson() : listText(), session.stop());
                            return 0;
                        }});
}

}  // namespace relief::app
