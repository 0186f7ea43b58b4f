// relief render [SCENARIO.json] [options] -o FILE [--layers NAME,...] [--report FILE.json | --part K/N]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include <nlohmann/json.hpp>

#include "measuring/base_level_measure.h"
#include "options_common.h"
#include "output.h"
#include "part.h"
#include "render_many.h"
#include "rendering/skip_ledger.h"

namespace relief::app {

namespace {

using Clock = std::chrono::steady_clock;

struct RenderOptions {
    ScenarioOptions scenario;
    ManyFrames many;
    OptionText output, layers, report, part;
    RunOptions run;
};

// Wall-clock time of the command's parts.
struct Seconds {
    double load = 0;
    double render = 0;
    double count = 0;  // steps and reads, for reports and the layer of steps
    double write = 0;  // layers made, too
};

template <class Body>
auto timed(double& seconds, const Body& body) {
    struct Stop {
        double& seconds;
        Clock::time_point begin = Clock::now();
        ~Stop() { seconds += std::chrono::duration<double>(Clock::now() - begin).count(); }
    };
    const Stop stop{seconds};
    return body();
}

// Empty where no layers were asked for.
std::vector<std::string> checkedLayers(const RenderOptions& options, const std::string& output) {
    if (!options.layers) return {};
    if (fileEnding(output) != "exr") throw InputError(output, Message(MessageId::LayersNeedExr));
    std::vector<std::string> layers = splitText(*options.layers, ',');
    std::string known;
    for (const std::string& name : layerNames()) known += (known.empty() ? "" : ", ") + name;
    for (const std::string& layer : layers) {
        const auto& names = layerNames();
        if (std::count(layers.begin(), layers.end(), layer) > 1) {
            throw InputError("--layers", Message(MessageId::LayerRepeated, {{"layer", layer}}));
        }
        if (std::find(names.begin(), names.end(), layer) != names.end()) continue;
        throw InputError("--layers",
                         Message(MessageId::UnknownName, {{"what", "layer"}, {"name", layer}, {"known", known}}));
    }
    return layers;
}

// Counts are whole numbers, kept as doubles.
Json countJson(double value) {
    constexpr double kExact = 9007199254740992.0;
    return value == std::floor(value) && std::abs(value) < kExact ? Json(static_cast<std::int64_t>(value))
                                                                  : Json(value);
}

// Of base=auto: the level, and what it costs and gains.
Json baseJson(const BaseLevelMeasure& measure) {
    const auto row = [](const BenchRow& of) {
        return Json{{"rate", of.rate},
                    {"spread", of.spread},
                    {"error_mean", of.errors.mean},
                    {"error_p9999", of.errors.p9999},
                    {"error_max", of.errors.max},
                    {"steps_mean", of.stepsMean},
                    {"reads_mean", of.readsMean}};
    };
    return {{"level", measure.footprint.level},
            {"pixel_texels", measure.footprint.pixelTexels},
            {"measured", row(measure.based)},
            {"level_0", row(measure.whole)}};
}

Json stagesJson(const Frame& frame, bool shadows) {
    Json stages = Json::array();
    for (std::size_t s = 0; s < kStages; ++s) {
        if (static_cast<Stage>(s) == Stage::Shadows && !shadows) continue;
        stages.push_back(
            {{"name", kStageNames[s]}, {"seconds", frame.stages[s].seconds}, {"reused", frame.stages[s].reused}});
    }
    return stages;
}

Json skippedJson(const Frame& frame, const FrameRequest& request, const BoundedError& error, Language language) {
    Json skipped{{"lossless", Json::array()}, {"bounded", Json::array()}};
    for (const SkipRow& row : skipLedger(frame, request)) {
        const char* const ledger = row.ledger == Ledger::Lossless ? "lossless" : "bounded";
        skipped[ledger].push_back({{"name", row.name},
                                   {"what", sentence(row.what, language)},
                                   {"count", countJson(row.count)},
                                   {"of", countJson(row.of)},
                                   {"why", sentence(row.why, language)}});
    }
    if (!(request.bounded > 0)) return skipped;
    for (Json& row : skipped["bounded"]) {
        row["bound_texels"] = request.bounded;
        if (row["name"] == "little-parallax") {
            row["error_texels"] = {{"mean", error.rayMean}, {"max", error.rayMax}};
            row["wrong_outcomes"] = error.wrongOutcomes;
        } else {
            row["error_linear"] = {{"mean", error.colorMean}, {"max", error.colorMax}};
        }
    }
    return skipped;
}

// path: of the report; pictures near it are named relative to it, as in a scenario's own file.
std::string reportText(const std::string& path, const Scenario& scenario, const Frame& frame, const Json& skipped,
                       const Json& base, Session& session, const Seconds& seconds) {
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    std::map<std::string, double> counters = session.work().counters().values();
    for (const auto& [name, value] : frame.counters) counters[name] = value;
    const auto taken = [&](const char* name) {
        const auto found = counters.find(name);
        const double value = found == counters.end() ? 0 : found->second;
        if (found != counters.end()) counters.erase(found);
        return value;
    };
    Json report{{"tool", "relief"},
                {"version", RELIEF_VERSION},
                {"scenario", Json::parse(scenarioText(scenario, folder.string()))},
                {"threads", session.work().threads().size()}};
    report["maps"] = {{"builds", countJson(taken("map builds"))},
                      {"bytes", countJson(taken("map bytes"))},
                      {"build_seconds", taken("map build seconds")}};
    for (const auto& [name, value] : counters) report["counters"][name] = countJson(value);
    if (!base.is_null()) report["base"] = base;
    report["stages"] = stagesJson(frame, scenario.shadows);
    report["skipped"] = skipped;
    report["seconds"] = {{"load", seconds.load},
                         {"render", seconds.render},
                         {"count", seconds.count},
                         {"write", seconds.write},
                         {"total", seconds.load + seconds.render + seconds.count + seconds.write}};
    return report.dump(2) + "\n";
}

// All that the picture depends on: of the pictures that it is made of what is in them, not their names, which may
// differ from machine to machine. map: the argument that names a stored map.
Json pictureOptions(const Scenario& scenario, const Assets& assets, const std::vector<std::string>& layers,
                    const std::string& map) {
    Scenario plain = withNotesOf(scenario, Scenario());
    plain.pixel.reset();
    plain.other = {};
    plain.comparison = {};
    for (std::string* name : {&plain.pictures.height, &plain.pictures.color, &plain.pictures.normal}) name->clear();
    Json options = Json::parse(scenarioText(plain));
    const auto hashed = [](const auto& picture) {
        return picture ? Json(hashText(std::as_bytes(picture->pixels()))) : Json();
    };
    options["heights"] = hashed(assets.heights);
    options["color"] = hashed(assets.color);
    options["normals"] = hashed(assets.normals);
    options["layers"] = layers;
    options["map"] = map;
    return options;
}

// The rows of a part, with the text that merging needs.
PictureBand partBand(const PartNumber& number, const FrameRequest& request, Json options) {
    const RowRange rows = partRows(number, request.height);
    const std::string cells = std::to_string(request.width) + "x" + std::to_string(request.height);
    Part part;
    static_cast<PartNumber&>(part) = number;
    part.run = runJson("render", std::move(options), {&cells, 1});
    part.more = {{"first", rows.begin}, {"end", rows.end}, {"height", request.height}};
    return {rows.begin, rows.end, partLine(part)};
}

// One picture, or a band of it, rendered and written.
int renderOne(const RenderOptions& options, const std::string& output, const std::vector<std::string>& layers,
              const PartNumber& number, Session& session) {
    Scenario scenario = options.scenario.scenario();
    Seconds seconds;
    AssetStore store;
    const Assets assets = timed(seconds.load, [&] { return store.load(scenario.pictures, session.work()); });
    noteHeights(session, assets, scenario);
    const auto maps = std::make_shared<MapCache>();
    timed(seconds.load, [&] { options.scenario.useStoredMap(scenario, assets, *maps, session.work()); });
    FrameRenderer renderer(maps);
    const FrameRequest request = frameRequest(scenario, assets);
    requirePictureMemory(request, layers, session);
    noteBaseLevel(session, scenario, request);
    std::optional<LayerPlanes> planes;
    if (!layers.empty()) planes.emplace(request, layers, *maps);
    BoundedSums bounded;
    PictureParts parts;
    PictureBand band;
    if (options.part) {
        band = partBand(number, request, pictureOptions(scenario, assets, layers, options.scenario.mapArgument()));
        parts.wanted = {band.begin, band.end};
    }
    const bool wantsSteps = std::find(layers.begin(), layers.end(), "steps") != layers.end();
    parts.counts = options.report || wantsSteps;
    parts.done = [&](const Frame& part) {
        if (planes) timed(seconds.write, [&] { planes->add(part, request, session.work()); });
        if (!options.report || !(request.bounded > 0)) return;
        timed(seconds.count, [&] { bounded.add(part, request, *maps, session.work()); });
    };
    const auto frame = timed(seconds.render, [&] { return renderer.picture(request, session.work(), parts); });
    seconds.count += frame->countSeconds;
    seconds.render -= seconds.count + seconds.write;
    timed(seconds.write, [&] {
        const PictureBand* const rows = options.part ? &band : nullptr;
        if (planes) {
            writePlanes(output, planes->take(*frame), rows);
        } else {
            writeColor(output, frame->light->color, rows);
        }
    });
    if (!options.report) return 0;
    TextOutput report(*options.report, session.stop());
    const Json skipped = skippedJson(*frame, request, bounded.error(), session.language());
    Json base;
    if (const auto measure = measureBaseLevel(request, scenario.method, *maps, session.work())) {
        session.note("--set", baseLevelSentence(*measure));
        base = baseJson(*measure);
    }
    report.write(reportText(*options.report, scenario, *frame, skipped, base, session, seconds));
    report.commit();
    return 0;
}

int runRender(const RenderOptions& options, Session& session) {
    options.run.apply(session);
    const std::string& output = needed(options.output, "--output", "render");
    const PartNumber number = options.part ? parsePartNumber(*options.part) : PartNumber();
    if (options.report && (options.part || options.many.wanted())) {
        const char* const other = options.part ? "--part" : "--frames";
        throw InputError("--report", Message(MessageId::ArgumentsExclude, {{"other", other}}));
    }
    if (options.many.wanted()) {
        return options.many.run(options.scenario, output, checkedLayers(options, "picture.exr"), number, session);
    }
    std::vector<std::string> endings{"png", "tif", "tiff", "exr"};
    if (!options.part) endings.insert(endings.end(), {"jpg", "jpeg", "bmp", "hdr"});
    checkOutput(output, endings);
    const std::vector<std::string> layers = checkedLayers(options, output);
    if (options.report && *options.report != "-") checkOutput(*options.report, {"json"});
    return renderOne(options, output, layers, number, session);
}

}  // namespace

void addRenderCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* parser = addCommand(
        program, "render", "render a picture of a relief",
        "Renders what a camera sees of a floor, a wall or a cube that carries the relief. What is looked at comes from "
        "a scenario, from the options, or from both (the options override). The same input gives the same bytes on any "
        "number of threads.",
        "  relief render --height heights.png --color color.jpg --scene wall \\\n"
        "      --camera elevation=20,azimuth=30,distance=1.4 --size 800x600 -o wall.png --report wall.json");
    options->scenario.add(*parser, ScenarioOptions::Look::Yes);
    options->many.add(*parser);
    addOutput(*parser, options->output, "the picture: .png, .jpg, .tif, .bmp (sRGB), .exr, .hdr (linear)");
    std::string layers;
    for (const std::string& name : layerNames()) layers += (layers.empty() ? "" : ", ") + name;
    addText(*parser, "--layers", options->layers, "NAME,...",
            "write these planes into the .exr instead of the picture alone: " + layers, "Output");
    addText(*parser, "--part", options->part, "K/N",
            "only part K, from 1, of N, for other processes to make the others: of one picture (.png, .tif, .exr) that "
            "band of its rows, which relief merge puts together; of many pictures each N-th",
            "Output");
    addText(*parser, "--report", options->report, "FILE.json",
            "what was done and what was skipped: the scenario, counters, maps built, seconds of every stage; - for "
            "standard output",
            "Output");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runRender(*options, session); }});
}

}  // namespace relief::app
