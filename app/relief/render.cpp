// relief render [PICTURE | SCENARIO.json] [options] -o FILE [--layers NAME,...] [--report FILE.json | --part K/N]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include <nlohmann/json.hpp>

#include "images/picture_bands.h"
#include "measuring/bench/base_level_measure.h"
#include "options_common.h"
#include "output.h"
#include "part.h"
#include "parts_run.h"
#include "render_many.h"
#include "rendering/ellipse_error.h"
#include "rendering/skip_ledger.h"
#include "scratch_folder.h"
#include "team.h"
#include "tiles_report.h"

namespace relief::app {

namespace {

using Clock = std::chrono::steady_clock;

struct RenderOptions {
    ScenarioOptions scenario;
    ManyFrames many;
    OptionText output, layers, report, part;
    RunOptions run;
};

// Wall-clock time of the command's stages.
struct Seconds {
    double load = 0;
    double render = 0;
    double count = 0;  // counting steps and reads, for reports and the layer of steps
    double write = 0;  // includes making the layers
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

// Empty if no layers were requested.
std::vector<std::string> checkedLayers(const RenderOptions& options, const std::string& output) {
    if (!options.layers) return {};
    if (fileEnding(output) != "exr") throw InputError(output, Message(MessageId::LayersNeedExr));
    std::vector<std::string> layers = splitText(*options.layers, ',');
    const std::string known = commaList(layerNames());
    for (const std::string& layer : layers) {
        const auto& names = layerNames();
        if (std::count(layers.begin(), layers.end(), layer) > 1) {
            throw InputError("--layers", Message(MessageId::LayerRepeated, {{"layer", layer}}));
        }
        if (std::find(names.begin(), names.end(), layer) != names.end()) continue;
        throw InputError("--layers", unknownName({"what", MessageId::WordLayer}, layer, known));
    }
    return layers;
}

// Counts are integers, stored as doubles.
Json countJson(double value) {
    constexpr double kExact = 9007199254740992.0;
    return value == std::floor(value) && std::abs(value) < kExact ? Json(static_cast<std::int64_t>(value))
                                                                  : Json(value);
}

// Returns the level that base=auto selected, and what it costs and gains.
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
        stages.push_back({{"name", messageTemplate(kStageNames[s], Language::English)},
                          {"seconds", frame.stages[s].seconds},
                          {"reused", frame.stages[s].reused}});
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

// path: the report's file; pictures are named relative to its folder, as in a scenario's file.
std::string reportText(const std::string& path, const Scenario& scenario, const Frame& frame, const Json& skipped,
                       const Json& base, const Json& tiles, double axisDifference, Session& session,
                       const Seconds& seconds) {
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    std::map<MessageId, double> counters = session.work().counters().values();
    for (const auto& [what, value] : frame.counters) counters[what] = value;
    const auto taken = [&](MessageId what) {
        const auto found = counters.find(what);
        const double value = found == counters.end() ? 0 : found->second;
        if (found != counters.end()) counters.erase(found);
        return value;
    };
    Json report{{"tool", "relief"},
                {"version", RELIEF_VERSION},
                {"scenario", Json::parse(scenarioText(scenario, folder.string()))},
                {"threads", session.work().threads().size()}};
    // The algorithm that found the hits within the reported time, and the one whose steps are counted. They differ if
    // the frame uses another exact algorithm because it is faster; the hits are the same.
    report["walks"] = {{"hits", frame.tracedBy}, {"steps", scenario.method.name}};
    // off_direct_texels: the largest distance, in texels, of the texture coordinates from those of `direct`. Displaced
    // triangles are not mapped row by row.
    if (findTracer(scenario.method.name).kind != MethodKind::Mesh) {
        report["mapping"] = {{"name", scenario.mapping}, {"off_direct_texels", frame.mappingOff}};
    }
    // off_direct: the largest relative difference of a footprint's semi-axis from that of ellipse=direct.
    const OptionValues& usual = findFilter(scenario.filter.name).defaults;
    if (const auto ellipse = usual.find("ellipse"); ellipse != usual.end()) {
        const auto given = scenario.filter.options.find("ellipse");
        report["ellipse"] = {{"name", (given == scenario.filter.options.end() ? ellipse : given)->second},
                             {"off_direct", axisDifference}};
    }
    report["maps"] = {{"builds", countJson(taken(MessageId::CountMapBuilds))},
                      {"bytes", countJson(taken(MessageId::CountMapBytes))},
                      {"build_seconds", taken(MessageId::CountMapSeconds)}};
    for (const auto& [what, value] : counters) {
        report["counters"][std::string(messageTemplate(what, Language::English))] = countJson(value);
    }
    if (!base.is_null()) report["base"] = base;
    if (!tiles.is_null()) report["tiles"] = tiles;
    report["stages"] = stagesJson(frame, scenario.shadows);
    report["skipped"] = skipped;
    report["seconds"] = {{"load", seconds.load},
                         {"render", seconds.render},
                         {"count", seconds.count},
                         {"write", seconds.write},
                         {"total", seconds.load + seconds.render + seconds.count + seconds.write}};
    return report.dump(2) + "\n";
}

// Returns everything that the picture depends on. Input pictures are identified by content, not by name, which may
// differ between machines. map: a hash of the stored map, or empty.
Json pictureOptions(const Scenario& scenario, const Assets& assets, const std::vector<std::string>& layers,
                    const std::string& map) {
    Scenario plain = withNotesOf(scenario, Scenario());
    plain.pixel.reset();
    plain.pictures.memory = 0;
    plain.other = {};
    plain.comparison = {};
    for (std::string* name : {&plain.pictures.height, &plain.pictures.color, &plain.pictures.normal}) name->clear();
    Json options = Json::parse(scenarioText(plain));
    const auto hashed = [](const auto& picture) {
        return picture ? Json(hashText(std::as_bytes(picture->pixels()))) : Json();
    };
    options["heights"] = assets.tiles ? Json(tilesHash(*assets.tiles)) : hashed(assets.heights);
    options["color"] = hashed(assets.color);
    options["normals"] = hashed(assets.normals);
    options["layers"] = layers;
    options["map"] = map;
    return options;
}

// Returns the rows of a part, with the metadata that `relief merge` needs.
PictureBand partBand(const PartNumber& number, const FrameRequest& request, Json options) {
    const RowRange rows = partRows(number, request.height);
    const std::string cells = std::to_string(request.width) + "x" + std::to_string(request.height);
    Part part;
    static_cast<PartNumber&>(part) = number;
    part.run = runJson("render", std::move(options), {&cells, 1});
    part.more = {{"first", rows.begin}, {"end", rows.end}, {"height", request.height}};
    return {rows.begin, rows.end, partLine(part)};
}

// One picture, rendered whole or in bands; its inputs are loaded once.
class OnePicture {
  public:
    OnePicture(const RenderOptions& options, std::vector<std::string> layers, Session& session)
        : options_(options), layers_(std::move(layers)), session_(session), scenario_(options.scenario.scenario()) {
        assets_ = timed(seconds_.load, [&] { return store_.load(scenario_.pictures, session_.work(), true); });
        noteHeights(session_, assets_, scenario_);
        timed(seconds_.load, [&] { options_.scenario.useStoredMap(scenario_, assets_, *maps_, session_.work()); });
        request_.emplace(frameRequest(scenario_, assets_));
        requirePictureMemory(*request_, layers_, session_);
        noteBaseLevel(session_, scenario_, *request_);
    }

