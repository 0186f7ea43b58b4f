// Work that a frame skips: losslessly, with the same bits in every stage; or within an error bound.
#include <gtest/gtest.h>

#include <filesystem>

#include "algorithms/relief/fields.h"
#include "filtering/surface_pieces.h"
#include "relief/reliefs.h"
#include "rendering/flat_ground.h"
#include "rendering/skip_ledger.h"
#include "scenario/scenario.h"

namespace relief::test {
namespace {

std::shared_ptr<const Frame> rendered(const FrameRequest& request, int threads = 2) {
    Work work(threads);
    return FrameRenderer(std::make_shared<MapCache>()).render(request, work);
}

void expectSameBits(const Frame& a, const Frame& b, const FrameRequest& request) {
    EXPECT_EQ(a.rays->polygon, b.rays->polygon);
    EXPECT_EQ(a.rays->inverseDepth, b.rays->inverseDepth);
    std::size_t wrong = 0;
    std::size_t darker = 0;
    const glm::vec3 light(lightDirection(request.light));
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t i = a.index(x, y);
            wrong += sameBits(a.hits->hits[i], b.hits->hits[i]) ? 0 : 1;
            if (a.shadows->shadowed.empty() || a.hits->hits.outcome[i] != Outcome::Hit) continue;
            // Where the surface faces away from the light, visibility is not computed and does not matter.
            if (glm::dot(a.normal(x, y, request), light) <= 0) continue;
            darker += a.shadows->shadowed[i] == b.shadows->shadowed[i] ? 0 : 1;
        }
    }
    EXPECT_EQ(wrong, 0U);
    EXPECT_EQ(darker, 0U);
    EXPECT_TRUE(a.color->color == b.color->color);
    EXPECT_TRUE(a.light->color == b.light->color);
}

FrameRequest small(HeightField field, SceneKind scene = SceneKind::Floor) {
    FrameRequest request(std::move(field));
    request.width = 96;
    request.height = 72;
    request.scene = scene;
    request.shadows = true;
    request.light.elevation = 20;
    return request;
}

// Plateaus, walls and slopes: some ground is flat, at three heights.
std::shared_ptr<const FloatImage> terraces() {
    FloatImage heights(48, 40, 0.25F);
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 48; ++x) {
            if (x >= 8 && x < 22 && y >= 6 && y < 30) heights(x, y) = 0.8F;
            if (x >= 30) heights(x, y) = static_cast<float>(x - 30) / 17;
            if (x >= 24 && x < 28) heights(x, y) = 1;
        }
    }
    return share(std::move(heights));
}

double counted(const Frame& frame, MessageId what) {
    const auto found = frame.counters.find(what);
    return found == frame.counters.end() ? 0 : found->second;
}

// With every surface, address, scene and method: no bit changes, and some work was skipped.
TEST(Skip, noBitChangesOverScenesAndMethods) {
    double flat = 0;
    for (const MethodDescription& method : tracerList()) {
        for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
            for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
                if (!supports({method.name, {}}, surface, address)) continue;
                const auto scene = static_cast<SceneKind>((static_cast<int>(surface) + static_cast<int>(address)) % 3);
                SCOPED_TRACE(method.name + " " + std::string(addressName(address)) + " " +
                             std::string(sceneName(scene)));
                FrameRequest request = small(HeightField(terraces(), surface, address, 0.12), scene);
                request.method.name = method.name;
                const auto skipping = rendered(request);
                flat += counted(*skipping, MessageId::CountRaysFlat);
                request.skip = false;
                const auto plain = rendered(request);
                EXPECT_EQ(counted(*plain, MessageId::CountRaysFlat), 0);
                EXPECT_EQ(counted(*plain, MessageId::CountMapsNotNeeded), 0);
                expectSameBits(*skipping, *plain, request);
            }
        }
    }
    EXPECT_GT(flat, 2000);
}

TEST(Skip, noBitChangesOverFilters) {
    double spared = 0;
    double traced = 0;
    std::vector<FilterChoice> choices{{"elliptical-visible", {{"form", "position-area"}}}};
    for (const FilterDescription& filter : filterList()) {
        if (filter.name != kSupersample) choices.push_back({filter.name, {}});
    }
    for (const FilterChoice& choice : choices) {
        for (const SceneKind scene : {SceneKind::Floor, SceneKind::Wall, SceneKind::Cube}) {
            SCOPED_TRACE(filterText(choice) + " " + std::string(sceneName(scene)));
            FrameRequest request = small(HeightField(terraces()), scene);
            request.filter = choice;
            const auto skipping = rendered(request);
            request.skip = false;
            const auto plain = rendered(request);
            expectSameBits(*skipping, *plain, request);
            if (choice.options.empty()) continue;
            spared +=
                counted(*skipping, MessageId::CountFootprintsClear) - counted(*plain, MessageId::CountFootprintsClear);
            traced += counted(*plain, MessageId::CountTexelsTraced) - counted(*skipping, MessageId::CountTexelsTraced);
        }
    }
    EXPECT_GT(spared, 0);
    EXPECT_GT(traced, 0);
}

