// Files written by earlier versions of the program (tests/files/vN) can be read and mean the same.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "measuring/bench/bench_filters.h"
#include "measuring/bench/bench_rows.h"
#include "measuring/bench/bench_tracers.h"
#include "measuring/bench/pareto.h"
#include "relief/tracers/map_choice.h"
#include "scenario/ray_files.h"
#include "scenario/scenario.h"

namespace relief::test {
namespace {

namespace fs = std::filesystem;

const fs::path kVersion1 = fs::path(RELIEF_FILES) / "v1";
constexpr double kSameHit = 1e-9;      // in lambda
constexpr double kSamePicture = 0.01;  // mean difference of linear colours: a filter may be improved
// Relaxed cones that are built today end behind every spike that a ray touches, not only where rounding had it so: only
// a map stored then gives the hits of then.
constexpr const char* kBuiltOtherwise = "relaxed-cone";
constexpr double kSamePictureBuiltOtherwise = 0.03;
constexpr std::size_t kMapBytes = 1 << 24;

// Returns the files in a folder ("" for the root) with that ending; sorted.
std::vector<fs::path> filesOf(const std::string& folder, const std::string& ending) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(kVersion1 / folder)) {
        if (entry.is_regular_file() && entry.path().extension() == ending) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string textOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::vector<std::string>> rowsOf(const fs::path& path) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream text(textOf(path));
    for (std::string line; std::getline(text, line);) {
        rows.emplace_back();
        std::istringstream fields(line);
        for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
    }
    return rows;
}

// Returns the scenario files, including the report.
std::vector<fs::path> scenarios() {
    std::vector<fs::path> files = filesOf("", ".json");
    std::erase(files, kVersion1 / "report.json");
    return files;
}

void expectSamePicture(const Scenario& scenario, const fs::path& before) {
    Work work;
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work);
    FrameRenderer renderer(std::make_shared<MapCache>());
    const ColorImage now = renderer.render(frameRequest(scenario, assets), work)->light->color;
    const ColorImage then = readColor(before.string(), work);
    ASSERT_EQ(now.width(), then.width());
    ASSERT_EQ(now.height(), then.height());
    double difference = 0;
    for (int y = 0; y < now.height(); ++y) {
        for (int x = 0; x < now.width(); ++x) {
            for (int c = 0; c < 3; ++c) difference += std::abs(std::clamp(now(x, y)[c], 0.0F, 1.0F) - then(x, y)[c]);
        }
    }
    const bool otherwise = scenario.method.name == kBuiltOtherwise;
    EXPECT_LT(difference / (3.0 * now.width() * now.height()), otherwise ? kSamePictureBuiltOtherwise : kSamePicture);
}

// Files traced/hits-NAME.csv and traced/steps-NAME.* were written by `relief trace` with this method over
// pictures/height.png.
struct Traced {
    MethodChoice method;
    std::string map;  // stored in maps/NAME.tif, of this kind; empty: none
    Address address = Address::Repeat;
};

const std::map<std::string, Traced>& traced() {
    static const std::map<std::string, Traced> all{
        {"exact", {{"exact", {}}, ""}},
        {"max-pyramid", {{"max-pyramid", {}}, ""}},
        {"layers", {{"layers", {{"layers", "12"}}}, ""}},
        {"offset", {{"offset", {}}, ""}},
        {"border", {{"max-pyramid", {}}, "", Address::Border}},
        {"limit", {{"cone-dummer", {{"iterations", "1"}}}, ""}},
        // Written before these options existed: all iterations, with distances between the voxels' centres.
        {"euclidean",
         {{"distance", {{"layers", "8"}, {"iterations", "8"}, {"stop", "never"}, {"to", "voxel"}}}, "euclidean"}},
        {"euclidean-conservative",
         {{"distance-conservative", {{"footprint", "2"}, {"layers", "8"}, {"precision", "u16"}}},
          "euclidean-conservative"}},
        {"refined-sampled",
         {{"distance-refined-sampled",
           {{"footprint", "4"}, {"layers", "8"}, {"directions", "32"}, {"iterations", "8"}, {"stop", "never"}}},
          "refined-sampled"}},
        {"refined", {{"distance-refined", {{"layers", "8"}, {"sectors", "4"}, {"precision", "u8"}}}, "refined"}},
        {"cone", {{"cone", {}}, "cone"}},
        {"cone-sectors", {{"cone", {{"sectors", "4"}, {"precision", "u16"}}}, "cone"}},
        {"cone-dummer", {{"cone-dummer", {{"precision", "u8"}, {"iterations", "8"}}}, "cone-dummer"}},
        {"relaxed-cone", {{"relaxed-cone", {{"radius", "16"}, {"bisections", "4"}}}, "relaxed-cone"}},
    };
    return all;
}