    int height() const { return request_->height; }
    std::size_t rays() const {
        return static_cast<std::size_t>(request_->width) * static_cast<std::size_t>(request_->height);
    }
    PictureBand part(const PartNumber& number) const {
        return partBand(number, *request_, pictureOptions(scenario_, assets_, layers_, options_.scenario.mapContent()));
    }

    // band: the rows to render; null: the whole picture.
    void render(const std::string& output, const PictureBand* band, Work& work) {
        std::optional<LayerPlanes> planes;
        if (!layers_.empty()) planes.emplace(*request_, layers_, *maps_);
        PictureParts parts;
        if (band != nullptr) parts.onlyRows = {band->begin, band->end};
        const bool wantsSteps = std::find(layers_.begin(), layers_.end(), "steps") != layers_.end();
        parts.counts = options_.report || wantsSteps;
        parts.done = [&](const Frame& part) {
            if (planes) timed(seconds_.write, [&] { planes->add(part, *request_, work); });
            if (!options_.report) return;
            timed(seconds_.count, [&] {
                ellipseError_ = std::max(ellipseError_, ellipseError(part, *request_, work));
                if (request_->bounded > 0) bounded_.add(part, *request_, *maps_, work);
            });
        };
        frame_ = timed(seconds_.render, [&] { return renderer_.picture(*request_, work, parts); });
        seconds_.count += frame_->countSeconds;
        seconds_.render -= seconds_.count + seconds_.write;
        timed(seconds_.write, [&] {
            if (planes) {
                writePlanes(output, planes->take(*frame_), band);
            } else {
                writeColor(output, frame_->light->color, band);
            }
        });
        if (assets_.tiles) noteTiles(session_, *assets_.tiles, rays());
    }

    // Writes the report. To be called after render() of the whole picture.
    void report(const std::string& path) {
        TextOutput report(path, session_.stop());
        const Json skipped = skippedJson(*frame_, *request_, bounded_.error(), session_.language());
        Json base;
        if (const auto measure = measureBaseLevel(*request_, scenario_.method, *maps_, session_.work())) {
            session_.note("--set", baseLevelSentence(*measure));
            base = baseJson(*measure);
        }
        const Json tiles = assets_.tiles ? tilesJson(*assets_.tiles, rays()) : Json();
        report.write(reportText(path, scenario_, *frame_, skipped, base, tiles, ellipseError_, session_, seconds_));
        report.commit();
    }