// Texels beyond the plane's footprint, and what the pixel sees of them, are visible or hidden according to tests alone.
TEST(Skip, noBitChangesFromNearForTexelsAtTheirOwnPlaces) {
    const auto bricks = share(makeRelief("bricks", 256, 256, 1));
    for (const char* form : {"plane", "position", "position-area"}) {
        SCOPED_TRACE(form);
        FrameRequest request = small(HeightField(bricks));
        request.camera.elevation = 70;
        request.camera.distance = 0.3;
        request.filter = {"elliptical-visible", {{"form", form}}};
        const auto skipping = rendered(request);
        request.skip = false;
        const auto plain = rendered(request);
        expectSameBits(*skipping, *plain, request);
        EXPECT_GT(counted(*plain, MessageId::CountTexelsHidden), 1000);
    }
}

// Pixels of views along the plane contain thousands of texels, each split into hundreds of parts.
TEST(Skip, workOfAViewAlongThePlaneIsBounded) {
    for (const char* form : {"position", "position-area"}) {
        SCOPED_TRACE(form);
        FrameRequest request =
            small(HeightField(share(makeRelief("bricks", 16, 16, 1)), Surface::Bilinear, Address::Repeat, 0.5));
        request.width = 12;
        request.height = 9;
        request.shadows = false;
        request.camera = {.elevation = 1, .distance = 0.6, .fov = 1};
        request.filter = {"elliptical-visible", {{"form", form}}};
        const auto frame = rendered(request);
        const double pixels = request.width * request.height;
        EXPECT_GT(counted(*frame, MessageId::CountTexelsTraced), 10 * pixels);
        EXPECT_LE(counted(*frame, MessageId::CountTexelsTraced), kMostVisits * pixels);
    }
}

TEST(Skip, noBitChangesOnShippedPictures) {
    const std::filesystem::path datasets = RELIEF_DATASETS;
    for (const char* const name : {"gray_rocks/height.png", "stone_wall_bricks102/height.jpg",
                                   "brick_tiles037/height.jpg", "terrain_srtm_east_africa/height.png"}) {
        SCOPED_TRACE(name);
        Work work;
        const HeightImage image = readHeight((datasets / name).string(), {}, work);
        for (const SceneKind scene : {SceneKind::Floor, SceneKind::Wall, SceneKind::Cube}) {
            FrameRequest request = small(HeightField(share(image.heights)), scene);
            request.filter.name = "elliptical";
            const auto skipping = rendered(request);
            request.skip = false;
            expectSameBits(*skipping, *rendered(request), request);
            // Neither do rays start at the pyramid's highest point.
            request.method.name = "exact";
            expectSameBits(*skipping, *rendered(request), request);
        }
    }
}

// Ground whose lowest and highest heights differ by one unit in the last place does not count as flat.
TEST(Skip, almostFlatGroundIsTraced) {
    FloatImage heights(16, 16, 0.5F);
    FrameRequest request = small(HeightField(share(heights)));
    EXPECT_EQ(counted(*rendered(request), MessageId::CountRaysFlat), counted(*rendered(request), MessageId::CountRays));
    for (int y = 0; y < 16; ++y) {
        for (int x = y % 2; x < 16; x += 2) heights(x, y) = std::nextafter(0.5F, 1.0F);
    }
    request.field = HeightField(share(heights));
    EXPECT_EQ(counted(*rendered(request), MessageId::CountRaysFlat), 0);
}

