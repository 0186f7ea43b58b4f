// relief recommend PICTURE|SCENARIO.json [--views LO,HI] [--error E] [--memory MB] [--seconds S]
// [--form simd|scalar|shader] [--max-steps N] [--fetches N] [--json] [--check] [-o FILE]
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "measuring/advise/recommend_shader.h"
#include "options_common.h"
#include "output.h"
#include "relief/reliefs.h"
#include "scenario/command_text.h"

namespace relief::app {

namespace {

constexpr double kMostError = 1e6;
constexpr double kMostMemory = 1 << 20;  // megabytes
constexpr double kMostSeconds = 24 * 3600;
constexpr double kMostStepCost = 1000;
constexpr std::int64_t kMostSteps = 1'000'000'000;
constexpr const char* kShaderForm = "shader";
constexpr int kCheckSide = 128;  // texels of the reliefs used by --check

struct RecommendOptions {
    ScenarioOptions scenario;
    OptionText views, error, outliers, memory, seconds, form, stepCost, maxSteps, fetches, seed, color, output;
    bool json = false;
    bool noFilter = false;
    bool check = false;
    RunOptions run;

    bool forShaders() const { return form == kShaderForm; }
    bool asJson() const { return json || (output && fileEnding(*output) == "json"); }
};

double parseRange(const std::string& text, const std::string& option, double low, double high) {
    const double value = parseNumber(text, option);
    if (!(value >= low && value <= high)) {
        throw InputError(option,
                         Message(MessageId::NumberOutOfRange, {{"value", text}, {"range", rangeOf(low, high)}}));
    }
    return value;
}

// Sets the requirements that both kinds of advice have.
template <class Options>
void applyCommon(const RecommendOptions& given, Options& options) {
    if (given.views) options.views = parseViews(*given.views, "--views");
    if (given.memory) {
        options.memory = static_cast<std::int64_t>(parseRange(*given.memory, "--memory", 0, kMostMemory) * 1048576);
    }
    if (given.seconds) options.seconds = parseRange(*given.seconds, "--seconds", 1, kMostSeconds);
    if (given.maxSteps) options.maxSteps = parseWhole(*given.maxSteps, "--max-steps", 1, kMostSteps);
    if (given.seed) options.seed = parseSeed(*given.seed, "--seed");
}

void applyAsked(const RecommendOptions& given, AdviceOptions& options) {
    applyCommon(given, options);
    if (given.error) options.error = parseRange(*given.error, "--error", 0, kMostError);
    if (given.outliers) options.outliers = parseRange(*given.outliers, "--outliers", 0, 100) / 100;
    if (given.form) options.form = parseForm(*given.form, "--form");
    if (given.stepCost && options.form != Form::Scalar) {
        throw InputError("--step-cost", Message(MessageId::NeedsArgument, {{"other", "--form scalar"}}));
    }
    if (given.stepCost) options.stepCost = parseRange(*given.stepCost, "--step-cost", 0, kMostStepCost);
    options.filters = !given.noFilter;
}

// Returns all procedural reliefs at a small size, for checks without a height map.
std::vector<Scenario> checkedScenarios(const RecommendOptions& given) {
    if (given.scenario.heightsGiven()) return {given.scenario.scenario()};
    std::vector<Scenario> all;
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        Scenario scenario = given.scenario.scenario();
        applyRecipe(scenario.pictures, std::string(recipe.name));
        if (recipe.anySize) scenario.pictures.recipeWidth = scenario.pictures.recipeHeight = kCheckSide;
        all.push_back(scenario);
    }
    return all;
}

int runCheck(const RecommendOptions& given, Session& session) {
    std::vector<CheckedRelief> checked;
    for (const Scenario& scenario : checkedScenarios(given)) {
        refuseOverwriting("--output", given.output.value_or("-"), inputFiles(given.scenario, scenario));
        AssetStore store;
        const Assets assets = store.load(scenario.pictures, session.work(), true);
        AdviceOptions options(assets.field(scenario));
        applyAsked(given, options);
        checked.push_back({heightsName(scenario.pictures), adviceRegret(options, session.work())});
    }
    session.eraseBar();
    TextOutput out(given.output.value_or("-"), session.stop());
    out.write(regretText(checked));
    out.commit();
    return keepsBounds(checked) ? kDone : kFailed;
}

// Throws InputError for options that the form does not have.
void checkForm(const RecommendOptions& given) {
    if (given.fetches && !given.forShaders()) {
        throw InputError("--fetches", Message(MessageId::NeedsArgument, {{"other", "--form shader"}}));
    }
    if (!given.form) return;
    if (!given.forShaders()) {
        // The names that parseForm() knows are not all.
        if (*given.form != "lanes" && *given.form != formName(Form::Simd) && *given.form != formName(Form::Scalar)) {
            throw InputError("--form",
                             unknownName({"what", MessageId::WordValue}, *given.form, "simd, scalar, shader"));
        }
        return;
    }
    for (const auto& [name, isGiven] :
         {std::pair("--outliers", given.outliers.has_value()), std::pair("--step-cost", given.stepCost.has_value()),
          std::pair("--check", given.check)}) {
        if (isGiven) throw InputError(name, Message(MessageId::ArgumentsExclude, {{"other", "--form shader"}}));
    }
}

int recommendForShader(const RecommendOptions& given, const Scenario& scenario, const Assets& assets,
                       Session& session) {
    if (assets.tiles)
        throw InputError("--resident", Message(MessageId::ArgumentsExclude, {{"other", "--form shader"}}));
    ShaderAdviceOptions options(assets.field(scenario));
    applyCommon(given, options);
    if (given.error) options.error = parseRange(*given.error, "--error", 0, 1);
    if (given.fetches) options.maxFetches = parseWhole(*given.fetches, "--fetches", 1, kMostSteps);
    options.name = heightsName(scenario.pictures);
    options.heights = heightArguments(scenario.pictures);
    options.color = assets.color;
    const ShaderAdvice advice = recommendShader(options, session.work());
    session.eraseBar();
    TextOutput out(given.output.value_or("-"), session.stop());
    out.write(given.asJson() ? shaderAdviceJson(options, advice)
                             : shaderAdviceText(options, advice, session.language()));
    out.commit();
    return kDone;
}

int runRecommend(const RecommendOptions& given, Session& session) {
    given.run.apply(session);
    checkForm(given);
    if (given.output) checkOutputFolder(*given.output);
    // The regret is a text, which a file of this name would not hold.
    if (given.check && given.asJson()) {
        throw InputError("--check", Message(MessageId::ArgumentsExclude, {{"other", "--output " + *given.output}}));
    }
    if (given.check) return runCheck(given, session);
    Scenario scenario = given.scenario.scenario();
    if (given.color) scenario.pictures.color = *given.color;
    refuseOverwriting("--output", given.output.value_or("-"), inputFiles(given.scenario, scenario));
    Work& work = session.work();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work, true);
    // The filters' pictures are of the whole map.
    if (assets.tiles && !given.noFilter && !given.forShaders()) {
        throw InputError("--resident", Message(MessageId::NeedsArgument, {{"other", "--no-filter"}}));
    }
    noteHeights(session, assets, scenario);
    const ImageInfo& info = assets.height->info;
    if (info.channels.size() > 1 && scenario.pictures.reading.channel.empty()) {
        session.note(heightsName(scenario.pictures),
                     Message(MessageId::HeightChannelTaken,
                             {{"name", assets.height->channel}, {"known", commaList(info.channels)}}));
    }
    if (given.forShaders()) return recommendForShader(given, scenario, assets, session);
    AdviceOptions options(assets.field(scenario));
    applyAsked(given, options);
    options.name = heightsName(scenario.pictures);
    options.color = assets.color;
    const Advice advice = recommend(options, work);
    session.eraseBar();
    for (const Message& note : adviceNotes(options, advice)) session.note(options.name, note);
    TextOutput out(given.output.value_or("-"), session.stop());
    out.write(given.asJson() ? adviceJson(options, advice) : adviceText(options, advice, session.language()));
    out.commit();
    return 0;
}

