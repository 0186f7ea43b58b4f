// The numbers of a pixel's history multiply out to the pixel that is drawn.
#include "rendering/pixel_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "rendering/pixel_history_text.h"
#include "scenario/scenario.h"

namespace relief::test {
namespace {

constexpr int kSide = 48;

// What the pixels of a test have shown, so that nothing is left untested.
struct Seen {
    std::set<std::string> kinds;

    void take(const PixelHistory& history) {
        for (const HistoryRay& ray : history.rays) {
            if (!ray.polygon) {
                kinds.insert("sky");
            } else if (ray.hit.outcome != Outcome::Hit) {
                kinds.insert(ray.hit.outcome == Outcome::Limit ? "limit" : "miss");
            } else {
                kinds.insert(ray.shadowed ? "shadow" : ray.cosine > 0 ? "light" : "away");
                if (ray.hidden > 0) kinds.insert("hidden");
                if (ray.texels.size() > 4) kinds.insert("footprint");
                if (ray.height) kinds.insert("grey");
            }
        }
        if (history.rays.size() > 1) {
            const auto sky = [](const HistoryRay& ray) { return !ray.polygon || ray.hit.outcome != Outcome::Hit; };
            const auto count = std::count_if(history.rays.begin(), history.rays.end(), sky);
            if (count > 0 && count < static_cast<std::ptrdiff_t>(history.rays.size())) kinds.insert("silhouette");
        }
    }
};

// Pixels all over the picture, and some at the edge between relief and sky.
std::vector<glm::ivec2> pixelsOf(const Frame& frame, int stride) {
    constexpr std::size_t kEdge = 6;
    std::vector<glm::ivec2> pixels;
    const auto hits = [&](int x, int y) { return frame.hits->hits.outcome[frame.index(x, y)] == Outcome::Hit; };
    for (int y = 0; y < frame.height && pixels.size() < kEdge; ++y) {
        for (int x = 1; x < frame.width && pixels.size() < kEdge; x += 2) {
            if (hits(x, y) != hits(x - 1, y)) pixels.push_back({x, y});
        }
    }
    for (int y = stride / 2; y < frame.height; y += stride) {
        for (int x = (y * 7) % stride; x < frame.width; x += stride) pixels.push_back({x, y});
    }
    return pixels;
}

// Explains the pixels, and compares them with the picture as it is drawn as a whole.
void expectProducts(const FrameRequest& request, Seen& seen, int stride, const std::string& what) {
    Work work(1);
    const auto maps = std::make_shared<MapCache>();
    FrameRenderer renderer(maps);
    const auto frame = renderer.render(request, work);
    for (const glm::ivec2 pixel : pixelsOf(*frame, stride)) {
        const PixelHistory history = pixelHistory(request, pixel.x, pixel.y, maps, work);
        const std::string where = what + " at " + std::to_string(pixel.x) + "," + std::to_string(pixel.y);
        ASSERT_EQ(history.drawn, frame->light->color(pixel.x, pixel.y)) << where;
        EXPECT_LE(history.difference(), history.bound) << where;
        EXPECT_LT(history.bound, 1e-4) << where;
        glm::dvec3 shares(0);
        for (const HistoryRay& ray : history.rays) {
            shares += ray.share;
            if (!ray.polygon || ray.hit.outcome != Outcome::Hit) continue;
            glm::dvec3 weights(0);
            for (const HistoryTexel& texel : ray.texels) weights += texel.weight;
            // Each station by itself: the texels give the filtered colour, the light the lit one.
            for (int k = 0; k < 3; ++k) {
                EXPECT_NEAR(ray.sum[k], ray.filtered[k], history.bound) << where << ", filter";
                EXPECT_NEAR(ray.filtered[k] * ray.amount, ray.lit[k], 1e-6) << where << ", light";
                EXPECT_NEAR(ray.height ? 1 : weights[k], 1, 1e-9) << where;
            }
        }
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(shares[k], 1, 1e-9) << where;
        seen.take(history);
    }
}

Scenario view(SceneKind scene) {
    Scenario scenario;
    scenario.pictures.height = std::string(RELIEF_DATASETS) + "/gray_rocks/height.png";
    scenario.pictures.color = std::string(RELIEF_DATASETS) + "/gray_rocks/color.jpg";
    scenario.reliefDepth = 0.4;
    scenario.width = scenario.height = kSide;
    scenario.scene = scene;
    scenario.camera.elevation = 15;
    scenario.light.elevation = 15;
    scenario.shadows = true;
    scenario.address = Address::Border;
    return scenario;
}

TEST(PixelHistory, EveryFilterMultipliesOut) {
    const Scenario scenario = view(SceneKind::Wall);
    Work work(1);
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work);
    Seen seen;
    std::vector<FilterChoice> choices;
    for (const FilterDescription& filter : filterList()) choices.push_back({filter.name, {}});
    // The form that tests texels, of which some are hidden; the default one tests points.
    choices.push_back({"elliptical-visible", {{"form", "plane"}}});
    for (FilterChoice& choice : choices) {
        Scenario filtered = scenario;
        filtered.filter = choice;
        filtered.filter.samples = 2;
        expectProducts(frameRequest(filtered, assets), seen, 16, filterText(choice));
    }
    for (const char* const kind : {"sky", "miss", "shadow", "light", "hidden", "footprint", "silhouette"}) {
        EXPECT_TRUE(seen.kinds.contains(kind)) << "no pixel shows this, nothing is tested: " << kind;
    }
}

TEST(PixelHistory, PixelModelsAndHeightsInGreyMultiplyOut) {
    Scenario scenario = view(SceneKind::Cube);
    scenario.pictures.color.clear();
    Work work(1);
    AssetStore store;
    const Assets assets = store.load(scenario.pictures, work);
    Seen seen;
    expectProducts(frameRequest(scenario, assets), seen, 13, "grey, default filter");
    scenario.filter.name = "bilinear";
    scenario.surface = Surface::Columns;
    expectProducts(frameRequest(scenario, assets), seen, 13, "grey");
    EXPECT_TRUE(seen.kinds.contains("grey"));
    scenario.filter.name = kSupersample;
    scenario.filter.samples = 3;
    for (const PixelModel model : {PixelModel::Gaussian, PixelModel::Lcd, PixelModel::Crt}) {
        scenario.filter.pixelModel = model;
        expectProducts(frameRequest(scenario, assets), seen, kSide, "pixel model");
    }
    // With an allowed error, tiny footprints are filtered by the plain filter.
    scenario.filter = {};
    scenario.bounded = 0.5;
    expectProducts(frameRequest(scenario, assets), seen, 23, "bounded");
}

TEST(PixelHistory, SaysWhy) {
    Scenario scenario = view(SceneKind::Wall);
    Work work(1);
    AssetStore store;
    const FrameRequest request = frameRequest(scenario, store.load(scenario.pictures, work));
    const auto maps = std::make_shared<MapCache>();
    PixelHistory history = pixelHistory(request, kSide / 2, kSide / 2, maps, work);
    const std::string text = historyText(history, request, Language::English);
    for (const char* const part : {"Coverage", "Ray and hit", "Filter", "n · l", "It is the drawn pixel"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    }
    history.product.x += 1e-3;
    EXPECT_FALSE(history.multipliesOut());
    EXPECT_NE(historyText(history, request, Language::Ukrainian).find("НЕ намальований"), std::string::npos);
    const PixelHistory sky = pixelHistory(request, 0, 0, maps, work);
    EXPECT_FALSE(sky.rays.front().polygon);
    EXPECT_NE(historyText(sky, request, Language::English).find("shows the sky"), std::string::npos);
    EXPECT_EQ(sky.drawn, request.sky);
    EXPECT_THROW(pixelHistory(request, kSide, 0, maps, work), InputError);
    EXPECT_THROW(pixelHistory(request, 0, -1, maps, work), InputError);
}

}  // namespace
}  // namespace relief::test
