// Fields that are read by tiles: every method that reads them finds the hits of the map in memory, bit for bit, within
// the bound on memory; the others refuse them.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"
#include "fields.h"
#include "images/recipe_rows.h"
#include "images/tiled_heights.h"
#include "images/tiled_writer.h"
#include "memory_use.h"
#include "relief/maps/depth_pyramid.h"
#include "relief/visibility/any_hit.h"
#include "rendering/frame.h"

namespace relief::test {
namespace {

using testing::TemporaryFolder;

// Codes of 16 bits, made row by row.
class Codes final : public HeightRows {
  public:
    Codes(int width, int height, std::function<double(int, int)> heightAt)
        : width_(width), height_(height), heightAt_(std::move(heightAt)) {}
    int width() const override { return width_; }
    int height() const override { return height_; }
    NumberType type() const override { return NumberType::UInt16; }
    std::string identity() const override { return {}; }
    std::string learned() const override { return {}; }
    void restore(const std::string&) override {}
    void prepare(Work&) override {}
    void read(int first, int count, std::byte* rows, Work&) override {
        for (int y = first; y < first + count; ++y) {
            for (int x = 0; x < width_; ++x, rows += 2) {
                const auto code = static_cast<std::uint16_t>(heightAt_(x, y) * 65535);
                std::memcpy(rows, &code, 2);
            }
        }
    }
    std::vector<Message> notes() const override { return {}; }

  private:
    int width_, height_;
    std::function<double(int, int)> heightAt_;
};

// Hills of several sizes, and a few needles.
double hills(int x, int y) {
    const double rolling = 0.25 * (2 + std::sin(0.031 * x + 0.7) * std::cos(0.023 * y) + std::sin(0.11 * x * 0.9 + y));
    const auto bits = static_cast<std::uint32_t>(x) * 2654435761U ^ static_cast<std::uint32_t>(y) * 2246822519U;
    return (bits >> 16U) % 509 == 0 ? 0.97 : 0.9 * std::clamp(rolling, 0.0, 1.0);
}

struct Map {
    std::shared_ptr<const TiledHeights> tiles;
    Heights heights;
};

Map tiledMap(const std::string& path, int width, int height, std::size_t bytes) {
    Codes codes(width, height, hills);
    Work work;
    TiledWriter(codes, path, {}).write(work);
    Map map{TiledHeights::open(path, bytes), nullptr};
    FloatImage image(width, height);
    const auto whole = TiledHeights::open(path, std::size_t{1} << 30);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) image(x, y) = whole->height(x, y);
    }
    map.heights = share(std::move(image));
    return map;
}

constexpr std::size_t kLittle = std::size_t{1} << 20;
const std::vector<std::pair<int, int>> kSizes{{1, 1}, {63, 300}, {257, 64}, {200, 130}};

// Calls body(inMemory, byTiles) for both surfaces and all addressing modes.
template <class Body>
void overFields(const Map& map, double depth, const Body& body) {
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            const HeightField field(map.heights, surface, address, depth);
            SCOPED_TRACE(describe(field));
            body(field, HeightField(map.tiles, surface, address, depth));
        }
    }
}

std::vector<MethodChoice> tiledChoices() {
    std::vector<MethodChoice> all;
    for (const MethodDescription& method : tracerList()) {
        if (method.tiled) all.push_back({method.name, {}});
    }
    return all;
}

HitBlock traced(const MethodChoice& choice, const HeightField& field, const RayBlock& rays, Form form) {
    MapCache cache;
    Work work(2);
    HitBlock hits;
    NullSink sink;
    makeTracer(choice, field, cache, work, form)->trace(rays, hits, sink, work);
    return hits;
}

// Expects the hits of the field in memory, in SIMD and scalar.
void expectSameHits(const HeightField& field, const HeightField& byTiles, const RayBlock& rays) {
    for (const MethodChoice& choice : tiledChoices()) {
        const HitBlock expected = traced(choice, field, rays, Form::Scalar);
        for (const Form form : {Form::Scalar, Form::Simd}) {
            const HitBlock hits = traced(choice, byTiles, rays, form);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                ASSERT_TRUE(sameBits(hits[i], expected[i])) << describe(choice) << " " << formName(form) << " ray " << i
                                                            << ": " << hits[i].lambda << " " << expected[i].lambda;
            }
        }
    }
}

TEST(TiledField, EveryMethodFindsTheHitsOfTheMapInMemory) {
    const TemporaryFolder folder;
    for (const auto& [width, height] : kSizes) {
        const Map map = tiledMap(folder / "map.tif", width, height, kLittle);
        overFields(map, 0.4, [&](const HeightField& field, const HeightField& byTiles) {
            RayBlock rays = randomRays(7, field, 300, 3);
            // Under border these begin outside; under repeat far away; one is level with an axis, three are no rays.
            rays.push({-3.5, 2, 20, 5});
            rays.push({1e6 + 0.25, -1e5, 30, -11});
            rays.push({0.5, 0.25, 50, 0});
            rays.push({0.5, 1, std::nan(""), 0});
            rays.push({std::nan(""), 1, 3, 4});
            rays.push({0.5, std::numeric_limits<double>::infinity(), 3, 4});
            expectSameHits(field, byTiles, rays);
        });
    }
}

