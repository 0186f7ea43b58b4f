// relief help [COMMAND]
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "options_common.h"
#include "output.h"

namespace relief::app {

namespace {

std::string helpPage(CLI::App& program, const OptionText& command) {
    if (!command) return program.get_formatter()->make_help(&program, program.get_name(), CLI::AppFormatMode::Normal);
    std::string known;
    for (CLI::App* const one : program.get_subcommands({})) {
        if (one->get_name() == *command) return one->help(program.get_name());
        known += (known.empty() ? "" : ", ") + one->get_name();
    }
    throw InputError("", unknownName({"what", MessageId::WordCommand}, *command, known));
}

}  // namespace

void addHelpCommand(CLI::App& program, Commands& commands) {
    auto command = std::make_shared<OptionText>();
    CLI::App* parser = addCommand(program, "help", "explain a command",
                                  "Prints the same page as relief COMMAND --help.", "  relief help render");
    addText(*parser, "COMMAND", *command, "", "command to explain; without it, all commands are listed", "Arguments");
    addLanguage(*parser);
    commands.push_back({parser, [command, &program](Session& session) {
                            writeStandardOutput(helpPage(program, *command), session.stop());
                            return kDone;
                        }});
}

}  // namespace relief::app
