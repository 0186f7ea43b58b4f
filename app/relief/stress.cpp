// relief stress [--seconds N] [--seed S] [--tracers NAME,...] [--parts NAME,...] [--case N] [-o FOLDER]
#include <unistd.h>

#include <filesystem>

#include "measuring/stress.h"
#include "options_common.h"
#include "output.h"

namespace relief::app {

namespace {

constexpr int kViolated = 1;
constexpr double kSecondsAtMost = 30.0 * 24 * 3600;

struct StressCommandOptions {
    OptionText seconds, seed, folder, tracers, parts, only;
    RunOptions run;
};

double parseSeconds(const std::string& text) {
    const double seconds = parseNumber(text, "--seconds");
    if (!(seconds >= 0 && seconds <= kSecondsAtMost)) {
        throw InputError("--seconds", Message(MessageId::NumberOutOfRange,
                                              {{"value", text}, {"range", "0 to " + numberText(kSecondsAtMost)}}));
    }
    return seconds;
}

// Only these methods, in the forms given; a plain name stands for all its forms.
std::vector<MeasuredMethod> chosenMethods(const std::string& text) {
    std::vector<MeasuredMethod> chosen;
    for (const std::string& part : splitText(text, ',')) {
        const MethodChoice choice = parseMethodChoice(part, "--tracers");
        if (!choice.options.empty()) {
            chosen.push_back(measuredMethod(choice));
            continue;
        }
        for (MeasuredMethod& method : methodVariants()) {
            if (method.choice.name == choice.name) chosen.push_back(std::move(method));
        }
    }
    return chosen;
}

int runStress(const StressCommandOptions& given, Session& session) {
    given.run.apply(session);
    StressOptions options;
    if (given.seconds) options.seconds = parseSeconds(*given.seconds);
    if (given.seed) options.seed = parseSeed(*given.seed, "--seed");
    if (given.tracers) options.methods = chosenMethods(*given.tracers);
    if (given.parts) {
        for (const std::string& part : splitText(*given.parts, ',')) {
            options.parts.insert(parseStressPart(part, "--parts"));
        }
    }
    if (given.only) options.only = parseSeed(*given.only, "--case");
    if (given.folder) {
        options.folder = *given.folder;
        if (!std::filesystem::is_directory(options.folder)) {
            throw WorkError(options.folder, Message(MessageId::OutputFolderMissing, {{"folder", options.folder}}));
        }
    }
    options.onHang = [&session, &options](const StressViolation& violation) {
        sayLine(
            sentence(Message(MessageId::StressHang, {{"seconds", options.hangSeconds}, {"command", violation.command}}),
                     session.language()));
        // The tracer holds its thread: nothing can be ended in order.
        _exit(kViolated);
    };
    const StressReport report = stress(options, session.work());
    session.eraseBar();
    // Interrupted, what was covered is still worth reading.
    writeStandardOutput(stressText(report, options.seed));
    if (report.violationCount > 0) {
        sayLine(sentence(Message(MessageId::StressViolations, {{"count", report.violationCount}}), session.language()));
        return kViolated;
    }
    if (report.interrupted) throw Cancelled();
    return 0;
}

}  // namespace

void addStressCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<StressCommandOptions>();
    CLI::App* parser = addCommand(
        program, "stress", "look for rays, cameras and maps that break a promise",
        "Runs every tracer, with its options at their ends, over maps and rays that are hard to get right (grazing to "
        "the domain's limit and beyond, along and through cell borders, huge and denormal numbers, far starts, "
        "plateaus at the ray's height, spikes, sizes from 1 x 1 to 65536 x 2) and holds each to what it promises: no "
        "NaN, no more steps than stated, no miss where nothing can be missed, exact methods bit for bit, conservative "
        "ones never too late, the same answer with and without a log. Any-hit queries must agree with the exact hits "
        "of these rays. Small frames over the same maps, by extreme cameras (grazing, in a polygon's plane, very near, "
        "very far, narrow and wide), with every filter, with and without shadows, must be finite and the same with and "
        "without --no-skip, and by one thread and by several. The homographies of such cameras must lead from pixel to "
        "texel and back, and their derivatives agree with central differences; row methods must stay within their "
        "error bounds. The cases depend on the seed alone. Each violation is a line that ends with the command "
        "that shows it; the exit status is then 1.",
        "  relief stress --seconds 60 --seed 7");
    addText(*parser, "--seconds", options->seconds, "N", "how long, default 20", "Run");
    addText(*parser, "--seed", options->seed, "S", "of maps and rays, default 1", "Run");
    addText(*parser, "--tracers", options->tracers, "NAME,...",
            "only these methods for view rays, and in frames where they apply (elsewhere the standard method); "
            "any-hit queries and rows are always all; NAME:OPTION=VALUE for one form of a method; default: all in all "
            "forms",
            "Run");
    addText(*parser, "--parts", options->parts, "NAME,...",
            "only these parts of each case: tracers, any-hit, frames, homographies, rows; default: all", "Run");
    addText(*parser, "--case", options->only, "N", "the case of this number alone, as a violation names it", "Run");
    addText(*parser, "-o,--output", options->folder, "FOLDER",
            "where maps that no recipe makes are written if they break a tracer; default: here", "Output");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runStress(*options, session); }});
}

}  // namespace relief::app
