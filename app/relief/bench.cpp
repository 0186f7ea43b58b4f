// relief bench tracers | rows | filters [PICTURE ...] [-o FILE.csv|json] [--resume|--anew]
#include <algorithm>
#include <set>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "bench_filters.h"
#include "bench_output.h"
#include "bench_rows.h"
#include "measuring/bench/bench_tracers.h"
#include "options_common.h"
#include "relief/reliefs.h"
#include "relief/tracers/tile_methods.h"
#include "tiles_report.h"

namespace relief::app {

namespace {

constexpr std::int64_t kMostRays = 1 << 26;
constexpr std::int64_t kMostRounds = 1000;
constexpr std::int64_t kMostThreads = 1024;
constexpr int kDefaultSide = 256;
constexpr const char* kDefaultReliefs[] = {"bricks", "city", "fractal", "hills", "pits", "spikes"};

struct BenchCommandOptions {
    OptionText kind, tracers, elevations, lowest, rays, rounds, seed, surface, address, reliefDepth, output;
    OptionText sizes, threadCounts, form, concurrent, part, memory;
    RestartOptions restart;
    std::vector<std::string> files, heights, recipes;
    ReadingOptions reading;
    RowBenchCommand rows;
    FilterBenchCommand filters;
    RunOptions run;
    const CLI::App* parser = nullptr;  // to find out which options were given
};

std::vector<Pictures> chosenPictures(const BenchCommandOptions& given) {
    std::vector<Pictures> all;
    Pictures plain;
    given.reading.apply(plain.reading);
    if (given.memory) plain.memory = parseTileMemory(*given.memory);
    const std::vector<std::string> sizes = given.sizes ? splitText(*given.sizes, ',') : std::vector<std::string>{};
    for (const std::string& size : sizes) parseSize(size, "--sizes", kMaxReliefSide);  // throws
    const auto addSized = [&](const std::string& recipe) {
        for (const std::string& size : sizes) {
            all.push_back(plain);
            applyRecipe(all.back(), recipe + ":" + size);
        }
    };
    std::vector<std::string> files = given.heights;
    files.insert(files.end(), given.files.begin(), given.files.end());
    for (const std::string& file : files) {
        all.push_back(plain);
        all.back().height = file;
        if (file.empty()) throw InputError("--height", Message(MessageId::FileMissing));
    }
    for (const std::string& recipe : given.recipes) {
        if (!sizes.empty() && recipe.find(':') == std::string::npos) {
            addSized(recipe);
            continue;
        }
        all.push_back(plain);
        applyRecipe(all.back(), recipe);
    }
    if (!all.empty()) return all;
    for (const char* name : kDefaultReliefs) {
        if (!sizes.empty()) {
            addSized(name);
            continue;
        }
        all.push_back(plain);
        all.back().recipe = name;
        all.back().recipeWidth = all.back().recipeHeight = kDefaultSide;
    }
    return all;
}

// A height map of the sweep. Files are read at once, so that faults show early; procedural reliefs are generated when
// they are measured.
struct SweepMap {
    Pictures pictures;
    std::string name;
    std::shared_ptr<const FloatImage> heights;
    std::shared_ptr<const TiledHeights> tiles;  // in their place

    // Text that differs if any height differs.
    std::string content() const {
        if (tiles) return ":" + tilesHash(*tiles);
        return heights ? ":" + contentText(*heights) : "";
    }
};

std::vector<SweepMap> sweepMaps(const std::vector<Pictures>& pictures, Session& session) {
    std::vector<SweepMap> maps;
    for (const Pictures& one : pictures) {
        maps.push_back({one, heightsName(one), nullptr, nullptr});
        if (one.height.empty() && one.drawn.empty()) {
            checkRecipeSize(findRecipe(one.recipe, {}), one.recipeWidth, one.recipeHeight);
            continue;
        }
        Scenario scenario;
        scenario.pictures = one;
        AssetStore store;
        const Assets assets = store.load(one, session.work(), true);
        noteHeights(session, assets, scenario);
        maps.back().heights = assets.heights;
        maps.back().tiles = assets.tiles;
    }
    return maps;
}

// Returns the heights of a map and caches the relief generated last: cells of one map follow each other.
class HeightsOf {
  public:
    std::shared_ptr<const FloatImage> operator()(const SweepMap& map) {
        if (map.heights || map.tiles) return map.heights;
        if (made_ == nullptr || name_ != map.name) {
            made_.reset();
            const Pictures& p = map.pictures;
            made_ = std::make_shared<FloatImage>(makeRelief(p.recipe, p.recipeWidth, p.recipeHeight, p.seed));
            name_ = map.name;
        }
        return made_;
    }

