// relief claims [--measure] [-o FILE]
#include "measuring/bench/claims.h"

#include "options_common.h"
#include "output.h"

namespace relief::app {

namespace {

constexpr int kLeastSide = 16;
constexpr int kMostSide = 1024;
constexpr std::int64_t kFewestRays = 100;
constexpr std::int64_t kMostRays = 10'000'000;
constexpr std::int64_t kMostRounds = 1000;

struct ClaimsCommandOptions {
    OptionText size, rays, rounds, output;
    bool measure = false;
    bool json = false;
    RunOptions run;
};

int runClaims(const ClaimsCommandOptions& given, Session& session) {
    given.run.apply(session);
    if (given.output) checkOutput(*given.output, {"txt", "json"});
    const auto onlyMeasured = [&](const OptionText& option, const char* name) {
        if (option && !given.measure) {
            throw InputError(name, Message(MessageId::NeedsArgument, {{"other", "--measure"}}));
        }
    };
    onlyMeasured(given.size, "--size");
    onlyMeasured(given.rays, "--rays");
    onlyMeasured(given.rounds, "--rounds");
    ClaimsOptions options;
    if (given.size) options.size = parseSide(*given.size, "--size", kMostSide);
    if (options.size < kLeastSide) {
        throw InputError("--size", Message(MessageId::NumberOutOfRange,
                                           {{"value", *given.size}, {"range", rangeOf(kLeastSide, kMostSide)}}));
    }
    if (given.rays) options.rays = parseWhole(*given.rays, "--rays", kFewestRays, kMostRays);
    if (given.rounds) options.rounds = static_cast<int>(parseWhole(*given.rounds, "--rounds", 1, kMostRounds));
    const ClaimsTable table = given.measure ? measureClaims(options, session.work()) : shippedClaims();
    session.eraseBar();
    TextOutput out(given.output.value_or("-"), session.stop());
    out.write(given.json || (given.output && fileEnding(*given.output) == "json")
                  ? claimsJson(table)
                  : claimsText(table, session.language()));
    out.commit();
    return 0;
}

}  // namespace

void addClaimsCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<ClaimsCommandOptions>();
    CLI::App* parser = addCommand(
        program, "claims", "list the claims of the papers with measurements",
        "Prints every measurable claim of the five papers, one per line: paper and place, the claim, the measurement, "
        "and the verdict: confirmed, refuted, or dependent on the conditions that the measurement names. The table is "
        "part of the program; its first line gives the date and the machine of the measurement. --measure measures "
        "again on this machine, which takes some minutes. Most results are counts of operations and steps, or errors; "
        "the few rates have their spread and compare implementations of the same form.",
        "  relief claims --language uk\n"
        "  relief claims --measure --size 64 --rays 2000 -o claims.json");
    addFlag(*parser, "--measure", options->measure, "measure again, on this machine", "Run");
    addText(*parser, "--size", options->size, "N", "with --measure: texels along each side of the reliefs, default 128",
            "Run");
    addText(*parser, "--rays", options->rays, "N", "with --measure: rays per relief, default 20000", "Run");
    addText(*parser, "--rounds", options->rounds, "N", "with --measure: number of timed rounds, default 5", "Run");
    addOutput(*parser, options->output,
              "file for the text, or for JSON if the name ends in .json; default standard output");
    addFlag(*parser, "--json", options->json, "write JSON instead of text", "Output");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runClaims(*options, session); }});
}

}  // namespace relief::app
