// Frames after an edit of some texels: only tiles that can see the edit are made again, with the bits of a new frame.
#include "rendering/edited_tiles.h"

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "rendering/frame_buffers.h"
#include "rendering/skip_ledger.h"

namespace relief::test {
namespace {

constexpr int kAcross = 24, kDown = 20;

std::shared_ptr<const ColorImage> colors() {
    Random random(3);
    ColorImage image(kAcross, kDown);
    for (Color& color : image.pixels()) {
        color = Color(static_cast<float>(random.unit()), static_cast<float>(random.unit()), 0.5F);
    }
    return std::make_shared<ColorImage>(std::move(image));
}

Heights edited(const Heights& heights, Random& random, int texels) {
    FloatImage image = *heights;
    for (int n = 0; n < texels; ++n) {
        const int x = static_cast<int>(random.unit() * image.width()),
                  y = static_cast<int>(random.unit() * image.height());
        image(x, y) = static_cast<float>(random.unit());
    }
    return share(std::move(image));
}

FrameRequest request(Surface surface, Address address) {
    FrameRequest request(HeightField(share(makeRelief("hills", kAcross, kDown, 1)), surface, address, 0.1));
    request.width = 300;
    request.height = 170;
    request.camera.elevation = 50;
    request.shadows = true;
    return request;
}

void setHeights(FrameRequest& request, const Heights& heights) {
    const HeightField& field = request.field;
    request.field = HeightField(heights, field.surface(), field.address(), field.reliefDepth());
}

// The tiles kept and the tiles of the picture, as the ledger has them; no value if it does not mention them.
std::optional<SkipRow> tilesKept(const Frame& frame, const FrameRequest& request) {
    for (const SkipRow& row : skipLedger(frame, request)) {
        if (std::string_view(row.name) == "tiles-kept") return row;
    }
    return std::nullopt;
}

void expectSame(const Frame& kept, const Frame& fresh) {
    EXPECT_EQ(kept.light->color, fresh.light->color);
    EXPECT_EQ(kept.color->color, fresh.color->color);
    EXPECT_EQ(kept.shadows->shadowed, fresh.shadows->shadowed);
    ASSERT_EQ(kept.hits->hits.size(), fresh.hits->hits.size());
    for (std::size_t i = 0; i < kept.hits->hits.size(); ++i) {
        ASSERT_TRUE(sameBits(kept.hits->hits[i], fresh.hits->hits[i])) << i;
    }
}

// Edits one texel or a few, several times in a row, and compares with new frames. Returns the number of tiles kept.
double edits(FrameRequest request, std::uint64_t seed, int rounds) {
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    renderer.render(request, work);
    Random random(seed);
    double kept = 0;
    for (int n = 0; n < rounds; ++n) {
        setHeights(request, edited(request.field.sharedHeights(), random, n % 2 == 0 ? 1 : 3));
        const auto frame = renderer.render(request, work);
        expectSame(*frame, *FrameRenderer(std::make_shared<MapCache>()).render(request, work));
        if (const auto tiles = tilesKept(*frame, request)) kept += tiles->count;
    }
    return kept;
}

TEST(EditedTiles, HaveTheBitsOfANewFrame) {
    double kept = 0;
    for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            for (const SceneKind scene : {SceneKind::Floor, SceneKind::Cube}) {
                FrameRequest one = request(surface, address);
                one.scene = scene;
                one.camera.distance = scene == SceneKind::Cube ? 2.5 : 1.5;
                SCOPED_TRACE(static_cast<int>(surface) * 100 + static_cast<int>(address) * 10 +
                             static_cast<int>(scene));
                kept += edits(one, 1, 6);
            }
        }
    }
    EXPECT_GT(kept, 12 * 6 * 4);
}

