#include "one_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

#include "images/picture_layout.h"
#include "measuring/bench/base_level_measure.h"
#include "output.h"
#include "part.h"
#include "render_many.h"
#include "rendering/ellipse_error.h"
#include "rendering/skip_ledger.h"
#include "tiles_report.h"

namespace relief::app {

namespace {

using Clock = std::chrono::steady_clock;

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
                       const OnePicture::Seconds& seconds) {
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

// map: a hash of the stored map, or empty.
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

}  // namespace

OnePicture::OnePicture(const ScenarioOptions& options, Scenario scenario, std::vector<std::string> layers, bool reports,
                       Session& session)
    : layers_(std::move(layers)), reports_(reports), session_(session), scenario_(std::move(scenario)) {
    assets_ = timed(seconds_.load, [&] { return store_.load(scenario_.pictures, session_.work(), true); });
    noteHeights(session_, assets_, scenario_);
    timed(seconds_.load, [&] { options.useStoredMap(scenario_, assets_, *maps_, session_.work()); });
    map_ = options.mapContent();
    request_.emplace(frameRequest(scenario_, assets_));
    noteBaseLevel(session_, scenario_, *request_);
}

std::vector<std::string> OnePicture::channels() const {
    return layers_.empty() ? std::vector<std::string>{"R", "G", "B"} : layerPlaneNames(layers_);
}

void OnePicture::requireMemory(RowRange rows, bool tiled) const {
    // Reports are of pictures in one piece.
    const MemoryHint hint = tiled || reports_ ? MemoryHint::SmallerSize : MemoryHint::SmallerOrTiled;
    requirePictureMemory(*request_, layers_, {rows, tiled, hint}, session_);
}

Json OnePicture::run() const {
    const std::string cells = std::to_string(request_->width) + "x" + std::to_string(request_->height);
    return runJson("render", pictureOptions(scenario_, assets_, layers_, map_), {&cells, 1});
}

std::vector<NamedPlane> OnePicture::make(RowRange rows, Work& work) {
    std::optional<LayerPlanes> planes;
    if (!layers_.empty()) planes.emplace(*request_, layers_, *maps_, rows);
    PictureParts parts;
    parts.onlyRows = rows;
    const bool wantsSteps = std::find(layers_.begin(), layers_.end(), "steps") != layers_.end();
    parts.counts = reports_ || wantsSteps;
    parts.done = [&](const Frame& part) {
        if (planes) timed(seconds_.write, [&] { planes->add(part, *request_, work); });
        if (!reports_) return;
        timed(seconds_.count, [&] {
            ellipseError_ = std::max(ellipseError_, ellipseError(part, *request_, work));
            if (request_->bounded > 0) bounded_.add(part, *request_, *maps_, work);
        });
    };
    frame_ = timed(seconds_.render, [&] { return renderer_.picture(*request_, work, parts); });
    seconds_.count += frame_->countSeconds;
    seconds_.render -= seconds_.count + seconds_.write;
    return planes ? timed(seconds_.write, [&] { return planes->take(*frame_); }) : std::vector<NamedPlane>();
}

void OnePicture::write(const std::string& output, RowRange rows, const std::string& text, Work& work) {
    const std::vector<NamedPlane> planes = make(rows, work);
    timed(seconds_.write, [&] {
        if (layers_.empty())
            writeColor(output, frame_->light->color, text);
        else
            writePlanes(output, planes, text);
    });
}

std::vector<std::byte> OnePicture::numbers(RowRange rows, bool floats, Work& work) {
    const std::vector<NamedPlane> planes = make(rows, work);
    return layers_.empty() ? colorNumbers(frame_->light->color, floats) : planeNumbers(planes);
}

void OnePicture::noteTilesRead() {
    const auto rays = static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
    if (assets_.tiles) noteTiles(session_, *assets_.tiles, rays);
}

void OnePicture::report(const std::string& path) {
    TextOutput report(path, session_.stop());
    const Json skipped = skippedJson(*frame_, *request_, bounded_.error(), session_.language());
    Json base;
    if (const auto measure = measureBaseLevel(*request_, scenario_.method, *maps_, session_.work())) {
        session_.note("--set", baseLevelSentence(*measure));
        base = baseJson(*measure);
    }
    const auto rays = static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
    const Json tiles = assets_.tiles ? tilesJson(*assets_.tiles, rays) : Json();
    report.write(reportText(path, scenario_, *frame_, skipped, base, tiles, ellipseError_, session_, seconds_));
    report.commit();
}

}  // namespace relief::app