TEST(TiledField, KeepsWithinTheBoundOfMemory) {
    constexpr int kSide = 2048;
    const TemporaryFolder folder;
    constexpr std::size_t kBound = std::size_t{3} << 20;
    const Map map = tiledMap(folder / "map.tif", kSide, kSide, kBound);
    const HeightField field(map.heights, Surface::Bilinear, Address::Repeat, 0.05);
    const HeightField byTiles(map.tiles, Surface::Bilinear, Address::Repeat, 0.05);
    expectSameHits(field, byTiles, randomRays(11, field, 800, 4));
    EXPECT_LE(map.tiles->residentBytes(), kBound);
    EXPECT_GT(map.tiles->statistics().evictions, 0U) << "the bound was never reached";
    MapCache cache;
    Work work;
    const auto pyramid = depthPyramid(byTiles, maxPyramidMap(byTiles, cache, work), cache, work);
    ASSERT_NE(pyramid->tiled, nullptr);
    EXPECT_LE(pyramid->tiled->bytes(), kBound / 3);
}

// The largest resident memory of the process since the last call, megabytes; 0 where the system does not say.
double peakMegabytes() {
    std::ifstream status("/proc/self/status");
    double kilobytes = 0;
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) kilobytes = std::stod(line.substr(6));
    }
    std::ofstream("/proc/self/clear_refs") << 5;
    return kilobytes * 1024 / 1e6;
}

// A map of 4,096 texels a side, and with RELIEF_LONG of 32,768: made, traced and drawn.
TEST(TiledField, LargeMapsAreMadeTracedAndDrawnInLittleMemory) {
    const bool isLong = std::getenv("RELIEF_LONG") != nullptr;
    const int side = isLong ? 32768 : 4096;
    const std::size_t bound = std::size_t{isLong ? 512U : 6U} << 20;
    const TemporaryFolder folder;
    Work work;
    // Before memory that is not the map's: of the program, the writer (1.5 kB for each column), threads and a picture.
    peakMegabytes();
    const double allowed = residentMegabytes() + static_cast<double>(bound) / 1e6 + 2e-3 * side + 30;
    const auto rows = reliefHeightRows("bricks", side, side, 1);
    TiledWriter(*rows, folder / "map.tif", {}).write(work);
    const auto tiles = TiledHeights::open(folder / "map.tif", bound / 4 * 3);
    const HeightField byTiles(tiles, Surface::Bilinear, Address::Repeat, 0.02);
    const RayBlock rays = randomRays(5, byTiles, 1000, 20);
    const HitBlock hits = traced({"max-pyramid", {}}, byTiles, rays, Form::Simd);
    FrameRequest request(byTiles);
    request.width = 160;
    request.height = 90;
    request.shadows = true;
    const auto picture = FrameRenderer(std::make_shared<MapCache>()).render(request, work)->light->color;
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    EXPECT_LE(peakMegabytes(), allowed);
#endif
    EXPECT_LE(tiles->residentBytes(), bound / 4 * 3);
    const HitBlock expected = traced({"exact", {}}, byTiles, rays, Form::Scalar);
    for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_TRUE(sameBits(hits[i], expected[i])) << i;
    if (isLong) return;
    request.field = HeightField(share(makeRelief("bricks", side, side, 1)), Surface::Bilinear, Address::Repeat, 0.02);
    EXPECT_TRUE(FrameRenderer(std::make_shared<MapCache>()).render(request, work)->light->color == picture);
    const HitBlock whole = traced({"max-pyramid", {}}, request.field, rays, Form::Simd);
    for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_TRUE(sameBits(hits[i], whole[i])) << i;
}

TEST(TiledField, TheBoundsOfThePyramidHoldAndAreTight) {
    const TemporaryFolder folder;
    for (const auto& [width, height] : {std::pair(257, 64), std::pair(130, 200), std::pair(500, 350)}) {
        const Map map = tiledMap(folder / "map.tif", width, height, kLittle / 2);
        overFields(map, 0.1, [&](const HeightField& field, const HeightField& byTiles) {
            MapCache cache;
            Work work;
            const auto expected = maxPyramidMap(field, cache, work);
            const TiledPyramid tiled(byTiles, work);
            ASSERT_EQ(tiled.top(), expected->top());
            EXPECT_EQ(tiled.highest(), expected->highest());
            for (int l = 0; l <= tiled.top(); ++l) {
                const FloatImage& level = expected->pyramid.level(l);
                for (int y = 0; y < level.height(); ++y) {
                    for (int x = 0; x < level.width(); ++x) {
                        const float value = tiled.maximum(l, x, y);
                        ASSERT_GE(value, level(x, y)) << l << " " << x << " " << y;
                        ASSERT_EQ(tiled.depth(l, x, y), depthOf(value));
                        // No higher than what lies in the nodes around it.
                        float around = 0;
                        for (int n = 0; n < 9; ++n) {
                            const int i = x + n % 3 - 1, j = y + n / 3 - 1;
                            const int w = level.width(), h = level.height();
                            around = std::max(around, level((i + w) % w, (j + h) % h));
                        }
                        ASSERT_LE(value, std::max(around, level(x, y)) + kDepthUnit) << l << " " << x << " " << y;
                    }
                }
            }
        });
    }
}

