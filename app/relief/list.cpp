// relief list [NAME] [--json]
#include <algorithm>
#include <nlohmann/json.hpp>

#include "filtering/filters/filter_choice.h"
#include "help_formatter.h"
#include "map_engine.h"
#include "options_common.h"
#include "output.h"
#include "relief/maps/pyramid_files.h"
#include "relief/reliefs.h"
#include "relief/shaders/shader_export.h"
#include "relief/tracers/form_note.h"
#include "relief/tracers/map_choice.h"
#include "relief/visibility/any_hit.h"
#include "scenario/row_methods.h"
#include "scenario/variation.h"

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

bool hasShader(const MethodDescription& method) {
    const std::vector<std::string> names = shaderTracers();
    return std::find(names.begin(), names.end(), method.name) != names.end();
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

// Returns the option that names an inner method, whose guarantee the method has; nullptr: there is none.
const OptionDescription* innerOption(const MethodDescription& method) {
    const auto found = std::find_if(method.options.begin(), method.options.end(),
                                    [](const OptionDescription& option) { return option.kind == OptionKind::Method; });
    return found == method.options.end() ? nullptr : &*found;
}

// Returns the guarantee of the method with its default options.
Guarantee defaultGuarantee(const MethodDescription& method) {
    const OptionDescription* inner = innerOption(method);
    return inner == nullptr ? method.guarantee : findTracer(method.defaults.at(inner->name)).guarantee;
}

std::string guaranteeText(const MethodDescription& method) {
    const OptionDescription* inner = innerOption(method);
    return std::string(guaranteeName(defaultGuarantee(method))) +
           (inner == nullptr ? "" : ", that of its inner method " + method.defaults.at(inner->name));
}

Json methodJson(const MethodDescription& method) {
    Json json{{"name", method.name},
              {"title", method.title},
              {"help", method.help},
              {"source", method.source},
              {"kind", methodKindName(method.kind)},
              {"guarantee", guaranteeName(defaultGuarantee(method))},
              {"rays", rayClassName(method.rayClass)},
              {"surfaces", Json::array()},
              {"addresses", Json::array()},
              {"maps", method.maps},
              {"tiled", method.tiled},
              {"shader", hasShader(method)},
              {"options", Json::array()}};
    for (const Surface surface : method.surfaces) json["surfaces"].push_back(surfaceName(surface));
    for (const Address address : method.addresses) json["addresses"].push_back(addressName(address));
    for (const OptionDescription& option : method.options) {
        json["options"].push_back(optionJson(option, method.defaults.at(option.name)));
    }
    if (method.kind != MethodKind::AnyHit) {
        json["form"] = formName(methodForm({method.name, {}}));
        if (const std::string note = formNote(method.name); !note.empty()) json["form_note"] = note;
    }
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

Json listJson() {
    Json json{{"version", RELIEF_VERSION}};
    for (const MethodDescription& method : tracerList()) json["tracers"].push_back(methodJson(method));
    for (const MethodDescription& method : anyHitList()) json["any_hit"].push_back(methodJson(method));
    for (const RowMethodDescription& method : rowMethodList()) json["rows"].push_back(rowMethodJson(method));
    for (const FilterDescription& filter : filterList()) {
        Json entry{{"name", filter.name},
                   {"title", filter.title},
                   {"help", filter.help},
                   {"source", filter.source},
                   {"options", Json::array()}};
        for (const OptionDescription& option : filter.options) {
            entry["options"].push_back(optionJson(option, filter.defaults.at(option.name)));
        }
        json["filters"].push_back(entry);
    }
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        json["reliefs"].push_back({{"name", recipe.name},
                                   {"title", recipe.title},
                                   {"help", recipe.help},
                                   {"default_size", recipe.defaultSize},
                                   {"any_size", recipe.anySize}});
    }
    for (const ScenarioNumber& number : scenarioNumbers()) {
        json["numbers"].push_back(optionJson(number.description, number.get(Scenario{})));
    }
    for (const std::string& kind : mapKinds()) json["maps"].push_back({{"name", kind}, {"tracer", methodOfMap(kind)}});
    for (const std::string& kind : pyramidMapKinds()) json["maps"].push_back({{"name", kind}});
    for (const std::string& kind : engineOnlyKinds()) json["maps"].push_back({{"name", kind}});
    for (const NamedConvention& one : namedConventions()) {
        const EngineConventions& c = one.conventions;
        json["conventions"].push_back({{"name", one.name},
                                       {"help", one.summary},
                                       {"pack", enginePackText(c.channels)},
                                       {"unit", coneUnitName(c.cone.unit)},
                                       {"relaxed", c.relaxed}});
    }
    json["layers"] = layerNames();
    return json;
}

// Returns "name          text", with the text wrapped in a column to the right of the name.
std::string entry(const std::string& name, const std::string& text, std::size_t indent, std::size_t width) {
    std::string out = std::string(indent, ' ') + name;
    out.resize(std::max(out.size() + 2, indent + width), ' ');
    // If the name is too long for its column, the text begins on the next line.
    if (name.size() + 2 > width) out = std::string(indent, ' ') + name + "\n" + std::string(indent + width, ' ');
    const std::string lines = wrapped(text, kColumns - indent - width);
    for (const char c : lines) {
        out += c;
        if (c == '\n') out += std::string(indent + width, ' ');
    }
    return out + "\n";
}

std::string optionText(const OptionDescription& option, const std::string& defaultValue) {
    const std::string names = commaList(option.choices);
    const std::string values =
        isNumber(option) ? ", " + rangeText(option) + (names.empty() ? "" : " or " + names) : " [" + names + "]";
    return option.help + values + ", default " + defaultValue;
}

std::string methodText(const MethodDescription& method) {
    std::vector<std::string> surfaces;
    for (const Surface surface : method.surfaces) surfaces.emplace_back(surfaceName(surface));
    std::string out = entry(method.name, method.title + ". " + method.help, 2, 4);
    out += entry("guarantee", guaranteeText(method), 6, 12);
    if (method.kind != MethodKind::AnyHit) {
        const std::string note = formNote(method.name);
        out += entry("form", std::string(formName(methodForm({method.name, {}}))) + (note.empty() ? "" : ". " + note),
                     6, 12);
    }
    out += entry("surfaces", commaList(surfaces), 6, 12);
    std::vector<std::string> addresses;
    for (const Address address : method.addresses) addresses.emplace_back(addressName(address));
    if (addresses.size() < 3) out += entry("addressing", commaList(addresses), 6, 12);
    out += entry("rays", std::string(rayClassName(method.rayClass)), 6, 12);
    if (!method.maps.empty()) out += entry("maps", commaList(method.maps), 6, 12);
    if (method.tiled) out += entry("tiles", "maps larger than memory, by --memory", 6, 12);
    if (hasShader(method)) out += entry("shader", "GLSL and HLSL, by relief export shader", 6, 12);
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

// A section of the list: its heading, and the name and lines of each entry.
struct Section {
    std::string name;  // as `relief list NAME` takes it
    std::string key;   // in the JSON output
    std::string heading;
    std::vector<std::pair<std::string, std::string>> entries;
};

Section tracerSection(const std::string& name, const std::string& heading, MethodKind kind) {
    const std::string key = kind == MethodKind::AnyHit ? "any_hit" : "tracers";
    Section section{name, key, heading, {}};
    for (const MethodDescription& method : kind == MethodKind::AnyHit ? anyHitList() : tracerList()) {
        if (method.kind == kind) section.entries.emplace_back(method.name, methodText(method));
    }
    return section;
}

std::string filterText(const FilterDescription& filter) {
    std::string out = entry(filter.name, filter.help, 2, 14);
    if (!filter.source.empty()) out += entry("source", filter.source, 6, 12);
    // Includes the options of supersampling, which are written after its name.
    const MethodDescription described = describedVariation(CompareSubject::Filters, {filter.name, {}});
    const std::string prefix = filter.name == kSupersample ? ":" : "--filter-set ";
    for (const OptionDescription& option : described.options) {
        out += entry(prefix + option.name + "=..", optionText(option, described.defaults.at(option.name)), 6, 22);
    }
    return out;
}

std::string reliefText(const ReliefRecipe& recipe) {
    const std::string size = std::to_string(recipe.defaultSize) + " x " + std::to_string(recipe.defaultSize);
    const std::string sizes = recipe.anySize ? "any size, default " + size + "" : size + " only";
    return entry(std::string(recipe.name), std::string(recipe.help) + " (" + sizes + ")", 2, 14);
}

std::vector<Section> sections() {
    std::vector<Section> all;
    all.push_back(tracerSection("tracers",
                                "Tracers: methods that find where rays hit the relief (--tracer NAME:OPTION=VALUE)",
                                MethodKind::Tracer));
    all.push_back(
        tracerSection("shading", "Shading only: the ray stays on the polygon (--tracer NAME)", MethodKind::Shading));
    all.push_back(tracerSection("meshes", "Meshes: the relief as triangles (--tracer NAME)", MethodKind::Mesh));
    all.push_back(tracerSection(
        "any-hit", "Any-hit queries: tests whether anything blocks a segment, for shadows and back-tracing",
        MethodKind::AnyHit));
    Section maps{"maps", "maps", "Maps that can be stored (relief map KIND, --map FILE)", {}};
    for (const std::string& kind : mapKinds()) {
        maps.entries.emplace_back(
            kind, entry(kind, "used by the tracer " + methodOfMap(kind) + ", with whose options it is built", 2, 24));
    }
    for (const std::string& kind : pyramidMapKinds()) {
        maps.entries.emplace_back(kind, entry(kind, "for other programs, as a picture with MIP levels", 2, 24));
    }
    for (const std::string& kind : engineOnlyKinds()) {
        maps.entries.emplace_back(kind, entry(kind, "for engines only, as a picture (-o FILE.png)", 2, 24));
    }
    all.push_back(std::move(maps));
    Section conventions{"conventions",
                        "conventions",
                        "Conventions of maps for engines (relief map, relief certify --convention NAME)",
                        {}};
    for (const NamedConvention& one : namedConventions()) {
        conventions.entries.emplace_back(one.name, entry(one.name, one.summary, 2, 24));
    }
    all.push_back(std::move(conventions));
    Section rows{"rows",
                 "rows",
                 "Row methods: texture coordinates along a row (relief bench rows --variants NAME:OPTION=VALUE)",
                 {}};
    for (const RowMethodDescription& method : rowMethodList()) {
        rows.entries.emplace_back(method.name, rowMethodText(method));
    }
    all.push_back(std::move(rows));
    Section filters{"filters", "filters", "Filters: how colours are sampled (--filter NAME:OPTION=VALUE)", {}};
    for (const FilterDescription& filter : filterList()) filters.entries.emplace_back(filter.name, filterText(filter));
    all.push_back(std::move(filters));
    Section reliefs{"reliefs", "reliefs", "Reliefs: procedural height maps (relief make NAME, --relief NAME)", {}};
    for (const ReliefRecipe& recipe : reliefRecipes()) reliefs.entries.emplace_back(recipe.name, reliefText(recipe));
    all.push_back(std::move(reliefs));
    Section numbers{"numbers", "numbers", "Numbers of a view: unit, range, default", {}};
    for (const ScenarioNumber& number : scenarioNumbers()) {
        const std::string& name = number.description.name;
        numbers.entries.emplace_back(
            name, entry(name, optionText(number.description, numberText(number.get(Scenario{}))), 2, 18));
    }
    all.push_back(std::move(numbers));
    Section layers{"render-layers", "layers", "Layers of a picture (relief render --layers NAME,...)", {}};
    for (const std::string& name : layerNames()) layers.entries.emplace_back(name, "  " + name + "\n");
    all.push_back(std::move(layers));
    return all;
}

// Throws InputError: the name is neither a section nor an entry.
[[noreturn]] void failUnknown(const std::vector<Section>& all, const std::string& wanted) {
    std::vector<std::string> kinds, names;
    for (const Section& section : all) {
        kinds.push_back(section.name);
        for (const auto& entry : section.entries) names.push_back(entry.first);
    }
    names.insert(names.begin(), kinds.begin(), kinds.end());
    // All names would fill the screen, so the message lists the sections only.
    const MessageValue what("what", MessageId::WordListed), name("name", wanted), known("known", commaList(kinds));
    const std::string near = nearestName(wanted, names);
    throw InputError("", near.empty() ? Message(MessageId::UnknownName, {what, name, known})
                                      : Message(MessageId::UnknownNear, {what, name, {"near", near}, known}));
}

// name: a section or an entry of any section; empty: everything.
std::string listText(const std::string& wanted) {
    const std::vector<Section> all = sections();
    std::string out;
    for (const Section& section : all) {
        std::string text;
        for (const auto& [name, lines] : section.entries) {
            if (wanted.empty() || wanted == section.name || wanted == name) text += lines;
        }
        if (!text.empty()) out += (out.empty() ? "" : "\n") + section.heading + "\n" + text;
    }
    if (out.empty()) failUnknown(all, wanted);
    return out;
}

// Returns the same selection as JSON.
std::string listJson(const std::string& wanted) {
    const Json all = listJson();
    if (wanted.empty()) return all.dump(2) + "\n";
    Json chosen = Json::object();
    for (const Section& section : sections()) {
        for (const auto& entry : section.entries) {
            if (wanted != section.name && wanted != entry.first) continue;
            for (const Json& one : all.at(section.key)) {
                const Json& name = one.is_object() ? one.at("name") : one;
                if (name == entry.first) chosen[section.key].push_back(one);
            }
        }
    }
    if (chosen.empty()) failUnknown(sections(), wanted);
    return chosen.dump(2) + "\n";
}

}  // namespace

void addListCommand(CLI::App& program, Commands& commands) {
    struct ListOptions {
        OptionText name;
        bool json = false;
        RunOptions run;
    };
    auto options = std::make_shared<ListOptions>();
    CLI::App* parser =
        addCommand(program, "list", "list tracers, maps, row methods, filters and reliefs with their options",
                   "Lists every tracer with its guarantee, the surfaces and rays for which it is valid, the maps that "
                   "it needs, and its options with unit, range and default; then maps, row methods with their "
                   "operations per pixel, filters, procedural reliefs, the numbers of a view and the layers of a "
                   "picture. With a name, lists only the entries of that name.",
                   "  relief list cone\n"
                   "  relief list filters\n"
                   "  relief list --json | less");
    addText(*parser, "NAME", options->name, "",
            "name of a tracer, map, row method, filter, relief or number, or a kind: tracers, shading, meshes, "
            "any-hit, maps, rows, filters, reliefs, numbers, render-layers",
            "Arguments");
    addFlag(*parser, "--json", options->json, "write JSON instead of text", "Output");
    options->run.add(*parser, false);
    commands.push_back({parser, [options](Session& session) {
                            options->run.apply(session);
                            const std::string name = options->name.value_or("");
                            writeStandardOutput(options->json ? listJson(name) : listText(name), session.stop());
                            return kDone;
                        }});
}

}  // namespace relief::app