// Returns "cone" for "hits-cone.csv".
std::string nameOf(const fs::path& file) {
    const std::string stem = file.stem().string();
    return stem.substr(stem.find('-') + 1);
}

class OldFiles : public testing::Test {
  protected:
    RayBlock rays() const { return parseRays(textOf(kVersion1 / "traced/rays.csv"), "rays.csv"); }
    HeightField field(Address address) { return HeightField(heights_, Surface::Bilinear, address, 0.2); }
    HitBlock hitsBy(const MethodChoice& method, const HeightField& field, MapCache& maps, StepLog* log = nullptr) {
        HitBlock hits;
        StepLog unwanted;
        makeTracer(method, field, maps, work_)->trace(rays(), hits, log != nullptr ? *log : unwanted, work_);
        return hits;
    }
    // Compares with the file's hits. Rays flatter than a sampled refined map supports were marched through the map; now
    // they are traced exactly.
    void expectHits(const HitBlock& hits, const Traced& how, const fs::path& file) {
        const auto rows = rowsOf(file);
        ASSERT_EQ(rows.size(), hits.size() + 1);
        EXPECT_EQ(rows[0], (std::vector<std::string>{"outcome", "lambda", "s", "t", "steps"}));
        const HeightField on = field(how.address);
        const double served = on.slabTexels() / std::tan(10 * std::numbers::pi / 180);
        MapCache maps;
        const HitBlock exact = hitsBy({"exact", {}}, on, maps);
        const RayBlock all = rays();
        for (std::size_t r = 0; r < hits.size(); ++r) {
            const auto& row = rows[r + 1];
            if (std::string(how.map) == "refined-sampled" && std::hypot(all.a[r], all.b[r]) > served) {
                EXPECT_EQ(hits.outcome[r], exact.outcome[r]) << "ray " << r;
                if (exact.outcome[r] == Outcome::Hit) {
                    EXPECT_EQ(hits.lambda[r], exact.lambda[r]) << "ray " << r;
                }
                continue;
            }
            EXPECT_EQ(row.at(0), outcomeName(hits.outcome[r])) << "ray " << r;
            if (hits.outcome[r] != Outcome::Hit || row.at(0) != "hit") continue;
            EXPECT_NEAR(std::stod(row.at(1)), hits.lambda[r], kSameHit) << "ray " << r;
            EXPECT_NEAR(std::stod(row.at(2)), hits.s[r], kSameHit * 100) << "ray " << r;
            EXPECT_NEAR(std::stod(row.at(3)), hits.t[r], kSameHit * 100) << "ray " << r;
        }
    }

    Work work_{1};
    std::shared_ptr<const FloatImage> heights_ =
        std::make_shared<FloatImage>(readHeight((kVersion1 / "pictures/height.png").string(), {}, work_).heights);
};

TEST_F(OldFiles, NoneIsForgotten) {
    std::map<std::string, int> count;
    for (const auto& entry : fs::recursive_directory_iterator(kVersion1)) {
        if (!entry.is_regular_file()) continue;
        const fs::path file = fs::relative(entry.path(), kVersion1);
        ++count[file.parent_path().string() + "/*" + file.extension().string()];
    }
    // A test below reads each kind of file. (tables/*.journal is read by tests/cmd/sweep_test.cpp; README and written/
    // are not read.)
    const std::map<std::string, int> known{
        {"/*.json", 40},       {"/*.md", 1},           {"lessons/*.json", 9}, {"maps/*.tif", 8},
        {"pictures/*.png", 3}, {"rendered/*.png", 36}, {"tables/*.csv", 3},   {"tables/*.journal", 1},
        {"tables/*.json", 1},  {"traced/*.csv", 18},   {"traced/*.json", 11}, {"written/*.json", 1},
        {"written/*.sh", 1}};
    EXPECT_EQ(count, known);
}

