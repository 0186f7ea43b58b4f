// relief stress [--seconds N | --cases N] [--seed S] [--tracers NAME,...] [--parts NAME,...] [--case N] [-o FOLDER]
//     [--record FILE.jsonl [--part K/N]]
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "measuring/verify/stress_record.h"
#include "options_common.h"
#include "output.h"
#include "part.h"
#include "parts_run.h"
#include "stopped.h"
#include "stress_report.h"
#include "team.h"

namespace relief::app {

namespace {

constexpr double kSecondsAtMost = 30.0 * 24 * 3600;
constexpr std::int64_t kCasesAtMost = 1'000'000'000;

struct StressCommandOptions {
    OptionText seconds, cases, seed, moreRays, folder, tracers, parts, only, record, part;
    bool oracle = false;
    RunOptions run;
};

double parseSeconds(const std::string& text) {
    const double seconds = parseNumber(text, "--seconds");
    if (!(seconds >= 0 && seconds <= kSecondsAtMost)) {
        throw InputError("--seconds", Message(MessageId::NumberOutOfRange,
                                              {{"value", text}, {"range", rangeOf(0.0, double{kSecondsAtMost})}}));
    }
    return seconds;
}

// Returns the listed methods, in the given forms only; a plain name stands for all forms of the method.
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

// Throws InputError for options that exclude or require one another.
void checkTogether(const StressCommandOptions& given) {
    const auto exclude = [](const OptionText& one, const char* name, const OptionText& two, const char* other) {
        if (one && two) throw InputError(name, Message(MessageId::ArgumentsExclude, {{"other", other}}));
    };
    exclude(given.cases, "--cases", given.seconds, "--seconds");
    exclude(given.cases, "--cases", given.only, "--case");
    exclude(given.record, "--record", given.only, "--case");
    for (const auto& [wanted, name] : {std::pair(&given.cases, "--cases"), std::pair(&given.record, "--record")}) {
        if (given.part && !*wanted) throw InputError("--part", Message(MessageId::NeedsArgument, {{"other", name}}));
    }
}

// Opens the record of this run, or of a part of it, and writes its first line. Null without --record.
std::unique_ptr<TextOutput> begunRecord(const StressCommandOptions& given, const std::optional<PartNumber>& number,
                                        const StressOptions& options, Session& session) {
    if (!given.record) return nullptr;
    checkOutput(*given.record, {"jsonl"});
    Json what{{"seed", options.seed},
              {"cases", options.cases ? Json(*options.cases) : Json()},
              {"tracers", given.tracers.value_or("")},
              {"parts", given.parts.value_or("")}};
    // Runs without it are named as by earlier versions.
    if (options.oracle) what["oracle"] = true;
    if (options.moreRays > 0) what["more-rays"] = options.moreRays;
    const std::string cells = options.cases ? std::to_string(*options.cases) : "";
    Part part;
    part.run = runJson("stress", std::move(what), {&cells, 1});
    if (number) static_cast<PartNumber&>(part) = *number;
    auto record = std::make_unique<TextOutput>(*given.record, session.stop());
    record->write((number ? partLine(part) : runLine(part.run)) + "\n");
    return record;
}

// Runs the cases in blocks that the ranks of an MPI run share.
int runShared(const StressCommandOptions& given, const StressOptions& options, Session& session) {
    constexpr std::uint64_t kBlock = 32;  // enough cases to keep all threads of a rank busy
    if (!options.cases) throw InputError("mpirun", Message(MessageId::NeedsArgument, {{"other", "--cases"}}));
    PartsRun run;
    run.bar = "stress";
    run.parts = static_cast<std::size_t>((*options.cases + kBlock - 1) / kBlock);
    run.measure = [&](const Task& task, Work& work) {
        StressOptions some = options;
        some.first = task.part * kBlock;
        some.cases = std::min(some.first + kBlock, *options.cases);
        Json lines = Json::array();
        some.onCase = [&](const StressCase& one) { lines.push_back(stressCaseLine(one)); };
        if (stress(some, work).interrupted) throw Cancelled();
        return lines;
    };
    const std::unique_ptr<TextOutput> record =
        launchedRank() == 0 ? begunRecord(given, std::nullopt, options, session) : nullptr;
    const std::optional<PartsDone> done = doParts(run, session);
    if (!done) return 0;
    StressTally tally;
    for (const Json& block : done->results) {
        for (const Json& line : block) {
            if (record) record->write(line.get<std::string>());
            tally.add(*parseStressCase(line.get<std::string>()));
        }
    }
    if (record) record->commit();
    return reportStress(tally.report(), options.seed, session);
}

int runStress(const StressCommandOptions& given, Session& session) {
    given.run.apply(session, given.part.has_value());
    checkTogether(given);
    StressOptions options;
    if (given.seconds) options.seconds = parseSeconds(*given.seconds);
    if (given.cases) {
        options.cases = static_cast<std::uint64_t>(parseWhole(*given.cases, "--cases", 1, kCasesAtMost));
    }
    std::optional<PartNumber> number;
    if (given.part) {
        number = parsePartNumber(*given.part);
        options.first = static_cast<std::uint64_t>(number->part - 1);
        options.step = static_cast<std::uint64_t>(number->of);
    }
    if (given.seed) options.seed = parseSeed(*given.seed, "--seed");
    if (given.tracers) options.methods = chosenMethods(*given.tracers);
    if (given.parts) {
        for (const std::string& part : splitText(*given.parts, ',')) {
            options.parts.insert(parseStressPart(part, "--parts"));
        }
    }
    options.oracle = given.oracle;
    if (given.moreRays) {
        options.moreRays = static_cast<int>(parseWhole(*given.moreRays, "--more-rays", 0, kMoreRaysAtMost));
    }
    if (given.only) options.only = parseSeed(*given.only, "--case");
    if (given.folder) {
        options.folder = *given.folder;
        std::error_code none;
        if (!std::filesystem::is_directory(options.folder, none)) {
            throw WorkError(options.folder, Message(MessageId::OutputFolderMissing, {{"folder", options.folder}}));
        }
    }
    std::unique_ptr<TextOutput> record;
    options.onHang = [&](const StressViolation& violation) {
        sayLine(
            sentence(Message(MessageId::StressHang, {{"seconds", options.hangSeconds}, {"command", violation.command}}),
                     session.language()));
        // The tracer does not return, so its thread cannot be joined: the process ends without cleaning up anything but
        // the record.
        if (record) record->discard();
        _exit(kFailed);
    };
    if (launchedProcesses() > 1 && !number) return runShared(given, options, session);
    record = begunRecord(given, number, options, session);
    if (record) options.onCase = [&](const StressCase& one) { record->write(stressCaseLine(one)); };
    const StressReport report = stress(options, session.work());
    session.eraseBar();
    if (record && !report.interrupted) record->commit();
    // If the run was interrupted, the results so far are still reported.
    const int status = reportStress(report, options.seed, session);
    if (status == 0 && report.interrupted && record) endStopped(session, *given.record, Message(MessageId::RunStopped));
    if (status == 0 && report.interrupted) throw Cancelled();
    return status;
}

}  // namespace

int reportStress(const StressReport& report, std::uint64_t seed, Session& session) {
    writeStandardOutput(stressText(report, seed));
    if (report.violationCount == 0) return 0;
    sayLine(sentence(Message(MessageId::StressViolations, {{"count", report.violationCount}}), session.language()));
    return kFailed;
}

void addStressCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<StressCommandOptions>();
    CLI::App* parser = addCommand(
        program, "stress", "search for rays, cameras and maps that violate a guarantee",
        "Runs every tracer, with extreme values of its options, over difficult maps and rays (grazing up to the "
        "domain's limit and beyond, along and through cell borders, huge and denormal numbers, far starts, plateaus at "
        "the ray's height, spikes, sizes from 1 x 1 to 65536 x 2) and checks its guarantees: no NaN, no more steps "
        "than its bound, no miss if a hit is certain, hits of exact methods equal bit for bit, hits of conservative "
        "ones never too late, the same answer with and without a log. Any-hit queries must agree with the exact hits "
        "of these rays. Small frames of the same maps, with extreme cameras (grazing, in a polygon's plane, very near, "
        "very far, narrow and wide), every filter and pixel model, with and without shadows and --bounded, must be "
        "finite and the same with and without --no-skip and on any number of threads; --bounded may move no hit "
        "farther than its bound. The homographies of such cameras must map pixels to texels and back, and their "
        "derivatives must agree with central differences. Row methods must stay within their error bounds. The cases "
        "depend only on the seed; mpirun -n N relief stress --cases ... shares them among N processes. Each violation "
        "is a line that ends with the command that reproduces it; the exit status is then 1.",
        "  relief stress --seconds 60 --seed 7\n"
        "  relief stress --oracle --parts tracers --cases 100\n"
        "  relief stress --cases 1000 --part 2/3 --record part2.jsonl\n"
        "  relief merge part1.jsonl part2.jsonl part3.jsonl");
    addText(*parser, "--seconds", options->seconds, "N", "run time, seconds, default 20", "Run");
    addText(*parser, "--cases", options->cases, "N", "run the first N cases, instead of --seconds", "Run");
    addText(*parser, "--seed", options->seed, "S", "seed of maps and rays, default 1", "Run");
    addText(*parser, "--tracers", options->tracers, "NAME,...",
            "use only these methods for view rays, and in frames where they apply (elsewhere the standard method); "
            "any-hit queries and row methods are always tested completely; NAME:OPTION=VALUE tests one setting of a "
            "method; default: all methods with all settings",
            "Run");
    addText(*parser, "--parts", options->parts, "NAME,...",
            "run only these parts of each case: tracers, any-hit, frames, homographies, rows; default: all", "Run");
    addText(*parser, "--more-rays", options->moreRays, "N",
            "each method also traces N times as many view rays of each case, 0 (default) to 1000, in blocks, the way "
            "pictures are traced, and without logs: most of the time is then spent on rays. Families of rays that take "
            "long, --oracle and any-hit queries are left out",
            "Run");
    addFlag(*parser, "--oracle", options->oracle,
            "also decide the first hit of every ray in rational arithmetic, without any rounding, and compare the hits "
            "of `exact`; the report counts the rays on which they differ within rounding (tangents and corners)",
            "Run");
    addText(*parser, "--case", options->only, "N", "run only the case of this number, which a violation names", "Run");
    addText(*parser, "-o,--output", options->folder, "FOLDER",
            "folder for maps that violate a guarantee and are not procedural; default: the current folder", "Output");
    addText(*parser, "--record", options->record, "FILE.jsonl",
            "record of all cases, a line of JSON for each; the first line identifies the run", "Output");
    addText(*parser, "--part", options->part, "K/N",
            "run only part K, from 1, of N, which is every N-th case (--cases), so that other processes can run the "
            "others; relief merge joins their records (--record) into one report",
            "Run");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runStress(*options, session); }});
}

}  // namespace relief::app
