// relief bench filters [-o FILE.csv|json]
#include "bench_filters.h"

#include "bench_output.h"
#include "filtering/filters/measured_filters.h"
#include "measuring/bench/bench_tracers.h"

namespace relief::app {

namespace {

constexpr std::int64_t kMostRounds = 1000;
constexpr int kMostSide = 4096;
constexpr int kSceneSide = 512;

FilterScene namedScene(const std::string& name, std::uint64_t seed) {
    const std::vector<std::string> known = filterSceneNames();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
        throw InputError("--scenes", unknownName({"what", MessageId::WordScene}, name, commaList(known)));
    }
    return filterScene(name, kSceneSide, seed);
}

// Returns a scene of the user's height map, with its colours or with a pattern of patches.
FilterScene givenScene(Pictures pictures, const OptionText& color, double depth, std::uint64_t seed, Session& session) {
    if (color) pictures.color = *color;
    Scenario scenario;
    scenario.pictures = pictures;
    AssetStore store;
    const Assets assets = store.load(pictures, session.work());
    noteHeights(session, assets, scenario);
    return {pictures.recipe.empty() ? heightsName(pictures) : pictures.recipe,
            HeightField(assets.heights, Surface::Bilinear, Address::Repeat, depth),
            assets.color ? assets.color : patchPicture(*assets.heights, seed)};
}

FilterBenchOptions filterOptions(const FilterBenchCommand& given, const OptionText& elevations,
                                 const OptionText& rounds) {
    FilterBenchOptions options;
    options.filters = benchedFilters();
    if (given.filters) {
        options.filters.clear();
        for (const std::string& text : splitText(*given.filters, ',')) {
            options.filters.push_back(parseFilter(text, "--filters"));
            if (options.filters.back().name != kSupersample) continue;
            throw InputError("--filters", unknownName({"what", MessageId::WordTextureFilter}, std::string(kSupersample),
                                                      "the others"));
        }
    }
    if (given.pixelModels) {
        options.pixelModels.clear();
        for (const std::string& text : splitText(*given.pixelModels, ',')) {
            options.pixelModels.push_back(parsePixelModel(text));
        }
    }
    if (elevations) {
        options.elevations.clear();
        for (const std::string& text : splitText(*elevations, ',')) {
            const Elevation elevation = parseElevation(text, "--elevations");
            if (!elevation) throw InputError("--elevations", Message(MessageId::NotANumber, {{"text", text}}));
            options.elevations.push_back(*elevation);
        }
    }
    if (given.size) {
        const SizeText size = parseSize(*given.size, "--size", kMostSide);
        options.width = size.width;
        options.height = size.height;
    }
    if (given.samples) {
        options.samples = static_cast<int>(parseWhole(*given.samples, "--samples", 3, kMaxSamples));
    }
    if (rounds) options.rounds = static_cast<int>(parseWhole(*rounds, "--rounds", 1, kMostRounds));
    return options;
}

}  // namespace

void FilterBenchCommand::add(CLI::App& parser) {
    const char* group = "Measurement (filters)";
    addText(parser, "--filters", filters, "NAME,...",
            "filters, each with options as NAME:OPTION=VALUE, such as elliptical:weights=uniform; default: those that "
            "the papers compare",
            group);
    addText(parser, "--scenes", scenes, "NAME,...",
            commaList(filterSceneNames()) + "; default all; --height and --relief replace them", group);
    addText(parser, "--color", color, "FILE", "colour picture for --height and --relief; default: coloured patches",
            group);
    addText(parser, "--pixel-models", pixelModels, "NAME,...",
            "pixel models of the reference: box, gaussian, lcd, crt; default box,gaussian", group);
    addText(parser, "--size", size, "WxH|N", "size of the pictures, pixels, default 320x240", group);
    addText(parser, "--samples", samples, "N",
            "samples of the reference along each side of a pixel, 3 to 64, default 16", group);
}

int FilterBenchCommand::run(const std::vector<Pictures>& pictures, const OptionText& elevations,
                            const OptionText& reliefDepth, const OptionText& rounds, const OptionText& seed,
                            BenchRun to, Session& session) const {
    FilterBenchOptions options = filterOptions(*this, elevations, rounds);
    const std::uint64_t number = seed ? parseSeed(*seed, "--seed") : 1;
    Scenario scenario;
    if (reliefDepth) {
        const std::string option = "--relief-depth";
        setScenarioNumber(scenario, "relief-depth", parseNumber(*reliefDepth, option), option);
    }
    for (const Pictures& one : pictures) {
        options.scenes.push_back(givenScene(one, color, scenario.reliefDepth, number, session));
    }
    if (scenes && !pictures.empty()) {
        throw InputError("--scenes", Message(MessageId::ArgumentsExclude, {{"other", "--height, --relief"}}));
    }
    if (pictures.empty()) {
        for (const std::string& name : scenes ? splitText(*scenes, ',') : filterSceneNames()) {
            options.scenes.push_back(namedScene(name, number));
            FilterScene& scene = options.scenes.back();
            if (!reliefDepth) continue;
            scene.field =
                HeightField(scene.field.sharedHeights(), Surface::Bilinear, Address::Repeat, scenario.reliefDepth);
        }
    }
    to.what["rounds"] = options.rounds;
    to.what["size"] = std::to_string(options.width) + "x" + std::to_string(options.height);
    to.what["samples"] = options.samples;
    to.what["filters"] = filters.value_or("");
    to.what["pixel models"] = pixelModels.value_or("");
    to.what["relief depth"] = reliefDepth.value_or("");
    to.what["seed"] = number;
    to.what["color"] = color.value_or("");
    to.what["threads"] = session.threads();
    std::vector<BenchCell<FilterBenchRow>> cells;
    for (const FilterScene& scene : options.scenes) {
        for (const double elevation : options.elevations) {
            FilterBenchOptions one = options;
            one.scenes = {scene};
            one.elevations = {elevation};
            cells.push_back({scene.name + "," + contentText(scene.field.heights()) + "," + numberText(elevation), 0,
                             [one = std::move(one)](Work& work, BenchPass pass) mutable {
                                 one.pass = pass;
                                 return benchFilters(one, work);
                             }});
        }
    }
    return runCells<FilterBenchRow>(to, {filterBenchCsvHeader, filterBenchJson, filterBenchText}, cells, session);
}

}  // namespace relief::app
