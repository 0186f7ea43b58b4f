// relief trace PICTURE|SCENARIO.json --tracer NAME (--rays FILE.csv | --ray S0,T0,A,B ... | --pixel X,Y ...)
//     [-o HITS.csv] [--steps FILE.csv|json]
#include <algorithm>

#include "measuring/bench/child_counts.h"
#include "options_common.h"
#include "output.h"
#include "relief/memory.h"
#include "rendering/frame.h"
#include "rendering/pixel_coefficients.h"
#include "rendering/pixel_history_text.h"
#include "rendering/view_rays.h"
#include "scenario/ray_files.h"
#include "tiles_report.h"
#include "why.h"

namespace relief::app {

namespace {

// Number of rays whose steps are held in memory at once.
constexpr std::size_t kLoggedBlock = 4096;
// Characters of a hit's line: three numbers of 17 digits, the outcome, the steps.
constexpr std::uint64_t kLongestLine = 88;
constexpr int kDigits = 17;

struct TraceOptions {
    ScenarioOptions scenario;
    OptionText rays, output, steps;
    std::vector<std::string> single, pixels;
    bool coefficients = false;
    bool children = false;
    bool why = false;
    bool json = false;
    RunOptions run;
};

// The rays to trace and, for each, the index of its answer: a pixel that sees no polygon has an answer but no ray.
struct RaySelection {
    RayBlock rays;
    std::vector<std::size_t> answer;  // per ray; empty: the ray's own index
    std::size_t answers = 0;