// Also grazing views, where rays and shadows pass over many texels and footprints are long.
TEST(EditedTiles, HaveTheBitsOfANewFrameWithEveryFilter) {
    for (const FilterChoice& filter : filterForms()) {
        if (filter.name == kSupersample) continue;
        const auto form = filter.options.find("form");
        if (form != filter.options.end() && form->second.starts_with("position")) continue;  // slow, and keeps no tile
        for (const bool colored : {true, false}) {
            for (const double elevation : {60.0, 12.0}) {
                SCOPED_TRACE(filterText(filter) + (colored ? ", colours, " : ", heights, ") + numberText(elevation));
                FrameRequest one = request(Surface::Bilinear, Address::Repeat);
                one.filter = filter;
                one.camera.elevation = elevation;
                one.light.elevation = 70;
                if (colored) one.color = colors();
                edits(one, 7, 3);
            }
        }
    }
}

// A spike whose shadow falls far away, in tiles that do not see it.
TEST(EditedTiles, AreMadeAgainWhereAShadowFalls) {
    int fallen = 0;
    for (const double azimuth : {10.0, 100.0, 190.0, 280.0}) {
        FrameRequest one = request(Surface::Columns, Address::Repeat);
        setHeights(one, constantHeights(kAcross, kDown, 0.25F));
        one.width = 480;
        one.height = 320;
        one.camera.elevation = 80;
        one.light.elevation = 12;
        one.light.azimuth = azimuth;
        Work work;
        FrameRenderer renderer(std::make_shared<MapCache>());
        const auto before = renderer.render(one, work);
        for (int n = 0; n < 8; ++n) {
            FloatImage image(kAcross, kDown, 0.25F);
            image(3 * n + 1, 2 * n + 3) = 1;
            setHeights(one, share(std::move(image)));
            const auto frame = renderer.render(one, work);
            ASSERT_TRUE(tilesKept(*frame, one));
            expectSame(*frame, *FrameRenderer(std::make_shared<MapCache>()).render(one, work));
            fallen += frame->shadows->shadowed == before->shadows->shadowed ? 0 : 1;
        }
    }
    EXPECT_EQ(fallen, 4 * 8);
}

// Nine texels per pixel, so that the filter reads farther beyond the border of a tile than a slope does.
TEST(EditedTiles, AreMadeAgainWhereAFilterReads) {
    constexpr int kFine = 256, kWalls = 24;
    for (const auto& [name, colored] : {std::pair{"elliptical", false}, std::pair{"elliptical-visible", true}}) {
        SCOPED_TRACE(name);
        FrameRequest one(HeightField(share(makeRelief("hills", kFine, kFine, 1)), Surface::Bilinear, Address::Clamp));
        // Straight from above, with the border between two rows of tiles in the middle.
        one.camera.elevation = 90;
        one.camera.azimuth = 0;
        one.camera.distance = 3.1;
        one.width = 75;
        one.height = 2 * kTileHeight;
        one.filter.name = name;
        if (colored) one.color = colors();
        Work work;
        FrameRenderer renderer(std::make_shared<MapCache>());
        renderer.render(one, work);
        double kept = 0;
        for (int n = 0; n < kWalls; ++n) {
            FloatImage image = one.field.heights();
            for (int x = 0; x < kFine; ++x) image(x, kFine / 2 + n) = n % 2 == 0 ? 1 : 0;
            setHeights(one, share(std::move(image)));
            const auto frame = renderer.render(one, work);
            const auto tiles = tilesKept(*frame, one);
            ASSERT_TRUE(tiles);
            kept += tiles->count;
            expectSame(*frame, *FrameRenderer(std::make_shared<MapCache>()).render(one, work));
        }
        EXPECT_GT(kept, 0);
    }
}