TEST(Skip, theBoundHoldsAndIsMeasured) {
    FrameRequest request =
        small(HeightField(share(makeRelief("hills", 64, 48, 1)), Surface::Bilinear, Address::Repeat, 0.02));
    request.filter.name = "elliptical";
    request.width = 320;
    request.height = 240;
    const auto plain = rendered(request);
    std::int64_t before = 0;
    for (const double bound : {0.05, 0.25, 1.0}) {
        SCOPED_TRACE(bound);
        request.bounded = bound;
        const auto frame = rendered(request);
        Work work;
        MapCache maps;
        const BoundedError error = measureBounded(*frame, request, maps, work);
        EXPECT_EQ(static_cast<double>(error.rays), counted(*frame, MessageId::CountRaysParallax));
        EXPECT_EQ(static_cast<double>(error.footprints), counted(*frame, MessageId::CountFootprintsTiny));
        EXPECT_GT(error.rays, before);
        before = error.rays;
        EXPECT_EQ(error.wrongOutcomes, 0);
        EXPECT_LE(error.rayMax, bound);
        EXPECT_GT(error.rayMax, 0);
        EXPECT_GT(error.rayMean, 0);
        EXPECT_LE(error.rayMean, error.rayMax);
        // All other pixels are unchanged. The light is steeper than the hills, which therefore cast no shadow, not even
        // on hits below them.
        std::int64_t darker = 0;
        for (std::size_t i = 0; i < frame->hits->by.size(); ++i) {
            if (frame->hits->by[i] != HitBy::LittleParallax) {
                ASSERT_TRUE(sameBits(frame->hits->hits[i], plain->hits->hits[i]));
            } else if (frame->shadows->shadowed[i] > plain->shadows->shadowed[i]) {
                ++darker;
            }
        }
        EXPECT_LE(darker, error.rays / 20);
    }
    request.bounded = 0;
    EXPECT_FALSE(rendered(request)->counters.contains(MessageId::CountRaysParallax));
}

TEST(Skip, tinyFootprintsAreReadPlainly) {
    FrameRequest request = small(HeightField(share(makeRelief("bricks", 64, 64, 1))));
    request.camera.distance = 0.6;
    request.filter.name = "elliptical";
    const auto plain = rendered(request);
    request.bounded = 0.9;
    Work work;
    MapCache maps;
    const auto frame = rendered(request);
    const BoundedError error = measureBounded(*frame, request, maps, work);
    EXPECT_GT(error.footprints, 500);
    EXPECT_GT(error.colorMax, 0);
    EXPECT_LE(error.colorMean, error.colorMax);
    EXPECT_FALSE(frame->color->color == plain->color->color);
}

TEST(Skip, theLedgerNamesWhatHowMuchAndWhy) {
    FrameRequest request = small(HeightField(terraces()), SceneKind::Cube);
    request.bounded = 0.5;
    request.counts = true;
    request.filter = {"elliptical-visible", {{"form", "position-area"}}};
    const auto frame = rendered(request);
    const auto rows = skipLedger(*frame, request);
    std::vector<std::string> names;
    for (const SkipRow& row : rows) {
        names.push_back(row.name);
        EXPECT_GE(row.count, 0);
        EXPECT_LE(row.count, row.of) << row.name;
        for (const Language language : {Language::English, Language::Ukrainian}) {
            EXPECT_EQ(sentence(row.what, language).find('{'), std::string::npos);
            EXPECT_EQ(sentence(row.why, language).find('{'), std::string::npos);
        }
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"stages", "maps", "polygons-away", "polygons-off-screen", "sky", "flat-ground",
                                        "highest-point", "small-footprints", "sight", "shadow-away", "shadow-top",
                                        "shadow-bounds", "little-parallax", "tiny-footprints"}));
    EXPECT_EQ(rows[2].count, frame->counters.at(MessageId::CountPolygonsAway));
    EXPECT_GE(rows[2].count, 3);
    EXPECT_NE(sentence(rows[12].why).find("0.5"), std::string::npos);
}

// Traced, over flat ground, of little parallax, started at the highest point: each ray is in exactly one of these
// classes, with and without counts, with and without skipping.
TEST(Skip, everyRayIsCountedOnce) {
    std::int64_t highest = 0;
    for (const bool skip : {true, false}) {
        for (const double bounded : {0.0, 0.5}) {
            for (const char* method : {"max-pyramid", "max-pyramid-paper", "exact"}) {
                SCOPED_TRACE(std::string(method) + (skip ? "" : ", no skipping") + (bounded > 0 ? ", bounded" : ""));
                FrameRequest request = small(HeightField(terraces()));
                request.method.name = method;
                request.skip = skip;
                request.bounded = bounded;
                Work work;
                FrameRenderer renderer(std::make_shared<MapCache>());
                const auto plain = renderer.render(request, work);
                const auto sum = [](const Frame& frame, bool counts) {
                    return counted(frame, MessageId::CountRaysTraced) + counted(frame, MessageId::CountRaysFlat) +
                           counted(frame, MessageId::CountRaysParallax) +
                           (counts ? counted(frame, MessageId::CountRaysHighest) : 0);
                };
                EXPECT_EQ(sum(*plain, false), counted(*plain, MessageId::CountRays));
                const auto later = renderer.counted(work);
                EXPECT_EQ(sum(*later, true), counted(*later, MessageId::CountRays));
                request.counts = true;
                const auto atOnce = rendered(request);
                EXPECT_EQ(sum(*atOnce, true), counted(*atOnce, MessageId::CountRays));
                highest += static_cast<std::int64_t>(counted(*atOnce, MessageId::CountRaysHighest));
            }
        }
    }
    EXPECT_GT(highest, 0);
}