TEST_F(OldFiles, ScenariosLookAsTheyDid) {
    std::set<fs::path> pictures;
    for (const fs::path& file : scenarios()) {
        SCOPED_TRACE(file.filename());
        const Scenario scenario = loadScenario(file.string());
        EXPECT_EQ(parseScenario(scenarioText(scenario), "s.json"), scenario);
        const fs::path picture = kVersion1 / "rendered" / (file.stem().string() + ".png");
        if (!fs::exists(picture)) continue;
        expectSamePicture(scenario, picture);
        pictures.insert(picture);
    }
    EXPECT_EQ(pictures.size() + 1, filesOf("rendered", ".png").size()) << "one more is the report's";
}

TEST_F(OldFiles, ScenarioOfTheWindowMeansWhatItMeant) {
    const Scenario read = loadScenario((kVersion1 / "window.json").string());
    Scenario s;
    s.pictures.height = s.pictures.color = (kVersion1 / "pictures/color.png").string();
    s.pictures.normal = (kVersion1 / "pictures/normal.png").string();
    s.pictures.reading = {"G", true, {HeightRange::Kind::Bounds, 0.125, 0.75}, 100000};
    EXPECT_EQ(read.pictures, s.pictures);
    EXPECT_EQ(read.reliefDepth, 0.17);
    EXPECT_EQ(read.address, Address::Clamp);
    EXPECT_EQ(read.surface, Surface::Columns);
    EXPECT_EQ(read.method, (MethodChoice{"layers-bisection", {{"layers", "48"}, {"bisections", "5"}}}));
    EXPECT_EQ(read.filter.name, "elliptical-visible");
    EXPECT_EQ(read.filter.options, (OptionValues{{"form", "rays"}, {"samples", "12"}, {"weights", "gaussian"}}));
    EXPECT_EQ(read.scene, SceneKind::Wall);
    s.camera.kind = Camera::Kind::Free;
    s.camera.eye = {0.3, 0.25, 1.1};
    s.camera.target = {0.05, 0.02, 0.01};
    s.camera.fov = 37;
    EXPECT_EQ(read.camera, s.camera);
    EXPECT_EQ(read.light.azimuth, -33);
    EXPECT_EQ(read.light.elevation, 52);
    EXPECT_EQ(read.light.ambient, 0.15);
    EXPECT_EQ(read.light.intensity, 1.3);
    EXPECT_TRUE(read.shadows);
    EXPECT_FALSE(read.skip);
    EXPECT_EQ(read.bounded, 0.25);
    EXPECT_EQ(read.sky, (std::array{0.1, 0.2, 0.3}));
    EXPECT_EQ(read.width, 48);
    EXPECT_EQ(read.height, 36);
    EXPECT_EQ(read.pixel, (PixelChoice{30, 17}));
    EXPECT_EQ(read.step, 3);
}

TEST_F(OldFiles, NotesOfTheWindowMeanWhatTheyMeant) {
    const Scenario read = loadScenario((kVersion1 / "window.json").string());
    Comparison comparison;
    comparison.others = {{"exact", {}}, {"cone", {{"sectors", "4"}}}, {"offset", {}}};
    comparison.mode = CompareMode::Swipe;
    comparison.measure = CompareMeasure::L1;
    comparison.reference = CompareReference::MethodA;
    comparison.dividers = {0.2, 0.5, 0.8};
    comparison.rate = 3;
    EXPECT_EQ(read.comparison, comparison);
    EXPECT_NE(read.ui.find("euclidean-conservative"), std::string::npos) << "the window's own";
    const std::vector<Breakpoint> breakpoints{{StopKind::LevelBelow, 3},
                                              {StopKind::Texel, 1, 4, -2},
                                              {StopKind::RayBelow, 2, 0, 0, 0.25},
                                              {StopKind::Overshoot, 2, 0, 0, 0.5, false},
                                              {StopKind::Disagreement}};
    EXPECT_EQ(read.breakpoints, breakpoints);
    ASSERT_EQ(read.bookmarks.size(), 2U);
    Bookmark bookmark{"шпиль", {11, 12}, {}, 4};
    bookmark.camera.elevation = 33;
    bookmark.camera.azimuth = -44;
    bookmark.camera.distance = 1.25;
    bookmark.camera.target = {0.1, 0, -0.1};
    bookmark.camera.fov = 50;
    EXPECT_EQ(read.bookmarks[0], bookmark);
    EXPECT_EQ(read.bookmarks[1].camera.kind, Camera::Kind::Free);
    EXPECT_EQ(read.bookmarks[1].pixel, (PixelChoice{0, 35}));
    const std::string traced = (kVersion1 / "traced").string();
    EXPECT_EQ(read.other, (OtherTracer{traced + "/rays.csv", traced + "/steps-exact.json", 2, false}));
}

