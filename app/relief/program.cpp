#include "program.h"

#include <signal.h>

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

#include "base/part_file.h"
#include "help_formatter.h"
#include "manual.h"
#include "options_common.h"
#include "output.h"
#include "session.h"
#include "signals.h"
#include "stopped.h"
#include "team.h"

namespace relief::app {

namespace {

// The language must be known before any error can be reported.
Language chosenLanguage(int count, char** arguments) {
    std::string name;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--language" && i + 1 < count) name = arguments[i + 1];
        if (argument.starts_with("--language=")) name = argument.substr(std::strlen("--language="));
    }
    if (name.empty() || name == "en") return Language::English;
    if (name == "uk") return Language::Ukrainian;
    throw InputError("--language", unknownName({"what", MessageId::WordLanguage}, name, "en, uk"));
}

std::string helpCommand(const CLI::App& program) {
    const auto parsed = program.get_subcommands();
    return "relief " + (parsed.empty() ? "" : parsed.front()->get_name() + " ") + "--help";
}

// Returns true if the command has an option of this name.
bool hasOption(const CLI::App& command, const std::string& name) {
    return name.starts_with("-") && command.get_option_no_throw(name) != nullptr;
}

// An argument that the command does not know.
InputError unknownArgument(const CLI::App& program, const Commands& commands, const std::string& argument) {
    const auto parsed = program.get_subcommands();
    const CLI::App& command = parsed.empty() ? program : *parsed.front();
    if (parsed.empty() && !argument.starts_with("-")) {
        std::string known;
        for (const Command& one : commands) known += (known.empty() ? "" : ", ") + one.parser->get_name();
        return InputError("", unknownName({"what", MessageId::WordCommand}, argument, known));
    }
    const std::string name = argument.substr(0, argument.find('='));
    std::string others;
    for (const Command& one : commands) {
        if (hasOption(*one.parser, name)) others += (others.empty() ? "relief " : ", relief ") + one.parser->get_name();
    }
    if (!others.empty()) {
        const std::string here = parsed.empty() ? "relief" : "relief " + command.get_name();
        return InputError(name, Message(MessageId::ArgumentOfOther, {{"others", others}, {"command", here}}));
    }
    const MessageValue help("help", helpCommand(program));
    std::vector<std::string> known;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& word : option->get_lnames()) known.push_back("--" + word);
    }
    const std::string near = name.starts_with("--") ? nearestName(name, known) : "";
    if (near.empty()) return InputError(argument, Message(MessageId::ArgumentUnknown, {help}));
    return InputError(argument, Message(MessageId::ArgumentNear, {{"near", near}, help}));
}

// Translates CLI11's exceptions into the program's own messages.
InputError usageError(const CLI::App& program, const Commands& commands, const CLI::ParseError& error) {
    const MessageValue help("help", helpCommand(program));
    const std::string text = error.what();
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        const auto left = program.remaining(true);
        return unknownArgument(program, commands, left.empty() ? text : left.front());
    }
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        const std::string option = text.substr(0, text.find(':'));
        const bool missing = text.find("missing") != std::string::npos;
        return InputError(option,
                          missing ? Message(MessageId::ValueMissing, {help}) : Message(MessageId::ArgumentRepeated));
    }
    // CLI11's messages "--json excludes --check", "--step-cost requires --form".
    for (const auto& [word, id] :
         {std::pair(" excludes ", MessageId::ArgumentsExclude), std::pair(" requires ", MessageId::NeedsArgument)}) {
        const std::size_t at = text.find(word);
        if (at == std::string::npos) continue;
        return InputError(text.substr(0, at), Message(id, {{"other", text.substr(at + std::strlen(word))}}));
    }
    return InputError("", Message(MessageId::ArgumentWrong, {{"why", text}}));
}