void addAsked(CLI::App& parser, RecommendOptions& options) {
    const char* group = "Requirements";
    addText(parser, "--views", options.views, "LO,HI",
            "range of elevations from which the relief is seen, degrees; a single number: only that elevation; random: "
            "random entry, azimuth and elevation; default 10,80",
            group);
    addText(
        parser, "--error", options.error, "E",
        "largest allowed error of a hit, texels, default 0.5; with --form shader: largest mean FLIP, 0 to 1, within "
        "which the fewest fetches are sought; default: the smallest error is sought",
        group);
    addText(parser, "--outliers", options.outliers, "PERCENT",
            "percentage of the rays that may exceed this error, hit where exact misses, or miss where exact hits; "
            "default 0.01",
            group);
    addText(
        parser, "--memory", options.memory, "MB",
        "largest memory of the maps besides the heights, MiB, default 256; for the heights: --resident. With --form "
        "shader: of all textures that the tracing function reads, the heights included, as a graphics card stores "
        "them",
        group);
    addText(
        parser, "--form", options.form, "simd|scalar|shader",
        "simd (default): for use of this library; the cost is processor time on one thread. scalar: for porting to "
        "a shader; the cost is height samples (reads) + C x steps. shader: for the shaders of relief export shader; "
        "the error is that of pictures",
        group);
    addText(parser, "--max-steps", options.maxSteps, "N",
            "largest number of steps per ray (as in relief trace --steps, the start included), except for the share "
            "--outliers; with --form shader without exception. Default: no limit",
            group);
    addText(parser, "--fetches", options.fetches, "N",
            "with --form shader: largest number of texture fetches per ray, a filtered one counted as one (by the "
            "sampler, --interpolation sampler, as the printed command sets). Default: no limit",
            group);
    addText(parser, "--step-cost", options.stepCost, "C",
            "cost of the arithmetic of a step, in height samples (--form scalar), default 2", group);
    CLI::Option* const color = addText(parser, "--color", options.color, "FILE",
                                       "colour picture for trying filters; default: coloured patches", group);
    addFlag(parser, "--no-filter", options.noFilter, "recommend no filter", group)->excludes(color);
}

}  // namespace

void addRecommendCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<RecommendOptions>();
    CLI::App* parser = addCommand(
        program, "recommend", "recommend a method, filter and map for a height map, by measurement",
        "Recommends the method that should trace this height map. All tracers, with promising values of their options, "
        "are measured on the same rays of the given views. A method that exceeds the error bound, needs too much "
        "memory, or whose map takes too long to build, is dropped; the others are timed in short alternating rounds, "
        "after each of which clearly slower ones are dropped. A method up to 3% slower is preferred if its map is "
        "smaller. The answer gives the reasons: properties of the relief, steps, samples, bytes and build time; it "
        "warns if building the map costs more than it saves. Filters are compared with a small supersampled picture, "
        "of the middle of maps larger than 1024 x 1024. Of a map that is read by tiles (--resident, with --no-filter), "
        "only the methods that can are measured, and the properties of the relief are those of a sample. With --form "
        "scalar the answer depends on counts only: the same seed gives the same answer if the time "
        "sufficed to build every map.\n"
        "With --form shader every tracer that has a shader is measured over textures as relief map writes them for "
        "engines, with 8 and 16 bits, and with as many layers or iterations as the limits of steps and fetches allow. "
        "The answer is the one whose pictures are nearest to those of exact (FLIP), or of nearly equal ones the one "
        "with the fewest fetches, with the commands that write its textures and its shader.",
        "  relief recommend heights.png --views 15,70 --error 0.5 --memory 64 --seconds 20\n"
        "  relief recommend --relief city:512x512 --form scalar --json -o city.json\n"
        "  relief recommend heights.png --form shader --max-steps 32 --fetches 40 --memory 1");
    options->scenario.add(*parser, ScenarioOptions::OptionGroups::HeightsOnly);
    options->scenario.addMemory(*parser, "--resident");
    addAsked(*parser, *options);
    addText(*parser, "--seconds", options->seconds, "S",
            "time for everything, seconds, 1 or more; default 4 up to 1024 x 1024 texels, growing with the side to 16 "
            "from 4096 x 4096 on; with --form shader ten times as much",
            "Run");
    addText(*parser, "--seed", options->seed, "S", "seed of the rays, default 1", "Run");
    CLI::Option* const check =
        addFlag(*parser, "--check", options->check,
                "check the advice: measure all candidates to the end on other rays and print the regret, which is how "
                "much more expensive the advised method is than the best one. Without a height map this is done for "
                "every procedural relief, 128 x 128. Exit status 1 if the advised method exceeds the error bound there",
                "Run");
    addOutput(*parser, options->output,
              "file for the text, or for JSON if the name ends in .json; default standard output");
    CLI::Option* const json = addFlag(*parser, "--json", options->json, "write JSON instead of text", "Output");
    check->excludes(json, parser->get_option("--color"), parser->get_option("--no-filter"));
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runRecommend(*options, session); }});
}

}  // namespace relief::app
