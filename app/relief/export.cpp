// relief export KIND ... -o FILE
#include "export.h"

#include <algorithm>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace relief::app {

namespace {

// Throws InputError if an option was given that the kind does not take.
void refuseOthers(const CLI::App& parser, const ExportKind& kind, const std::vector<ExportKind>& kinds) {
    for (const CLI::Option* option : parser.get_options()) {
        const std::string name = option->get_name();
        const auto takes = [&](const ExportKind& one) {
            return std::find(one.options.begin(), one.options.end(), name) != one.options.end();
        };
        if (option->count() == 0 || option->get_group() == "General" || name == "KIND" || name == "--output") continue;
        if (takes(kind)) continue;
        std::string others;
        for (const ExportKind& one : kinds) {
            if (takes(one)) others += (others.empty() ? "relief export " : ", relief export ") + one.name;
        }
        const std::string given = option->get_positional() ? option->results().front() : name;
        if (others.empty()) {
            throw InputError(given, Message(MessageId::ArgumentUnknown, {{"help", "relief export --help"}}));
        }
        throw InputError(given, Message(MessageId::ArgumentOfOther,
                                        {{"others", others}, {"command", "relief export " + kind.name}}));
    }
}

int runExport(const ExportOptions& options, const std::vector<ExportKind>& kinds, const CLI::App& parser,
              Session& session) {
    options.run.apply(session);
    const std::string& name = needed(options.kind, "KIND", "export");
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const ExportKind& one) { return one.name == name; });
    if (found == kinds.end()) {
        std::string known;
        for (const ExportKind& one : kinds) known += (known.empty() ? "" : ", ") + one.name;
        throw InputError("", unknownName({"what", MessageId::WordExport}, name, known));
    }
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
    parser->get_option("KIND")->description(names);
    parser->description(help);
    parser->footer(examples);
    commands.push_back(
        {parser, [options, kinds, parser](Session& session) { return runExport(*options, *kinds, *parser, session); }});
}

}  // namespace relief::app