TEST(EditedTiles, AreFewWhereRaysAreSteep) {
    FrameRequest one = request(Surface::Bilinear, Address::Repeat);
    one.width = 640;
    one.height = 480;
    one.camera.elevation = 75;
    one.light.elevation = 70;
    one.color = colors();
    for (const char* const filter : {"bilinear", "elliptical", "elliptical-visible"}) {
        SCOPED_TRACE(filter);
        one.filter.name = filter;
        Work work;
        FrameRenderer renderer(std::make_shared<MapCache>());
        const auto before = renderer.render(one, work);
        FrameRequest other = one;
        FloatImage image = one.field.heights();
        image(12, 10) += 0.05F;
        setHeights(other, share(std::move(image)));
        const auto frame = renderer.render(other, work);
        const double tiles = tilesAcross(one.width) * tilesDown(one.height);
        const auto kept = tilesKept(*frame, other);
        ASSERT_TRUE(kept);
        EXPECT_EQ(kept->of, tiles);
        EXPECT_GE(kept->count, 0.6 * tiles);
        EXPECT_LT(frame->counters.at(MessageId::CountRaysTraced),
                  0.4 * before->counters.at(MessageId::CountRaysTraced));
        EXPECT_EQ(frame->rays, before->rays);
        // The edit is visible.
        EXPECT_FALSE(frame->light->color == before->light->color);
    }
}

// Where any pixel may depend on any texel, everything is made again.
TEST(EditedTiles, AreAllWhereHitsMayBeWrong) {
    const auto keeps = [](const FrameRequest& one, const Heights& heights) {
        Work work;
        FrameRenderer renderer(std::make_shared<MapCache>());
        renderer.render(one, work);
        FrameRequest other = one;
        setHeights(other, heights);
        return tilesKept(*renderer.render(other, work), other).has_value();
    };
    FrameRequest one = request(Surface::Bilinear, Address::Repeat);
    Random random(5);
    const Heights near = edited(one.field.sharedHeights(), random, 1);
    EXPECT_TRUE(keeps(one, near));
    FrameRequest other = one;
    other.method.name = "relaxed-cone";
    EXPECT_FALSE(keeps(other, near));
    other = one;
    other.bounded = 0.5;
    EXPECT_FALSE(keeps(other, near));
    other = one;
    other.mapping.variant = RowVariant::Affine;
    EXPECT_FALSE(keeps(other, near));
    other = one;
    other.skip = false;
    EXPECT_FALSE(keeps(other, near));
    // Too much is different.
    EXPECT_FALSE(keeps(one, share(makeRelief("spikes", kAcross, kDown, 1))));
}

TEST(ChangedTexels, AreFoundByRectangles) {
    FloatImage before(600, 40, 0.5F);  // coarser squares than texels
    FloatImage after = before;
    after(300, 7) = 0.25F;
    const auto changed = ChangedTexels::between(before, after);
    ASSERT_TRUE(changed);
    const auto within = [&](double s0, double s1, double t0, double t1, Address address) {
        return changed->within({s0, s1}, {t0, t1}, address);
    };
    for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
        EXPECT_TRUE(within(300.2, 300.4, 7.1, 7.2, address));
        EXPECT_TRUE(within(0, 599, 0, 39, address));
        EXPECT_TRUE(within(-1e9, 1e9, 7, 7, address));
        EXPECT_FALSE(within(304, 599, 0, 39, address));
        EXPECT_FALSE(within(0, 295, 0, 39, address));
        EXPECT_FALSE(within(280, 320, 12, 39, address));
    }
    EXPECT_TRUE(within(300 - 1200, 301 - 1200, 47, 47.5, Address::Repeat));
    EXPECT_TRUE(within(590, 901, -40, 0, Address::Repeat));
    EXPECT_FALSE(within(590, 890, -20, 0, Address::Repeat));
    EXPECT_FALSE(within(300 - 1200, 301 - 1200, 7, 7.5, Address::Clamp));
    EXPECT_TRUE(within(std::nan(""), 1, 7, 7, Address::Repeat));
    EXPECT_FALSE(ChangedTexels::between(before, FloatImage(600, 41, 0.5F)));
    EXPECT_FALSE(ChangedTexels::between(before, FloatImage(600, 40, 0.25F)));
    const auto same = ChangedTexels::between(before, before);
    ASSERT_TRUE(same);
    EXPECT_FALSE(same->within({-1e9, 1e9}, {-1e9, 1e9}, Address::Repeat));
}

}  // namespace
}  // namespace relief::test
