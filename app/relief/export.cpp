// relief export KIND ... -o FILE
#include "export.h"

#include <algorithm>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace relief::app {

namespace {

// Returns true if the option belongs to every kind.
bool isCommon(const CLI::Option& option) {
    return option.get_group() == "General" || option.get_name() == "KIND" || option.get_name() == "--output";
}

bool takes(const ExportKind& kind, const CLI::Option& option) {
    return std::find(kind.options.begin(), kind.options.end(), option.get_name()) != kind.options.end();
}

// Removes the options that no kind takes.
void removeOthers(CLI::App& parser, const std::vector<ExportKind>& kinds) {
    for (CLI::Option* const option : parser.get_options([](const CLI::Option*) { return true; })) {
        const bool taken =
            std::any_of(kinds.begin(), kinds.end(), [&](const ExportKind& one) { return takes(one, *option); });
        if (!taken && !isCommon(*option)) parser.remove_option(option);
    }
}

// Throws InputError if an option was given that another kind takes.
void refuseOthers(const CLI::App& parser, const ExportKind& kind, const std::vector<ExportKind>& kinds) {
    for (const CLI::Option* option : parser.get_options()) {
        if (option->count() == 0 || isCommon(*option) || takes(kind, *option)) continue;
        std::vector<std::string> others;
        for (const ExportKind& one : kinds) {
            if (takes(one, *option)) others.push_back("relief export " + one.name);
        }
        throw InputError(option->get_positional() ? option->results().front() : option->get_name(),
                         Message(MessageId::ArgumentOfOther,
                                 {{"others", commaList(others)}, {"command", "relief export " + kind.name}}));
    }
}

int runExport(const ExportOptions& options, const std::vector<ExportKind>& kinds, const CLI::App& parser,
              Session& session) {
    options.run.apply(session);
    const std::string& name = needed(options.kind, "KIND", "export");
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const ExportKind& one) { return one.name == name; });
    if (found == kinds.end()) throw InputError("", unknownName({"what", MessageId::WordExport}, name, namesOf(kinds)));
    refuseOthers(parser, *found, kinds);
    return found->run(options, session);
}

}  // namespace

void addExportCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<ExportOptions>();
    const std::string summary = "write shaders, or the rays of a view, for programs of others";
    CLI::App* parser = addCommand(program, "export", summary, "", "");
    auto kinds = std::make_shared<std::vector<ExportKind>>();
    std::string names;
    addArgument(*parser, "KIND", options->kind, "");
    options->scenario.add(*parser, ScenarioOptions::OptionGroups::All);
    kinds->push_back(addShaderExport(*parser));
    kinds->push_back(addRaysExport(*parser));
    addOutput(*parser, options->output, "file to write; - (default): standard output");
    options->run.add(*parser, false);
    std::string help = summary, examples = "Example:";
    for (const ExportKind& kind : *kinds) {
        names += (names.empty() ? "" : " or ") + kind.name;
        help += "\n" + kind.help;
        examples += "\n" + kind.examples;
    }
    removeOthers(*parser, *kinds);
    parser->get_option("KIND")->description(names);
    parser->description(help);
    parser->footer(examples);
    commands.push_back(
        {parser, [options, kinds, parser](Session& session) { return runExport(*options, *kinds, *parser, session); }});
}

}  // namespace relief::app