TEST_F(OldFiles, WordsOfComparisonsMeanWhatTheyMeant) {
    const auto notes = [](int number) {
        return loadScenario((kVersion1 / ("notes-" + std::to_string(number) + ".json")).string());
    };
    EXPECT_EQ(notes(1).comparison.mode, CompareMode::Flicker);
    EXPECT_EQ(notes(2).comparison.mode, CompareMode::Difference);
    EXPECT_EQ(notes(3).comparison.mode, CompareMode::Tiles);
    EXPECT_EQ(notes(1).comparison.measure, CompareMeasure::Flip);
    EXPECT_EQ(notes(1).comparison.reference, CompareReference::Exact);
}

TEST_F(OldFiles, TheWitnessShowsAnUnsafeMap) {
    const Scenario scenario = loadScenario((kVersion1 / "witness.json").string());
    AssetStore store;
    const FrameRequest request = frameRequest(scenario, store.load(scenario.pictures, work_));
    ASSERT_TRUE(scenario.pixel);
    const auto ray = pixelRay(request, scenario.pixel->x, scenario.pixel->y);
    ASSERT_TRUE(ray);
    RayBlock block;
    block.push(*ray);
    HitBlock unsafe, exact;
    NullSink none;
    MapCache maps;
    makeTracer(scenario.method, request.field, maps, work_)->trace(block, unsafe, none, work_);
    makeTracer({"exact", {}}, request.field, maps, work_)->trace(block, exact, none, work_);
    EXPECT_GT(unsafe.lambda[0], exact.lambda[0] + 1e-3);
}

TEST_F(OldFiles, ReportsHoldTheirScenario) {
    const auto report = nlohmann::ordered_json::parse(textOf(kVersion1 / "report.json"));
    EXPECT_EQ(report["tool"], "relief");
    const Scenario scenario = parseScenario(report["scenario"].dump(), (kVersion1 / "report.json").string());
    EXPECT_EQ(loadScenario((kVersion1 / "report.json").string()), scenario);
    EXPECT_EQ(scenario.method.name, "cone");
    EXPECT_TRUE(scenario.shadows);
    EXPECT_EQ(scenario.pictures.height, (kVersion1 / "pictures/height.png").string());
    expectSamePicture(scenario, kVersion1 / "rendered/report.png");
}

TEST_F(OldFiles, LessonsStandAtAStepOfTheirRay) {
    for (const fs::path& file : filesOf("lessons", ".json")) {
        SCOPED_TRACE(file.filename());
        const Scenario scenario = loadScenario(file.string());
        AssetStore store;
        const FrameRequest request = frameRequest(scenario, store.load(scenario.pictures, work_));
        ASSERT_TRUE(scenario.pixel);
        const auto ray = pixelRay(request, scenario.pixel->x, scenario.pixel->y);
        ASSERT_TRUE(ray);
        RayBlock block;
        block.push(*ray);
        HitBlock hits;
        StepLog log;
        MapCache maps;
        makeTracer(scenario.method, request.field, maps, work_)->trace(block, hits, log, work_);
        // These may contain a step beyond the log's end; the window then selects the last step.
        if (scenario.method.name == "max-pyramid") {
            EXPECT_GT(log.steps.size(), 1U);
        } else {
            EXPECT_LT(static_cast<std::size_t>(scenario.step), log.steps.size());
        }
    }
}

TEST_F(OldFiles, HitsAreThoseOfToday) {
    for (const fs::path& file : filesOf("traced", ".csv")) {
        if (!file.filename().string().starts_with("hits-")) continue;
        SCOPED_TRACE(file.filename());
        const Traced& how = traced().at(nameOf(file));
        if (how.method.name == kBuiltOtherwise) continue;
        MapCache maps;
        expectHits(hitsBy(how.method, field(how.address), maps), how, file);
    }
}