  private:
    std::string name_;
    std::shared_ptr<const FloatImage> made_;
};

std::vector<std::uint64_t> chosenSeeds(const BenchCommandOptions& given) {
    if (!given.seed) return {1};
    std::vector<std::uint64_t> seeds;
    for (const std::string& text : splitText(*given.seed, ',')) seeds.push_back(parseSeed(text, "--seed"));
    return seeds;
}

// Returns {0}, which stands for the session's number of threads, if no numbers were given.
std::vector<int> chosenThreads(const BenchCommandOptions& given) {
    if (!given.threadCounts) return {0};
    std::vector<int> counts;
    for (const std::string& text : splitText(*given.threadCounts, ',')) {
        counts.push_back(static_cast<int>(parseWhole(text, "--thread-counts", 1, kMostThreads)));
    }
    return counts;
}

Form formOf(const BenchCommandOptions& given) {
    return given.form ? parseForm(*given.form, "--form") : Form::Simd;
}

BenchOptions benchOptions(const BenchCommandOptions& given) {
    BenchOptions options;
    const Form form = formOf(given);
    if (given.tracers) {
        for (const std::string& text : splitText(*given.tracers, ',')) {
            options.methods.push_back(measuredMethod(parseMethodChoice(text, "--tracers"), form));
        }
    } else {
        options.methods = defaultMethods(form);
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

// Returns everything that the rows depend on, except what distinguishes one cell from another.
Json sweepText(const BenchCommandOptions& given, const BenchOptions& options, const Session& session) {
    Json what{{"kind", "tracers"},
              {"rays", options.rays},
              {"rounds", options.rounds},
              {"lowest", options.lowestRandom},
              {"surface", std::string(surfaceName(options.surface))},
              {"address", std::string(addressName(options.address))},
              {"relief depth", options.reliefDepth},
              {"threads", session.threads()},
              {"tracers", given.tracers.value_or("")}};
    // Written only if they are not the default, so that sweeps of the first version can be resumed.
    if (formOf(given) == Form::Scalar) what["form"] = formName(Form::Scalar);
    if (given.memory) what["memory"] = parseTileMemory(*given.memory);
    return what;
}

int runTracers(const BenchCommandOptions& given, BenchRun to, Session& session) {
    BenchOptions options = benchOptions(given);
    const std::vector<std::uint64_t> seeds = chosenSeeds(given);
    const std::vector<int> threadCounts = chosenThreads(given);
    std::set<std::string> printed;  // each note is printed once, not in every cell
    options.onNote = [&](const Message& message) {
        if (printed.insert(sentence(message)).second) session.note("bench", message);
    };
    // Maps that were built while other ranks were working are built again for timing.
    std::shared_ptr<PreparedTracers> counted = noPreparedTracers(), timed = noPreparedTracers();
    to.what = sweepText(given, options, session);
    HeightsOf heightsOf;
    const std::vector<SweepMap> maps = sweepMaps(chosenPictures(given), session);
    for (const SweepMap& map : maps) {
        if (!map.tiles) continue;
        // Without --tracers, all that can.
        if (!given.tracers) std::erase_if(options.methods, [](const auto& one) { return !tracesTiles(one.choice); });
        for (const MeasuredMethod& method : options.methods) requireTiles(method.choice, *map.tiles);
    }
    std::vector<BenchCell<BenchRow>> cells;
    for (const SweepMap& map : maps) {
        const std::string name = map.name + map.content();
        for (const int threads : threadCounts) {
            for (const std::uint64_t seed : seeds) {
                for (const Elevation& elevation : options.elevations) {
                    cells.push_back({name + "," + std::to_string(threads) + "," + std::to_string(seed) + "," +
                                         elevationText(elevation),
                                     threads, [&, seed, elevation](Work& work, BenchPass pass) {
                                         BenchOptions one = options;
                                         one.pass = pass;
                                         if (pass != BenchPass::Counts) counted = noPreparedTracers();
                                         one.prepared = pass == BenchPass::Counts ? counted : timed;
                                         one.maps = {{map.name, heightsOf(map), map.tiles}};
                                         one.seed = seed;
                                         one.elevations = {elevation};
                                         return benchTracers(one, work);
                                     }});
                }
            }
        }
    }
    return runCells<BenchRow>(to, {benchCsvHeader, benchJson, benchText}, cells, session);
}

// Throws InputError if an option of another kind is given. The name of such an option's group ends in the kinds that
// take it, such as "(tracers, filters)".
void refuseOthers(const CLI::App& parser, const std::string& kind) {
    for (const CLI::Option* option : parser.get_options()) {
        const std::string& group = option->get_group();
        const std::size_t open = group.find('(');
        if (option->count() == 0 || open == std::string::npos || group.find(kind, open) != std::string::npos) continue;
        std::string others;
        for (const std::string& other : splitText(group.substr(open + 1, group.size() - open - 2), ',')) {
            others += (others.empty() ? "relief bench " : ", relief bench") + other;
        }
        throw InputError(
            option->get_positional() ? option->results().front() : option->get_name(),
            Message(MessageId::ArgumentOfOther, {{"others", others}, {"command", "relief bench " + kind}}));
    }
}

int runBench(const BenchCommandOptions& given, Session& session) {
    given.run.apply(session, given.part.has_value());
    const std::string& kind = needed(given.kind, "KIND", "bench");
    if (kind != "tracers" && kind != "rows" && kind != "filters") {
        throw InputError("", unknownName({"what", MessageId::WordBenchmark}, kind, "tracers, rows, filters"));
    }
    refuseOthers(*given.parser, kind);
    if (given.output && leadsRun(given.part.has_value())) checkOutput(*given.output, {"csv", "json"});
    BenchRun to{given.output, given.restart.chosen(), {}, {}, {{"kind", kind}}};
    if (given.concurrent) {
        if (!given.part && launchedProcesses() < 2) {
            throw InputError("--concurrent", Message(MessageId::NeedsArgument, {{"other", "mpirun, --part"}}));
        }
        to.concurrent = static_cast<int>(parseWhole(*given.concurrent, "--concurrent", 1, kMostThreads));
    }
    if (given.part) {
        to.part = parsePartNumber(*given.part);
        checkOutput(needed(given.output, "--output", "bench"), {"csv"});
    }
    if (kind == "rows") return given.rows.run(given.elevations, given.rounds, to, session);
    if (kind == "tracers") return runTracers(given, to, session);
    const bool own = !given.files.empty() || !given.heights.empty() || !given.recipes.empty();
    if (given.filters.color && !own) {
        throw InputError("--color", Message(MessageId::NeedsArgument, {{"other", "--height, --relief"}}));
    }
    return given.filters.run(own ? chosenPictures(given) : std::vector<Pictures>{}, given.elevations, given.reliefDepth,
                             given.rounds, given.seed, to, session);
}

constexpr const char* kMaps = "Height maps (tracers, filters)";

void addMaps(CLI::App& parser, BenchCommandOptions& options) {
    addTexts(parser, "FILE", options.files, "", "height maps", kMaps)->allow_extra_args(true);
    addTexts(parser, "--height", options.heights, "FILE", "height map; may be repeated", kMaps);
    addTexts(parser, "--relief", options.recipes, "NAME[:SIZE[:SEED]]",
             "procedural relief; may be repeated; default: bricks, city, fractal, hills, pits, spikes, 256x256", kMaps);
    addText(parser, "--sizes", options.sizes, "WxH|N,...",
            "sizes of the reliefs that are named without a size, texels, such as 256,4096; N: N x N; default 256",
            kMaps);
    addText(parser, "--relief-depth", options.reliefDepth, "D",
            "thickness of the relief slab, texture widths, 0 to 4, default 0.1", kMaps);
    options.reading.add(parser, kMaps);
}

void addTracers(CLI::App& parser, BenchCommandOptions& options) {
    const char* group = "Measurement (tracers)";
    addText(parser, "--tracers", options.tracers, "NAME,...",
            "methods, each with options as NAME:OPTION=VALUE:OPTION=VALUE, such as exact,layers:layers=128; default: "
            "all tracers of relief list",
            group);
    addText(parser, "--form", options.form, "simd|scalar",
            "simd (default): the SIMD version, if a method has one (see relief list); scalar: only the reference "
            "implementations, without the maps of SIMD versions. The table's column form shows which was measured",
            group);
    addText(parser, "--lowest", options.lowest, "DEGREES", "lowest elevation of the random rays, degrees, default 1",
            group);
    addText(parser, "--surface", options.surface, "bilinear|columns", "surface between texels, default bilinear",
            group);
    addText(parser, "--address", options.address, "repeat|clamp|border",
            "relief outside the height maps, default repeat", group);
    addText(
        parser, "--rays", options.rays, "N",
        "rays per line of the table, default 65536; fewer, with a message, if the exact reference would take too long",
        group);
    addText(parser, "--memory", options.memory, "MB",
            "height maps written by relief tile are read by tiles, each within this much memory, by the methods that "
            "can (see relief list); default: they are read as a whole",
            group);
    addText(parser, "--thread-counts", options.threadCounts, "N,...",
            "numbers of threads to measure, instead of --threads", group);
}

}  // namespace

void addBenchCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<BenchCommandOptions>();
    CLI::App* parser = addCommand(
        program, "bench", "measure run time and error of tracers, filters and row methods",
        "tracers: measures the speed of each tracer and its distance from the exact answer on the same rays, one line "
        "for each height map, elevation and method. Rate: rays per second, the median of rounds over all methods in "
        "turn; spread: (p75 - p25) / median; errors: |lambda difference| x max(1, hypot(a, b)), texels, compared with "
        "exact; overshoots: hits later than those of exact, or misses where exact hits. The output is a table on a "
        "terminal and CSV elsewhere. With -o finished parts are kept in FILE.part: if the run is stopped or killed, "
        "--resume continues it and --anew starts again. mpirun -n N relief bench ... shares the measurements among N "
        "processes: errors and steps are counted by any free process, then each machine times one method at a time, "
        "including the building of its map, while its other processes wait. Only rank 0 writes; the others need no "
        "common folder.\n"
        "rows: measures texture coordinates along rows of a wall of 4,096 texels that fills the row, seen from 0.55 of "
        "its width at each elevation: operations per pixel, pixels per second, largest error in texels; the "
        "derivatives-* variants compute the footprint's ellipse.\n"
        "filters: measures the filters alone, compared with the supersampled picture of the same view: pixels per "
        "second, errors in linear light for each pixel model, and texels sampled, traced back, hidden and skipped per "
        "pixel.",
        "  relief bench tracers --relief bricks --tracers exact,max-pyramid,layers:layers=128 -o bench.csv\n"
        "  relief bench rows --widths 3840 --variants direct,streams,subspan:error=0.25\n"
        "  relief bench filters --scenes bricks --elevations 25 -o filters.csv");
    addArgument(*parser, "KIND", options->kind, "tracers, rows or filters");
    options->parser = parser;
    addMaps(*parser, *options);
    addTracers(*parser, *options);
    options->rows.add(*parser);
    options->filters.add(*parser);
    addText(*parser, "--elevations", options->elevations, "DEGREES,...",
            "elevations from which the relief is seen, degrees, " + numberText(kLowestElevation) +
                " to 90, with neighbouring rays as in a picture; random: random entry, azimuth and elevation; default "
                "80,60,25,8,2,random; for rows (at the middle of the row) and filters: default 60,25,8",
            "Run");
    addText(*parser, "--rounds", options->rounds, "N", "number of timed rounds, default 5", "Run");
    addText(*parser, "--seed", options->seed, "S",
            "seed of the rays, default 1; tracers: several, separated by commas, are measured one by one",
            "Random numbers (tracers, filters)");
    addText(*parser, "--concurrent", options->concurrent, "N",
            "with mpirun: number of methods that a machine times at once, default 1; with --part: number of parts that "
            "you run at once on a machine, which is not checked. The table's column concurrent holds this number and "
            "is empty if a part was started without it",
            "Run");
    addText(*parser, "--part", options->part, "K/N",
            "measure only part K, from 1, of N, which is every N-th measurement; needs -o FILE.csv; relief merge joins "
            "the parts",
            "Run");
    options->restart.add(*parser, "with -o", "Run");
    addOutput(*parser, options->output, "file of the table: .csv or .json");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runBench(*options, session); }});
}

}  // namespace relief::app
