#include "program.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <sstream>
#include <stop_token>
#include <thread>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "help_formatter.h"
#include "manual.h"
#include "options_common.h"
#include "output.h"
#include "session.h"
#include "signals.h"
#include "team.h"

namespace relief::app {

namespace {

constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kBadUsage = 2;

// The language is needed before anything can go wrong.
Language chosenLanguage(int count, char** arguments) {
    std::string name;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--language" && i + 1 < count) name = arguments[i + 1];
        if (argument.starts_with("--language=")) name = argument.substr(std::strlen("--language="));
    }
    if (name.empty() || name == "en") return Language::English;
    if (name == "uk") return Language::Ukrainian;
    throw InputError("--language", Message(MessageId::UnknownName,
                                           {{"what", MessageId::WordLanguage}, {"name", name}, {"known", "en, uk"}}));
}

std::string helpCommand(const CLI::App& program) {
    const auto parsed = program.get_subcommands();
    return "relief " + (parsed.empty() ? "" : parsed.front()->get_name() + " ") + "--help";
}

// CLI11's exceptions in our words.
InputError usageError(const CLI::App& program, const Commands& commands, const CLI::ParseError& error) {
    const MessageValue help("help", helpCommand(program));
    const std::string text = error.what();
    const std::string option = text.substr(0, text.find(':'));
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        const auto left = program.remaining(true);
        const std::string argument = left.empty() ? text : left.front();
        if (program.get_subcommands().empty() && !argument.starts_with("-")) {
            std::string known;
            for (const Command& command : commands) known += (known.empty() ? "" : ", ") + command.parser->get_name();
            return InputError("", Message(MessageId::UnknownName,
                                          {{"what", MessageId::WordCommand}, {"name", argument}, {"known", known}}));
        }
        return InputError(argument, Message(MessageId::ArgumentUnknown, {help}));
    }
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        const bool missing = text.find("missing") != std::string::npos;
        return InputError(option,
                          missing ? Message(MessageId::ValueMissing, {help}) : Message(MessageId::ArgumentRepeated));
    }
    return InputError("", Message(MessageId::ArgumentWrong, {{"why", text}}));
}

void buildParser(CLI::App& program, Commands& commands) {
    setHelpFormatter(program);
    program.set_help_flag("-h,--help", "this page")->group("General");
    // Once a command is chosen, the names of the others are ordinary words (a file may be called "list").
    program.require_subcommand(0, 1);
    program.set_version_flag("--version", "relief " RELIEF_VERSION, "name and version")->group("General");
    addLanguage(program);
    program.footer(
        "Examples:\n  relief make bricks -o bricks.png\n  relief render --height bricks.png --scene wall -o wall.png\n"
        "  relief trace --height bricks.png --pixel 400,300\n\nrelief COMMAND --help tells all about one command.\n"
        "Exit status: 0 done, 1 the work failed, 2 bad usage or input, or more memory needed than is free, with one "
        "line that says why.");
    addInfoCommand(program, commands);
    addMakeCommand(program, commands);
    addListCommand(program, commands);
    addMapCommand(program, commands);
    addRenderCommand(program, commands);
    addTraceCommand(program, commands);
    addCompareCommand(program, commands);
    addBenchCommand(program, commands);
    addStressCommand(program, commands);
    addCertifyCommand(program, commands);
    addRecommendCommand(program, commands);
    addClaimsCommand(program, commands);
    addMergeCommand(program, commands);
    addManual(program);
}

int parseAndRun(int count, char** arguments, Session& session) {
    CLI::App program{
        "Relief texturing on height maps, every step shown.\nView rays are traced into a relief that lies under the "
        "polygon's plane: render pictures, trace single rays and see each decision on their way, compare methods.",
        "relief"};
    Commands commands;
    buildParser(program, commands);
    try {
        program.parse(count, arguments);
    } catch (const CLI::Success& success) {  // --help, --version
        std::ostringstream page;
        program.exit(success, page, page);
        writeStandardOutput(page.str(), session.stop());
        return kDone;
    } catch (const CLI::ParseError& error) {
        throw usageError(program, commands, error);
    }
    for (const Command& command : commands) {
        if (command.parser->parsed()) return command.run(session);
    }
    throw InputError("", Message(MessageId::CommandMissing));
}

// Whether this process works on a part of its own, without those that were started with it.
bool worksAlone(int count, char** arguments) {
    return std::any_of(arguments, arguments + count, [](const std::string_view argument) {
        return argument == "--part" || argument.starts_with("--part=");
    });
}

// Of several processes that share a run all may meet the same error: rank 0 reports it.
void sayFailure(const std::string& why, Language language, const std::stop_token& stop, bool alone) {
    if (leadsRun(alone)) return sayLine(why);
    std::this_thread::sleep_for(kLastWords);
    if (stop.stop_requested()) return;
    sayLine(sentence(Message(MessageId::RankFailed, {{"rank", launchedRank()}, {"host", hostName()}, {"why", why}}),
                     language));
}

}  // namespace

int runProgram(int count, char** arguments) {
    const SignalWatch signals;
    Language language = Language::English;
    const auto failed = [&](const std::string& why, int status) {
        sayFailure(why, language, signals.stop(), worksAlone(count, arguments));
        return status;
    };
    try {
        language = chosenLanguage(count, arguments);
        Session session(language, signals.stop());
        return parseAndRun(count, arguments, session);
    } catch (const Cancelled&) {
        return signals.exitStatus();
    } catch (const RunEnded& ended) {
        return ended.status;
    } catch (const WorkError& error) {
        return failed(error.text(language), kFailed);
    } catch (const InputError& error) {
        return failed(error.text(language), kBadUsage);
    } catch (const std::bad_alloc&) {
        return failed(sentence(Message(MessageId::OutOfMemory), language), kBadUsage);
    } catch (const std::exception& error) {
        return failed(sentence(Message(MessageId::InternalError, {{"why", error.what()}}), language), kFailed);
    }
}

}  // namespace relief::app
