#include "manual.h"

#include <filesystem>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "relief/errors.h"
#include "relief/files.h"

namespace relief::app {

namespace {

void writeManual(const CLI::App& program, const std::filesystem::path& folder) {
    std::error_code error;
    for (const char* part : {"man1", "completions"}) {
        std::filesystem::create_directories(folder / part, error);
        if (error)
            throw WorkError((folder / part).string(), Message(MessageId::FileUnwritable, {{"why", error.message()}}));
    }
    const auto page = [&](const std::string& name, const std::string& text) {
        writeTextFile((folder / "man1" / (name + ".1")).string(), text);
    };
    page(program.get_name(), manPage(program, program));
    for (const CLI::App* command : program.get_subcommands({})) {
        if (!command->get_group().empty())
            page(program.get_name() + "-" + command->get_name(), manPage(program, *command));
    }
    writeTextFile((folder / "completions" / program.get_name()).string(), bashCompletion(program));
    const std::filesystem::path window = folder / "reliefscope.help";
    if (!std::filesystem::exists(window)) return;
    const std::string help = readTextFile(window.string());
    page("reliefscope", manPage(help));
    writeTextFile((folder / "completions" / "reliefscope").string(), bashCompletion(help));
}

}  // namespace

void addManual(CLI::App& program) {
    const auto write = [&program](const std::string& folder) {
        writeManual(program, folder);
        throw CLI::Success();
    };
    // Options without a group do not appear in the help.
    program.add_option_function<std::string>("--manual", write, "")->group("");
}

}  // namespace relief::app