TEST(TiledField, ShadowsAreThoseOfTheMapInMemory) {
    const TemporaryFolder folder;
    const Map map = tiledMap(folder / "map.tif", 200, 130, kLittle);
    overFields(map, 0.3, [&](const HeightField& field, const HeightField& byTiles) {
        Random random(3);
        AnyRayBlock rays;
        for (int n = 0; n < 400; ++n) {
            rays.push({random.between(0, 200), random.between(0, 130), random.unit(), random.between(-60, 60),
                       random.between(-60, 60), random.between(-0.5, 0.5)});
        }
        MapCache cache;
        Work work;
        NullSink sink;
        VisibilityBlock expected, found;
        makeAnyHit({"max-pyramid-any", {}}, field, cache, work)->query(rays, expected, sink, work);
        ASSERT_EQ(visibilityChoice(byTiles).name, "max-pyramid-any");
        makeAnyHit(visibilityChoice(byTiles), byTiles, cache, work)->query(rays, found, sink, work);
        EXPECT_EQ(found.visibility, expected.visibility);
        EXPECT_NE(std::count(found.visibility.begin(), found.visibility.end(), Visibility::Blocked), 0);
    });
}

TEST(TiledField, FramesAreThoseOfTheMapInMemory) {
    const TemporaryFolder folder;
    const Map map = tiledMap(folder / "map.tif", 300, 200, kLittle);
    overFields(map, 0.1, [&](const HeightField& field, const HeightField& byTiles) {
        const auto picture = [](const HeightField& of) {
            FrameRequest request(of);
            request.width = 160;
            request.height = 90;
            request.filter.name = "bilinear";
            request.shadows = true;
            Work work;
            return FrameRenderer(std::make_shared<MapCache>()).render(request, work)->light->color;
        };
        EXPECT_TRUE(picture(byTiles) == picture(field));
    });
}

TEST(TiledField, FiltersOfFootprintsReadLevelsOfMeans) {
    const TemporaryFolder folder;
    const Map map = tiledMap(folder / "map.tif", 300, 200, kLittle);
    for (const char* filter : {"trilinear", "elliptical", "elliptical-visible"}) {
        const auto picture = [&](const HeightField& of) {
            FrameRequest request(of);
            request.width = 80;
            request.height = 45;
            request.filter.name = filter;
            Work work;
            return FrameRenderer(std::make_shared<MapCache>()).render(request, work)->light->color;
        };
        // A map as small as this one is its own finest level.
        EXPECT_TRUE(picture(HeightField(map.tiles)) == picture(HeightField(map.heights))) << filter;
    }
}

TEST(TiledField, OtherMethodsRefuseAndNameThoseThatCan) {
    const TemporaryFolder folder;
    const Map map = tiledMap(folder / "map.tif", 40, 40, kLittle);
    const HeightField field(map.tiles);
    MapCache cache;
    Work work;
    const auto refusal = [&](const MethodChoice& choice) -> std::string {
        try {
            makeTracer(choice, field, cache, work);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    };
    for (const MethodDescription& method : tracerList()) {
        if (method.tiled) continue;
        EXPECT_NE(refusal({method.name, {}}).find("max-pyramid"), std::string::npos) << method.name;
        EXPECT_NE(refusal({method.name, {}}).find(method.name), std::string::npos);
    }
    EXPECT_NE(refusal({"max-pyramid", {{"base", "1"}}}).find("base"), std::string::npos);
    EXPECT_THROW(field.heights(), InputError);
}

TEST(TiledField, MapsOfMoreThanSixteenLevelsAreTracedInSimd) {
    const Heights heights = randomHeights(70000, 3, 5);
    for (const Address address : allAddresses()) {
        const HeightField field(heights, Surface::Bilinear, address, 0.001);
        const RayBlock rays = randomRays(13, field, 2000, 10);
        MapCache cache;
        Work work;
        ASSERT_EQ(makeTracer({"max-pyramid", {}}, field, cache, work)->form(), Form::Simd);
        const HitBlock expected = traced({"exact", {}}, field, rays, Form::Scalar);
        const HitBlock hits = traced({"max-pyramid", {}}, field, rays, Form::Simd);
        for (std::size_t i = 0; i < rays.size(); ++i) ASSERT_TRUE(sameBits(hits[i], expected[i])) << i;
    }
}

}  // namespace
}  // namespace relief::test