  private:
    const RenderOptions& options_;
    std::vector<std::string> layers_;
    Session& session_;
    Scenario scenario_;
    Seconds seconds_;
    AssetStore store_;
    Assets assets_;
    std::shared_ptr<MapCache> maps_ = std::make_shared<MapCache>();
    FrameRenderer renderer_{maps_};
    std::optional<FrameRequest> request_;
    BoundedSums bounded_;
    double ellipseError_ = 0;
    std::shared_ptr<const Frame> frame_;
};

// Renders the picture in bands shared by the ranks of an MPI run; rank 0 joins them. There are more bands than ranks,
// because some bands cost more than others.
void renderShared(const RenderOptions& options, const std::string& output, const std::vector<std::string>& layers,
                  Session& session) {
    constexpr int kBandsEach = 4;
    OnePicture picture(options, layers, session);
    const int bands = std::min(picture.height(), kBandsEach * launchedProcesses());
    const std::string ending = "." + fileEnding(output);
    const ScratchFolder scratch;
    const auto bandPath = [&](std::size_t band) { return scratch.path(std::to_string(band) + ending); };
    PartsRun run;
    run.bar = "render";
    run.parts = static_cast<std::size_t>(bands);
    run.measure = [&](const Task& task, Work& work) -> Json {
        const RowRange rows = partRows({static_cast<int>(task.part) + 1, bands}, picture.height());
        const PictureBand band{rows.begin, rows.end, {}};
        picture.render(bandPath(task.part), &band, work);
        return launchedRank() == 0 ? Json() : ScratchFolder::take(bandPath(task.part));
    };
    run.received = [&](std::size_t band, Json result) -> Json {
        if (result.is_binary()) writeBytes(bandPath(band), result.get_binary());
        return nullptr;
    };
    if (!doParts(run, session)) return;
    std::vector<std::string> files;
    for (std::size_t band = 0; band < run.parts; ++band) files.push_back(bandPath(band));
    joinBands(files, output, session.work());
}

int runRender(const RenderOptions& options, Session& session) {
    options.run.apply(session, options.part.has_value());
    const std::string& output = needed(options.output, "--output", "render");
    const PartNumber number = options.part ? parsePartNumber(*options.part) : PartNumber();
    const bool shared = launchedProcesses() > 1 && !options.part && !options.many.requested();
    if (options.report && (options.part || options.many.requested() || shared)) {
        const char* const other = options.part ? "--part" : shared ? "mpirun" : "--frames";
        throw InputError("--report", Message(MessageId::ArgumentsExclude, {{"other", other}}));
    }
    if (options.many.requested()) {
        return options.many.run(options.scenario, output, checkedLayers(options, "picture.exr"), number, session);
    }
    std::vector<std::string> endings{"png", "tif", "tiff", "exr"};
    if (!options.part && !shared) endings.insert(endings.end(), {"jpg", "jpeg", "bmp", "hdr"});
    if (leadsRun(options.part.has_value())) checkOutput(output, endings);
    const std::vector<std::string> layers = checkedLayers(options, output);
    if (options.report && *options.report != "-") checkOutput(*options.report, {"json"});
    if (shared) {
        renderShared(options, output, layers, session);
        return 0;
    }
    OnePicture picture(options, layers, session);
    const PictureBand band = options.part ? picture.part(number) : PictureBand();
    picture.render(output, options.part ? &band : nullptr, session.work());
    if (options.report) picture.report(*options.report);
    return 0;
}

}  // namespace

void addRenderCommand(CLI::App& program, Commands& commands) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* parser =
        addCommand(program, "render", "render a picture of a relief",
                   "Renders a floor, a wall or a cube that carries the relief of a height map, as seen by a camera. "
                   "Scene, camera and methods come from a scenario, from options, or from both; options override the "
                   "scenario. The same input gives the same pixels on any number of threads. mpirun -n N relief render "
                   "... shares one picture (.png, .tif, .exr) or many among N processes.",
                   "  relief render heights.png --color color.jpg --scene wall \\\n"
                   "      --camera elevation=20,azimuth=30,distance=1.4 --size 800x600 -o wall.png --report wall.json");
    options->scenario.add(*parser, ScenarioOptions::OptionGroups::All);
    options->scenario.addMemory(*parser);
    options->many.add(*parser);
    addOutput(*parser, options->output, "file of the picture: .png, .jpg, .tif, .bmp (sRGB), .exr, .hdr (linear)");
    addText(*parser, "--layers", options->layers, "NAME,...",
            "layers to write into the .exr instead of only the picture: " + commaList(layerNames()), "Output");
    addText(*parser, "--part", options->part, "K/N",
            "render only part K, from 1, of N, so that other processes can render the other parts. One picture (.png, "
            ".tif, .exr): a band of its rows; relief merge joins them. Many pictures: every N-th one",
            "Output");
    addText(
        *parser, "--report", options->report, "FILE.json",
        "report of the work done and skipped: scenario, counters, maps built, seconds per stage; - for standard output",
        "Output");
    options->run.add(*parser);
    commands.push_back({parser, [options](Session& session) { return runRender(*options, session); }});
}

}  // namespace relief::app