// Hits that are kept, all or those of some tiles, are no share of the rays that the frame traces itself.
TEST(Skip, keptHitsAreNotCountedAsRaysOfTheFrame) {
    FrameRequest request = small(HeightField(terraces()));
    request.method.name = "max-pyramid-paper";  // reports rays that start at the highest point
    request.width = 320;
    request.height = 240;
    request.camera.elevation = 75;
    request.shadows = false;
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    renderer.render(request, work);
    const auto expectShares = [&](double traced) {
        const auto frame = renderer.counted(work);
        EXPECT_EQ(counted(*frame, MessageId::CountRaysTraced), traced);
        EXPECT_GT(counted(*frame, MessageId::CountSteps), 0);
        EXPECT_FALSE(frame->counters.contains(MessageId::CountRaysHighest));
        for (const SkipRow& row : skipLedger(*frame, request)) EXPECT_LE(row.count, row.of) << row.name;
    };
    request.light.azimuth += 20;
    renderer.render(request, work);
    expectShares(0);
    FloatImage edited = *terraces();
    edited(12, 10) -= 0.05F;
    request.field = HeightField(share(std::move(edited)));
    const auto frame = renderer.render(request, work);
    EXPECT_GT(counted(*frame, MessageId::CountTilesKept), 0);
    const double traced = counted(*frame, MessageId::CountRaysTraced);
    EXPECT_GT(traced, 0);
    expectShares(traced);
    EXPECT_GT(counted(*rendered(request), MessageId::CountRaysTraced), traced);
    request.counts = true;
    EXPECT_GT(counted(*rendered(request), MessageId::CountRaysHighest), 0);
}

// A change of the filter, the light or the shadows leaves rays and hits unchanged; a change of depth leaves the maps of
// maxima unchanged.
TEST(Skip, whatDidNotChangeIsNotComputedAgain) {
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = small(HeightField(share(makeRelief("bricks", 64, 48, 1))));
    request.filter.name = "elliptical-visible";
    const auto first = renderer.render(request, work);
    const auto reused = [](const Frame& frame, Stage stage) {
        return frame.stages[static_cast<std::size_t>(stage)].reused;
    };
    request.filter.name = "trilinear";
    const auto filtered = renderer.render(request, work);
    EXPECT_EQ(filtered->counters.at(MessageId::CountRaysTraced), 0);
    EXPECT_EQ(filtered->hits, first->hits);
    EXPECT_TRUE(reused(*filtered, Stage::Rays) && reused(*filtered, Stage::Hits) && reused(*filtered, Stage::Shadows));
    EXPECT_FALSE(reused(*filtered, Stage::Color) || reused(*filtered, Stage::Light));
    request.light.azimuth += 20;
    const auto lit = renderer.render(request, work);
    EXPECT_EQ(lit->counters.at(MessageId::CountRaysTraced), 0);
    EXPECT_TRUE(reused(*lit, Stage::Hits) && reused(*lit, Stage::Color));
    EXPECT_FALSE(reused(*lit, Stage::Shadows) || reused(*lit, Stage::Light));
    request.filter.name = "elliptical-visible";
    renderer.render(request, work);
    const double builds = work.counters().values()[MessageId::CountMapBuilds];
    request.field = HeightField(request.field.sharedHeights(), Surface::Bilinear, Address::Repeat, 0.2);
    const auto deeper = renderer.render(request, work);
    EXPECT_GT(deeper->counters.at(MessageId::CountRaysTraced), 0);
    EXPECT_EQ(work.counters().values()[MessageId::CountMapBuilds], builds);
    request.skip = false;
    renderer.render(request, work);
    request.light.azimuth += 20;
    EXPECT_GT(renderer.render(request, work)->counters.at(MessageId::CountRaysTraced), 0)
        << "without skipping no data are reused";
}

TEST(Skip, aScenarioKeepsIt) {
    Scenario scenario;
    scenario.pictures.recipe = "bricks";
    scenario.skip = false;
    scenario.bounded = 0.25;
    EXPECT_EQ(parseScenario(scenarioText(scenario), "s.json"), scenario);
    scenario.bounded = 5;
    EXPECT_THROW(checkScenario(scenario, "s.json"), InputError);
}

}  // namespace
}  // namespace relief::test