    std::size_t answerOf(std::size_t ray) const { return answer.empty() ? ray : answer[ray]; }
};

RaySelection raysOfFile(const std::string& path, Session& session) {
    RaySelection selection;
    const bool standardInput = path == "-";
    const std::string text = standardInput ? readStandardInput(session.stop()) : readTextFile(path);
    selection.rays = parseRays(text, standardInput ? "standard input" : path);
    selection.answers = selection.rays.size();
    return selection;
}

RaySelection raysOfTexts(const std::vector<std::string>& texts) {
    RaySelection selection;
    for (const std::string& text : texts) selection.rays.push(parseRayText(text, "--ray"));
    selection.answers = selection.rays.size();
    return selection;
}

RaySelection raysOfPixels(const std::vector<PixelChoice>& pixels, const FrameRequest& request) {
    RaySelection selection;
    selection.answers = pixels.size();
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        const auto ray = pixelRay(request, pixels[p].x, pixels[p].y);
        if (!ray) continue;
        selection.rays.push(*ray);
        selection.answer.push_back(p);
    }
    return selection;
}

std::vector<PixelChoice> chosenPixels(const TraceOptions& options, const Scenario& scenario) {
    std::vector<PixelChoice> pixels;
    for (const std::string& text : options.pixels) pixels.push_back(parsePixel(text, "--pixel"));
    if (pixels.empty() && scenario.pixel) pixels.push_back(*scenario.pixel);
    if (pixels.empty()) throw InputError("", Message(MessageId::RaysNotGiven));
    return pixels;
}

HitBlock answers(const RaySelection& selection, const HitBlock& traced) {
    if (selection.answer.empty() && selection.answers == traced.size()) return traced;
    HitBlock all(selection.answers);
    for (std::size_t r = 0; r < traced.size(); ++r) {
        const std::size_t a = selection.answerOf(r);
        all.set(a, traced[r]);
        all.steps[a] = traced.steps[r];
        all.reads[a] = traced.reads[r];
    }
    return all;
}

// Traces the rays a second time with a step log, in blocks, because the steps of a million rays would not fit into
// memory. Calls body(log, first, count) for each block, whose rays begin at index `first`.
template <class Body>
void overLogs(const RaySelection& selection, const Tracer& tracer, const char* title, Work& work, const Body& body) {
    work.progress().begin(title, static_cast<std::int64_t>(selection.rays.size()));
    for (std::size_t first = 0; first < selection.rays.size(); first += kLoggedBlock) {
        const std::size_t count = std::min(kLoggedBlock, selection.rays.size() - first);
        RayBlock block(count);
        for (std::size_t r = 0; r < count; ++r) block.set(r, selection.rays[first + r]);
        HitBlock hits;
        StepLog log;
        tracer.trace(block, hits, log, work);
        body(log, first, count);
        work.progress().advance(static_cast<std::int64_t>(count));
    }
}

void writeSteps(const RaySelection& selection, const Tracer& tracer, TextOutput& output, bool json, Session& session) {
    std::string text = json ? "[" : std::string(kStepsHeader) + "\n";
    bool empty = true;
    overLogs(selection, tracer, "steps", session.work(), [&](const StepLog& log, std::size_t first, std::size_t count) {
        for (std::size_t r = 0; r < count; ++r) {
            const std::size_t ray = selection.answerOf(first + r);
            if (json) {
                appendStepObjects(text, log, r, ray, empty);
            } else {
                appendStepLines(text, log, r, ray);
            }
        }
        output.write(text);
        text.clear();
    });
    if (json) text += "\n]\n";
    output.write(text);
}

// Returns the mapping coefficients of each pixel, one line per pixel; fields are empty for a pixel that sees no
// polygon.
std::string coefficientLines(const std::vector<PixelChoice>& pixels, const FrameRequest& request) {
    std::string text;
    for (const NamedNumber& number : namedNumbers({})) text += std::string(number.name) + ",";
    text += "x,y\n";
    for (const PixelChoice& pixel : pixels) {
        const auto found = pixelCoefficients(request, pixel.x, pixel.y);
        for (const NamedNumber& number : namedNumbers(found.value_or(PixelCoefficients{}))) {
            if (found) text += numberText(number.value, kDigits);
            text += ',';
        }
        text += std::to_string(pixel.x) + "," + std::to_string(pixel.y) + "\n";
    }
    return text;
}

RaySelection raysOfView(const FrameRequest& request) {
    RaySelection selection;
    selection.rays = viewRays(request).rays;
    selection.answers = selection.rays.size();
    return selection;
}

// Returns the number of children entered at each level, summed over all rays.
ChildrenByLevel childrenOf(const RaySelection& selection, const Tracer& tracer, Session& session) {
    ChildrenByLevel counts;
    overLogs(selection, tracer, "children", session.work(), [&](const StepLog& log, std::size_t, std::size_t count) {
        for (std::size_t r = 0; r < count; ++r) addChildren(log.steps, log.begin[r], log.begin[r + 1], counts);
    });
    return counts;
}

// Writes why the pixels have their colours. Returns 1 if the numbers of a pixel do not multiply out to it.
int writeWhy(const TraceOptions& options, const std::vector<PixelChoice>& pixels, const FrameRequest& request,
             const std::shared_ptr<MapCache>& maps, Session& session) {
    std::vector<PixelHistory> histories;
    for (const PixelChoice& pixel : pixels) {
        histories.push_back(pixelHistory(request, pixel.x, pixel.y, maps, session.work()));
    }
    const std::string output = options.output.value_or("-");
    std::string text;
    if (options.json || (output != "-" && fileEnding(output) == "json")) {
        text = historiesJson(histories, request);
    } else {
        for (const PixelHistory& history : histories) {
            text += historyText(history, request, session.language());
        }
    }
    session.eraseBar();
    TextOutput file(output, session.stop());
    file.write(text);
    file.commit();
    const bool good = std::all_of(histories.begin(), histories.end(),
                                  [](const PixelHistory& history) { return history.multipliesOut(); });
    return good ? kDone : kFailed;
}

void refuseTwoSources(const TraceOptions& options) {
    const auto refuse = [](const std::string& one, const std::string& other) {
        throw InputError(one, Message(MessageId::ArgumentsExclude, {{"other", other}}));
    };
    const std::string table = options.why ? "--why" : options.coefficients ? "--coefficients" : "--children";
    if (options.coefficients && options.children) refuse("--coefficients", "--children");
    if (options.why && options.coefficients) refuse(table, "--coefficients");
    if (options.why && options.children) refuse(table, "--children");
    if ((options.why || options.coefficients || options.children) && options.steps) refuse(table, "--steps");
    const bool ofPixels = options.coefficients || options.why;
    if (ofPixels && options.rays) refuse(table, "--rays");
    if (ofPixels && !options.single.empty()) refuse(table, "--ray");
    if (options.rays && !options.pixels.empty()) refuse("--rays", "--pixel");
    if (options.rays && !options.single.empty()) refuse("--rays", "--ray");
    if (!options.single.empty() && !options.pixels.empty()) refuse("--ray", "--pixel");
    // Rays given as numbers do not depend on a view.
    const std::string view = options.scenario.viewOption();
    if (!view.empty() && options.rays) refuse(view, "--rays");
    if (!view.empty() && !options.single.empty()) refuse(view, "--ray");
}

void refuseOwnInputs(const TraceOptions& options, const Scenario& scenario) {
    std::vector<std::string> inputs = inputFiles(options.scenario, scenario);
    inputs.push_back(options.rays.value_or(""));
    refuseOverwriting("--output", options.output.value_or("-"), inputs);
    refuseOverwriting("--steps", options.steps.value_or(""), inputs);
}

int runTrace(const TraceOptions& options, Session& session) {
    options.run.apply(session);
    const std::string output = options.output.value_or("-");
    if (output != "-") checkOutputFolder(output);
    if (options.steps) checkOutput(*options.steps, {"csv", "json"});
    refuseTwoSources(options);
    // Only the colour of a pixel depends on these.
    const std::string colored = options.json ? "--json" : options.scenario.lookOption();
    if (!options.why && !colored.empty()) {
        throw InputError(colored, Message(MessageId::NeedsArgument, {{"other", "--why"}}));
    }
    Scenario scenario = options.scenario.scenario();
    refuseOwnInputs(options, scenario);
    if (!options.why) {
        // Tracing depends on the heights only.
        scenario.pictures.color.clear();
        scenario.pictures.normal.clear();
    }
    const bool given = options.rays || !options.single.empty();
    // Without a ray or pixel, children are counted for the whole view.
    const bool wholeView = options.children && !given && options.pixels.empty();
    const std::vector<PixelChoice> pixels =
        given || wholeView ? std::vector<PixelChoice>{} : chosenPixels(options, scenario);
    const RaySelection single = raysOfTexts(options.single);

    Work& work = session.work();
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work, true);
    noteHeights(session, assets, scenario);
    const auto shared = std::make_shared<MapCache>();
    MapCache& maps = *shared;
    options.scenario.useStoredMap(scenario, assets, maps, work);
    const FrameRequest request = frameRequest(scenario, assets);
    if (options.coefficients) {
        const std::string lines = coefficientLines(pixels, request);
        session.eraseBar();
        TextOutput text(output, session.stop());
        text.write(lines);
        text.commit();
        return 0;
    }
    if (options.why) return writeWhy(options, pixels, request, shared, session);
    // Rays given as numbers have no view from which the base level could be chosen; the tracer refuses base=auto for
    // them.
    if (!options.rays && options.single.empty()) noteBaseLevel(session, scenario, request);
    const RaySelection selection = options.rays              ? raysOfFile(*options.rays, session)
                                   : !options.single.empty() ? single
                                   : wholeView               ? raysOfView(request)
                                                             : raysOfPixels(pixels, request);