TEST_F(OldFiles, MapsGiveTheHitsThatTheyGaveAndThoseOfMapsBuiltNow) {
    for (const fs::path& file : filesOf("maps", ".tif")) {
        SCOPED_TRACE(file.filename());
        const Traced& how = traced().at(file.stem().string());
        const HeightField on = field(how.address);
        const StoredMap map = loadMap(file.string(), on, kMapBytes, work_);
        EXPECT_EQ(mapKindName(map), how.map);
        MapCache stored;
        const MethodChoice choice = useMap(file.string(), map, how.method, on, stored);
        const HitBlock hits = hitsBy(choice, on, stored);
        expectHits(hits, how, kVersion1 / "traced" / ("hits-" + file.stem().string() + ".csv"));
        if (how.method.name == kBuiltOtherwise) continue;
        MapCache fresh;
        const HitBlock now = hitsBy(how.method, on, fresh);
        for (std::size_t r = 0; r < hits.size(); ++r) {
            EXPECT_EQ(hits.outcome[r], now.outcome[r]);
            if (hits.outcome[r] != Outcome::Hit) continue;
            EXPECT_NEAR(hits.lambda[r], now.lambda[r], kSameHit);
        }
    }
}

TEST_F(OldFiles, StepsLeadToTheirHits) {
    std::vector<fs::path> files = filesOf("traced", ".json");
    const auto tables = filesOf("traced", ".csv");
    files.insert(files.end(), tables.begin(), tables.end());
    std::size_t read = 0;
    for (const fs::path& file : files) {
        if (!file.filename().string().starts_with("steps-")) continue;
        SCOPED_TRACE(file.filename());
        const Traced& how = traced().at(nameOf(file));
        const RayBlock all = rays();
        const StepLog log = parseSteps(textOf(file), file.string(), all.size());
        ASSERT_EQ(log.rays(), all.size());
        HitBlock hits(all.size());
        const auto rows = rowsOf(kVersion1 / "traced" / ("hits-" + nameOf(file) + ".csv"));
        for (std::size_t r = 0; r < all.size(); ++r) {
            const auto first = log.steps.begin() + static_cast<std::ptrdiff_t>(log.begin[r]);
            std::vector<Step> steps(first, log.steps.begin() + static_cast<std::ptrdiff_t>(log.begin[r + 1]));
            placeSteps(steps, all[r], field(how.address), file.string(), r);
            hits.set(r, answerOf(steps, all[r]));
            EXPECT_EQ(rows.at(r + 1).at(4), std::to_string(steps.size()));
            EXPECT_EQ(steps.front().decision, Decision::Start);
        }
        Traced asWritten = how;
        asWritten.map = "";
        expectHits(hits, asWritten, kVersion1 / "traced" / ("hits-" + nameOf(file) + ".csv"));
        ++read;
    }
    EXPECT_EQ(read, traced().size());
}

TEST_F(OldFiles, TablesAreReadAndTheirColumnsAreStillThere) {
    const std::vector<BenchRow> rows = readBenchTable((kVersion1 / "tables/tracers.json").string());
    ASSERT_EQ(rows.size(), 12U);
    // The file has no forms: the default form was measured.
    for (const BenchRow& row : rows) {
        EXPECT_EQ(row.form, methodForm(row.method));
        EXPECT_EQ(row.form, row.method.name == "exact" ? Form::Scalar : Form::Simd) << row.method.name;
    }
    const ParetoTable table = paretoTable(chosenRows(rows, "bricks:16x16:1", "60"));
    EXPECT_EQ(chosenRows(rows, "bricks:16x16", "60").size(), chosenRows(rows, "bricks:16x16:1", "60").size());
    ASSERT_EQ(table.points.size(), 3U);
    EXPECT_EQ(table.points[0].method.name, "exact");
    EXPECT_EQ(table.points[0].errorOf(ErrorMeasure::Max), 0);
    EXPECT_EQ(table.points[1].method, (MethodChoice{"layers", {{"layers", "12"}}}));
    EXPECT_GT(table.points[1].errorOf(ErrorMeasure::Mean), 0.01);
    const std::map<std::string, std::string> headers{
        {"tracers", benchCsvHeader()}, {"rows", rowBenchCsvHeader()}, {"filters", filterBenchCsvHeader()}};
    for (const fs::path& file : filesOf("tables", ".csv")) {
        // New columns may have been added; the command adds the last three where they are missing.
        std::istringstream today(headers.at(file.stem().string()) + ",compiler,cpu,commit");
        const std::vector<std::string> columns = rowsOf(file).at(0);
        for (const std::string& column : columns) {
            std::string next;
            while (std::getline(today, next, ',') && next.substr(0, next.find('\n')) != column) {
            }
            EXPECT_TRUE(today) << file.filename() << " had a column " << column;
        }
    }
}

}  // namespace
}  // namespace relief::test
