// relief bench tracers | rows | filters [-o FILE.csv|json]
#include "bench_filters.h"
#include "bench_output.h"
#include "bench_rows.h"
#include "images/reliefs.h"
#include "measuring/bench_tracers.h"
#include "options_common.h"

namespace relief::app {

namespace {

constexpr std::int64_t kMostRays = 1 << 26;
constexpr std::int64_t kMostRounds = 1000;
constexpr int kDefaultSide = 256;
constexpr const char* kDefaultReliefs[] = {"bricks", "city", "fractal", "hills", "pits", "spikes"};

struct BenchCommandOptions {
    OptionText kind, tracers, elevations, lowest, rays, rounds, seed, surface, address, reliefDepth, output;
    std::vector<std::string> heights, recipes;
    ReadingOptions reading;
    RowBenchCommand rows;
    FilterBenchCommand filters;
    RunOptions run;
};

std::vector<Pictures> chosenPictures(const BenchCommandOptions& given) {
    std::vector<Pictures> all;
    Pictures plain;
    given.reading.apply(plain.reading);
    for (const std::string& file : given.heights) {
        all.push_back(plain);
        all.back().height = file;
        if (file.empty()) throw InputError("--height", Message(MessageId::FileMissing));
    }
    for (const std::string& recipe : given.recipes) {
        all.push_back(plain);
        applyRecipe(all.back(), recipe);
    }
    if (!all.empty()) return all;
    for (const char* name : kDefaultReliefs) {
        all.push_back(plain);
        all.back().recipe = name;
        all.back().recipeWidth = all.back().recipeHeight = kDefaultSide;
    }
    return all;
}

std::string pictureName(const Pictures& pictures) {
    if (!pictures.height.empty()) return pictures.height;
    return pictures.recipe + ":" + std::to_string(pictures.recipeWidth) + "x" + std::to_string(pictures.recipeHeight) +
           ":" + std::to_string(pictures.seed);
}

void loadMaps(const std::vector<Pictures>& pictures, BenchOptions& options, Session& session) {
    for (const Pictures& one : pictures) {
        Scenario scenario;
        scenario.pictures = one;
        AssetStore store;
        const Assets assets = store.load(one, session.work());
        noteHeights(session, assets, scenario);
        options.maps.push_back({pictureName(one), assets.heights});
    }
}

BenchOptions benchOptions(const BenchCommandOptions& given) {
    BenchOptions options;
    if (given.tracers) {
        for (const std::string& text : splitText(*given.tracers, ',')) {
            options.methods.push_back(measuredMethod(parseMethodChoice(text, "--tracers")));
        }
    } else {
        options.methods = defaultMethods();
    }
    if (given.elevations) {
        options.elevations.clear();
        for (const std::string& text : splitText(*given.elevations, ',')) {
            options.elevations.push_back(parseElevation(text, "--elevations"));
        }
    }
    if (given.lowest) {
        const double lowest = parseNumber(*given.lowest, "--lowest");
        options.lowestRandom = *parseElevation(numberText(lowest), "--lowest");
    }
    if (given.rays) options.rays = static_cast<std::size_t>(parseWhole(*given.rays, "--rays", 1, kMostRays));
    if (given.rounds) options.rounds = static_cast<int>(parseWhole(*given.rounds, "--rounds", 1, kMostRounds));
    if (given.seed) options.seed = parseSeed(*given.seed, "--seed");
    if (given.surface) options.surface = parseSurface(*given.surface);
    if (given.address) options.address = parseAddress(*given.address);
    if (given.reliefDepth) {
        Scenario scenario;
        const std::string option = "--relief-depth";
        setScenarioNumber(scenario, "relief-depth", parseNumber(*given.reliefDepth, option), option);
        options.reliefDepth = scenario.reliefDepth;
    }
    return options;
}

int runBench(const BenchCommandOptions& given, Session& session) {
    given.run.apply(session);
    const std::string& kind = needed(given.kind, "KIND", "bench");
    if (kind != "tracers" && kind != "rows" && kind != "filters") {
        throw InputError("", Message(MessageId::UnknownName,
                                     {{"what", "benchmark"}, {"name", kind}, {"known", "tracers, rows, filters"}}));
    }
    if (given.output) checkOutput(*given.output, {"csv", "json"});
    if (kind == "rows") return given.rows.run(given.elevations, given.rounds, given.output, session);
    if (kind == "filters") {
        const bool own = !given.heights.empty() || !given.recipes.empty();
        return given.filters.run(own ? chosenPictures(given) : std::vector<Pictures>{}, given.elevations,
                                 given.reliefDepth, given.rounds, given.seed, given.output, session);
    }
    BenchOptions options = benchOptions(given);
    loadMaps(chosenPictures(given), options, session);
    options.onNote = [&](const Message& message) { session.note("bench", message); };
    const BenchTexts<BenchRow> texts{benchCsvHeader, benchCsvLine, benchJson, benchText};
    return runBenchTo<BenchRow>(given.output, texts, session, [&](std::function<void(const BenchRow&)> onRow) {
        options.onRow = std::move(onRow);
        return benchTracers(options, session.work());
    });
}

void addWhat(CLI::App& parser, BenchCommandOptions& options) {
    const char* group = "What is measured";
    addTexts(parser, "--height", options.heights, "FILE", "height map; may be repeated", group);
    addTexts(parser, "--relief", options.recipes, "NAME[:WxH[:SEED]]",
             "procedural relief; may be repeated; default: bricks, city, fractal, hills, pits, spikes, 256x256", group);
    addText(parser, "--tracers", options.tracers, "NAME,...",
            "methods, each with options as NAME:OPTION=VALUE:OPTION=VALUE, such as exact,layers:layers=128; default: "
            "all tracers as relief list tells them",
            group);
    addText(parser, "--elevations", options.elevations, "DEGREES,...",
            "from which the relief is seen, " + numberText(kLowestElevation) +
                " to 90, neighbouring rays as a picture has them; random: entry, azimuth and elevation at random; "
                "default 80,60,25,8,2,random; rows (of the row's middle) and filters: default 60,25,8",
            group);
    addText(parser, "--lowest", options.lowest, "DEGREES", "elevation of the flattest random rays, default 1", group);
    addText(parser, "--surface", options.surface, "bilinear|columns", "default bilinear", group);
    addText(parser, "--address", options.address, "repeat|clamp|border", "default repeat", group);
    addText(parser, "--relief-depth", options.reliefDepth, "D", "texture widths, 0 to 4, default 0.1", group);
}

}  // namespace

void addBenchCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<BenchCommandOptions>();
    CLI::App* parser = addCommand(
        program, "bench", "run time against error, measured",
        "tracers: measures how fast each tracer is and how far it is from the exact answer, on the same rays: a line "
        "for each "
        "height map, elevation and method. Rate: rays a second, the median of rounds over all methods in turn; spread: "
        "(p75 - p25) / median; errors: |lambda difference| x max(1, hypot(a, b)), texels, against exact; overshoots: "
        "hits later than exact's, or misses where exact hits. On a terminal a table, elsewhere CSV. With -o the rows "
        "also go to FILE.part as they come, which is kept if the run is broken off.\n"
        "rows: texture coordinates along rows of a wall of 4,096 texels that fills the row, seen from 0.55 of its "
        "width "
        "at each elevation: operations a pixel, pixels a second, largest error in texels; derivatives: of the "
        "footprint's ellipse.\n"
        "filters: the colour alone, against the supersampled picture of the same view: pixels a second, errors in "
        "linear light against each pixel model, texels read, traced back, hidden and skipped a pixel.",
        "  relief bench tracers --relief bricks --tracers exact,max-pyramid,layers:layers=128 -o bench.csv\n"
        "  relief bench rows --widths 3840 --variants direct,streams,subspan:error=0.25\n"
        "  relief bench filters --scenes bricks --elevations 25 -o filters.csv");
    addArgument(*parser, "KIND", options->kind, "tracers, rows or filters");
    addWhat(*parser, *options);
    options->rows.add(*parser);
    options->filters.add(*parser);
    options->reading.add(*parser);
    addText(*parser, "--rays", options->rays, "N",
            "of a line, default 65536; fewer, with a message, where the exact reference would take too long", "Run");
    addText(*parser, "--rounds", options->rounds, "N", "timed rounds, default 5", "Run");
    addText(*parser, "--seed", options->seed, "S", "of the rays, default 1", "Run");
    addOutput(*parser, options->output, "table: .csv or .json");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runBench(*options, session); }});
}

}  // namespace relief::app