    // Bytes per ray: the hits traced, the answers, and their lines in pieces and joined.
    constexpr std::uint64_t kBytes = 2 * HitBlock::kBytes + 2 * kLongestLine;
    requireMemory(byteProduct({selection.answers, kBytes}), options.rays.value_or("--pixel"));
    // Rays given as numbers have no pixel width, which base=auto needs.
    const auto tracer = makeTracer(given ? scenario.method : request.method, request.field, maps, work);
    if (options.children) {
        const ChildrenByLevel counts = childrenOf(selection, *tracer, session);
        session.eraseBar();
        TextOutput text(output, session.stop());
        text.write(output != "-" && fileEnding(output) == "csv" ? childrenCsv(counts) : childrenText(counts));
        text.commit();
        return 0;
    }
    HitBlock traced;
    BlockCounts counts;
    tracer->trace(selection.rays, traced, counts, work);
    std::unique_ptr<TextOutput> steps;
    if (options.steps) {
        steps = std::make_unique<TextOutput>(*options.steps, session.stop());
        writeSteps(selection, *tracer, *steps, fileEnding(*options.steps) == "json", session);
    }
    TextOutput hits(output, session.stop());
    hits.write(std::string(kHitsHeader) + "\n" + hitLines(answers(selection, traced), work));
    session.eraseBar();
    if (assets.tiles) noteTiles(session, *assets.tiles, traced.size());
    hits.commit();
    if (steps) steps->commit();
    return 0;
}

}  // namespace

void addTraceCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<TraceOptions>();
    CLI::App* parser =
        addCommand(program, "trace", "trace single rays and log every step",
                   "Prints where rays hit the relief: one line per ray, in the given order, with the header "
                   "outcome,lambda,s,t,steps. The outcome is hit, miss or limit; lambda is the descent (0: the top "
                   "plane, 1: the bottom); s and t are in texels. Rays come from a file with the header s0,t0,a,b (the "
                   "point where the ray enters the top plane, and its horizontal displacement per unit of descent, "
                   "texels), from the command line, or from pixels of a view.",
                   "  relief trace heights.png --tracer max-pyramid --scene wall --pixel 400,300 --steps steps.csv\n"
                   "  relief trace heights.png --color color.jpg --shadows --pixel 400,300 --why");
    options->scenario.add(*parser, ScenarioOptions::OptionGroups::All);
    options->scenario.addMemory(*parser);
    addText(*parser, "--rays", options->rays, "FILE.csv",
            "file of rays with the header s0,t0,a,b; - for standard input", "Rays");
    addTexts(*parser, "--ray", options->single, "S0,T0,A,B", "one ray; may be repeated", "Rays");
    addTexts(*parser, "--pixel", options->pixels, "X,Y",
             "the ray of this pixel of the view, 0,0 at the top left; may be repeated. A pixel that sees no polygon is "
             "a miss",
             "Rays");
    addOutput(*parser, options->output, "file of the hits; default -: standard output");
    addText(
        *parser, "--steps", options->steps, "FILE.csv|json",
        "file of all steps of all rays: number of the ray from 0, number of the step from 1, texel, heights, decision",
        "Output");
    addFlag(*parser, "--coefficients", options->coefficients,
            "instead of hits, write the numbers of the mapping at each pixel: the nine coefficients A to I (texels), "
            "q, the derivatives, M, N, O, P, the ellipse; needs --pixel",
            "Output");
    addFlag(*parser, "--children", options->children,
            "instead of hits, write the number of children of a texel that the rays enter at each level of a max "
            "pyramid: a table with a histogram, or CSV if the file is a .csv; without rays, for all pixels of the view",
            "Output");
    addFlag(*parser, "--why", options->why,
            "instead of hits, explain the colour of each --pixel: coverage, ray, hit, texels with weights and colours, "
            "light, and their product beside the drawn pixel; JSON if the file is a .json. Needs --pixel; pictures, "
            "filter, shadows and light are those of relief render. Exit status 1 if the numbers do not multiply out",
            "Output");
    addFlag(*parser, "--json", options->json, "with --why: write JSON", "Output");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runTrace(*options, session); }});
}

}  // namespace relief::app