void buildParser(CLI::App& program, Commands& commands) {
    setHelpFormatter(program);
    program.set_help_flag("-h,--help", "show this page and exit")->group("General");
    // After one command is chosen, the names of the others are ordinary arguments: a file may be called "list".
    program.require_subcommand(0, 1);
    program.set_version_flag("--version", "relief " RELIEF_VERSION, "show name and version and exit")->group("General");
    addLanguage(program);
    program.footer(
        "Examples:\n"
        "  relief make bricks -o bricks.png\n"
        "  relief render bricks.png --scene wall -o wall.png\n"
        "  relief trace bricks.png --pixel 400,300\n"
        "\n"
        "relief help COMMAND, or relief COMMAND --help, explains a command. relief list NAME describes a tracer, "
        "filter, map\n"
        "or relief.\n"
        "\n"
        "Exit status:\n"
        "  0    done\n"
        "  1    the work failed, or a check has found a violation (certify, compare --max-flip, recommend --check,\n"
        "       stress, merge of stress tests), or diagnose has found a fault\n"
        "  2    wrong usage, unusable input, or not enough memory\n"
        "  3    not decided: certify could neither prove nor refute that the map is safe, or diagnose does not know "
        "the\n"
        "       fault\n"
        "  129, 130, 143    ended by a hang-up, by Ctrl-C, by a request to terminate (128 + the signal's number);\n"
        "       141 if the reader of standard output has ended, as after | head\n"
        "With status 2, and with 1 unless a check explains itself on standard output, one line on standard error gives "
        "the\n"
        "reason.");
    addHelpCommand(program, commands);
    addInfoCommand(program, commands);
    addMakeCommand(program, commands);
    addListCommand(program, commands);
    addMapCommand(program, commands);
    addTileCommand(program, commands);
    addExportCommand(program, commands);
    addRenderCommand(program, commands);
    addTraceCommand(program, commands);
    addCompareCommand(program, commands);
    addBenchCommand(program, commands);
    addStressCommand(program, commands);
    addCertifyCommand(program, commands);
    addDiagnoseCommand(program, commands);
    addRecommendCommand(program, commands);
    addClaimsCommand(program, commands);
    addMergeCommand(program, commands);
    addManual(program);
}

// failed: set to the exit status of a command whose work fails.
int parseAndRun(int count, char** arguments, Session& session, int& failed) {
    CLI::App program{
        "Relief texturing on height maps, with every step shown.\n"
        "View rays are traced into a relief that lies below the polygon's plane. Render pictures, trace single rays "
        "and see each decision on their way, compare methods.",
        "relief"};
    Commands commands;
    buildParser(program, commands);
    try {
        program.parse(count, arguments);
    } catch (const CLI::Success& success) {  // thrown by --help and --version
        std::ostringstream page;
        program.exit(success, page, page);
        writeStandardOutput(page.str(), session.stop());
        return kDone;
    } catch (const CLI::ParseError& error) {
        throw usageError(program, commands, error);
    }
    for (const Command& command : commands) {
        if (!command.parser->parsed()) continue;
        failed = command.failed;
        return command.run(session);
    }
    throw InputError("", Message(MessageId::CommandMissing));
}

// Returns true if this process works on its own part, independently of other processes of the same launch.
bool worksAlone(int count, char** arguments) {
    return std::any_of(arguments, arguments + count, [](const std::string_view argument) {
        return argument == "--part" || argument.starts_with("--part=");
    });
}

// When several processes share a run, all may meet the same error; only rank 0 reports it.
void sayFailure(const std::string& why, Language language, const std::stop_token& stop, bool alone) {
    if (leadsRun(alone)) return sayLine(why);
    std::this_thread::sleep_for(kErrorGracePeriod);
    if (stop.stop_requested()) return;
    sayLine(sentence(Message(MessageId::RankFailed, {{"rank", launchedRank()}, {"host", hostName()}, {"why", why}}),
                     language));
}

// status: 128 + the signal's number.
void sayStopped(int status, Language language) {
    sayLine(sentence(Message(MessageId::StoppedBySignal, {{"signal", signalName(status)}}), language));
}

// Ends the process as if SIGPIPE had never been ignored.
int endByClosedPipe() {
    signal(SIGPIPE, SIG_DFL);
    raise(SIGPIPE);
    return 128 + SIGPIPE;
}

}  // namespace

int runProgram(int count, char** arguments) {
    const SignalWatch signals;
    Language language = Language::English;
    int failure = kFailed;
    const auto failed = [&](const std::string& why, int status) {
        sayFailure(why, language, signals.stop(), worksAlone(count, arguments));
        return status;
    };
    try {
        language = chosenLanguage(count, arguments);
        Session session(language, signals.stop());
        return parseAndRun(count, arguments, session, failure);
    } catch (const StopTold&) {
        return signals.exitStatus();
    } catch (const Cancelled&) {
        if (leadsRun(worksAlone(count, arguments))) sayStopped(signals.exitStatus(), language);
        return signals.exitStatus();
    } catch (const RunEnded& ended) {
        return ended.status;
    } catch (const OutputClosed&) {
        return endByClosedPipe();
    } catch (const WorkError& error) {
        return failed(error.text(language), failure);
    } catch (const InputError& error) {
        return failed(error.text(language), kBadUsage);
    } catch (const std::bad_alloc&) {
        try {
            return failed(sentence(Message(MessageId::OutOfMemory), language), kBadUsage);
        } catch (const std::bad_alloc&) {
            return sayMemoryEnded();
        }
    } catch (const std::exception& error) {
        return failed(sentence(Message(MessageId::InternalError, {{"why", error.what()}}), language), failure);
    }
}

}  // namespace relief::app
