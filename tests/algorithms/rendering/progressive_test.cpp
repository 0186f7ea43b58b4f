// Progressive rendering as in the window's worker, with filters that take the relief into account: a coarse picture
// first, then the full one. Whatever was rendered or abandoned before, the full picture has the same bits as if
// rendered alone.
#include <gtest/gtest.h>

#include <limits>

#include "algorithms/relief/fields.h"
#include "measuring/random_rays.h"
#include "relief/simd/packed_cone_hits.h"
#include "rendering/progressive.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 59;
// Tiles are 64 x 32: the picture has several, the last ones incomplete.
constexpr int kWidth = 150, kHeight = 70;

// Renders coarse and full pictures, each with its own buffers and with common maps.
class Worker {
  public:
    // part: the rendering is abandoned after this share of its tiles; 1: it is finished.
    std::shared_ptr<const Frame> coarse(FrameRequest request, int factor, double part) {
        request.width = (request.width + factor - 1) / factor;
        request.height = (request.height + factor - 1) / factor;
        return make(coarse_, request, part);
    }
    std::shared_ptr<const Frame> full(const FrameRequest& request, double part = 1) {
        return make(full_, request, part);
    }
    int brokenOff() const { return brokenOff_; }

  private:
    std::shared_ptr<const Frame> make(FrameRenderer& renderer, const FrameRequest& request, double part) {
        std::stop_source stop;
        Work work(2, stop.get_token(), [&](std::string_view, double done) {
            if (part < 1 && done >= part) stop.request_stop();
        });
        try {
            return renderer.render(request, work);
        } catch (const Cancelled&) {
            ++brokenOff_;
            return nullptr;
        }
    }

    std::shared_ptr<MapCache> maps_ = std::make_shared<MapCache>();
    FrameRenderer full_{maps_}, coarse_{maps_};
    int brokenOff_ = 0;
};

std::shared_ptr<const Frame> alone(const FrameRequest& request) {
    Work work(1);
    return FrameRenderer(std::make_shared<MapCache>()).render(request, work);
}

void expectSame(const Frame& frame, const Frame& expected, const std::string& what) {
    EXPECT_TRUE(frame.color->color == expected.color->color) << what;
    EXPECT_TRUE(frame.light->color == expected.light->color) << what;
}

FrameRequest requestFor(const FilterChoice& filter) {
    FrameRequest request(HeightField(share(makeRelief("city", 96, 96, kSeed))));
    request.width = kWidth, request.height = kHeight;
    auto picture = std::make_shared<ColorImage>(128, 96);
    Random random(kSeed);
    for (Color& color : picture->pixels()) {
        const auto channel = [&] { return static_cast<float>(random.between(0, 1)); };
        color = {channel(), channel(), channel()};
    }
    request.color = picture;
    request.filter = filter;
    request.camera.elevation = 30;
    request.shadows = true;
    return request;
}

const std::vector<FilterChoice> kFilters{{"elliptical-visible", {}},
                                         {"elliptical-visible", {{"points", "2"}}},
                                         {"elliptical-visible", {{"form", "rays"}}},
                                         {"elliptical", {}}};

TEST(Progressive, aDraggedViewSettlesToThePictureItself) {
    for (const FilterChoice& filter : kFilters) {
        FrameRequest request = requestFor(filter);
        Worker worker;
        Random random(kSeed);
        // Enough drags that data which are built only after some frames are built.
        const double pixels = kWidth * kHeight;
        const int drags =
            2 + static_cast<int>(static_cast<double>(PackedConeHits::kRaysPerTexel * request.field.heights().size()) /
                                 pixels);
        for (int n = 0; n < drags; ++n) {
            request.camera.azimuth += random.between(-20, 20);
            request.camera.elevation = random.between(15, 80);
            request.scene = n % 3 == 2 ? SceneKind::Cube : SceneKind::Floor;
            const std::string what = filterText(filter) + ", drag " + std::to_string(n);
            // During the motion: coarse pictures, some of which are replaced before they are finished.
            FrameRequest moving = request;
            for (const int factor : {3, 2}) {
                moving.camera.azimuth += 5;
                if (const auto frame = worker.coarse(moving, factor, n % 2 == 0 ? 0.3 : 1)) {
                    FrameRequest small = moving;
                    small.width = frame->width, small.height = frame->height;
                    expectSame(*frame, *alone(small), what + ", coarse");
                }
            }
            // A full picture of another place is begun and abandoned, then the requested one is rendered.
            EXPECT_EQ(worker.full(moving, 0.4), nullptr) << what;
            const auto settled = worker.full(request);
            ASSERT_NE(settled, nullptr);
            expectSame(*settled, *alone(request), what);
        }
        EXPECT_GT(worker.brokenOff(), drags);
    }
}

// Data reused from the previous picture must not affect the result: light, filter, points, depth, and back, each after
// an abandoned rendering.
TEST(Progressive, whatIsKeptDoesNotShow) {
    Worker worker;
    FrameRequest request = requestFor(kFilters[0]);
    const auto first = worker.full(request);
    ASSERT_NE(first, nullptr);
    const auto settle = [&](const FrameRequest& changed, const char* what) {
        worker.full(changed, 0.3);
        worker.coarse(changed, 2, 1);
        const auto frame = worker.full(changed);
        ASSERT_NE(frame, nullptr);
        expectSame(*frame, *alone(changed), what);
    };
    FrameRequest changed = request;
    changed.light.azimuth += 40;
    settle(changed, "light");
    for (const FilterChoice& filter : kFilters) {
        changed.filter = filter;
        settle(changed, filterText(filter).c_str());
    }
    changed.field = HeightField(request.field.sharedHeights(), Surface::Bilinear, Address::Clamp, 0.2);
    settle(changed, "depth");
    changed.filter = kFilters[0];
    settle(changed, "depth, filter");
    changed.method = {"layers", {}};
    settle(changed, "not exact");
    settle(request, "back");
    expectSame(*worker.full(request), *first, "the first");
}

TEST(Progressive, levelsLeaveOutWhatTheyCan) {
    const auto text = [](const char* filter, int level) {
        return filterText(coarserFilter(parseFilter(filter, "filter"), level));
    };
    EXPECT_EQ(text("elliptical-visible", 0), "elliptical-visible");
    EXPECT_EQ(text("elliptical-visible", 1), "elliptical-visible:points=2");
    EXPECT_EQ(text("elliptical-visible:points=2", 1), "elliptical-visible:points=2");
    EXPECT_EQ(text("elliptical-visible:form=rays", 1), "elliptical-visible:form=rays");
    EXPECT_EQ(text("elliptical-visible:points=5:radius=0.9:samples=8", 2), "elliptical:radius=0.9");
    for (const int level : {0, 1, 2}) EXPECT_EQ(text("elliptical:radius=0.9", level), "elliptical:radius=0.9");
    EXPECT_EQ(text("trilinear", 2), "trilinear");
    EXPECT_EQ(text("supersample", 1), "bilinear");
}

// Above the budget frames are coarser, each equal to a picture rendered with those settings; when the camera rests, the
// requested picture is rendered, although the renderer reuses what it can of the coarse ones. Within the budget every
// frame is the requested one.
TEST(Progressive, aboveTheBudgetFramesAreCoarseUntilTheCameraRests) {
    constexpr int kFrames = 8;
    const double never = 0, always = std::numeric_limits<double>::infinity();
    for (const double budget : {never, always}) {
        for (const FilterChoice& filter : kFilters) {
            FrameRequest request = requestFor(filter);
            ProgressiveRenderer renderer(std::make_shared<MapCache>(), budget);
            Work work(2);
            for (int n = 0; n < kFrames; ++n) {
                request.camera.azimuth += 7;
                const std::string what = filterText(filter) + ", frame " + std::to_string(n);
                const auto picture = renderer.moving(request, work);
                EXPECT_EQ(picture.level.number > 0, budget == never) << what;
                EXPECT_EQ(picture.level.factor, budget == never ? 8 : 1) << what;
                expectSame(*picture.frame, *alone(coarserRequest(request, picture.level)), what);
                if (n % 3 != 2) continue;
                std::stop_source stop;
                stop.request_stop();
                Work stopped(2, stop.get_token());
                if (budget == never) {
                    EXPECT_THROW(renderer.atRest(request, stopped), Cancelled);
                }
                expectSame(*renderer.atRest(request, work).frame, *alone(request), what + ", settled");
            }
        }
    }
}

// Every level that a drag may reach, whatever was drawn before. If the level has the picture's full size, no ray is
// traced again.
TEST(Progressive, anyLevelSettlesToThePictureItself) {
    for (const FilterChoice& filter : kFilters) {
        FrameRequest request = requestFor(filter);
        ProgressiveRenderer renderer(std::make_shared<MapCache>(), 0);
        Work work(2);
        const FilterChoice plain = coarserFilter(filter, kCoarsestFilter);
        int number = 0;
        for (const MovingLevel& level : {MovingLevel{1, coarserFilter(filter, 1), 1}, MovingLevel{2, plain, 1},
                                         MovingLevel{3, plain, 2}, MovingLevel{4, plain, 3}}) {
            request.camera.azimuth += 5;
            const std::string what = filterText(filter) + ", level " + std::to_string(++number);
            const auto moving = renderer.draw(request, level, work);
            expectSame(*moving.frame, *alone(coarserRequest(request, level)), what);
            EXPECT_FALSE(moving.frame->hits->counted());
            const auto settled = renderer.atRest(request, work);
            expectSame(*settled.frame, *alone(request), what + ", settled");
            EXPECT_EQ(settled.frame->stages[static_cast<std::size_t>(Stage::Hits)].reused, level.factor == 1) << what;
            // The counts of a picture are right even after another one was rendered.
            FrameRequest counts = coarserRequest(request, level);
            counts.counts = true;
            const auto counted = renderer.counted(moving, work);
            expectSame(*counted, *moving.frame, what + ", counted");
            EXPECT_EQ(counted->hits->hits.steps, alone(counts)->hits->hits.steps) << what;
        }
    }
}

// While only the light moves, nothing is filtered again.
TEST(Progressive, lightLeavesTheFilterAlone) {
    FrameRequest request = requestFor(kFilters[0]);
    ProgressiveRenderer renderer(std::make_shared<MapCache>(), 1);
    Work work(2);
    renderer.atRest(request, work);
    for (int n = 0; n < 8; ++n) {
        request.light.azimuth += 10;
        const auto lit = renderer.moving(request, work);
        EXPECT_EQ(lit.level.number, 0);
        EXPECT_TRUE(lit.frame->stages[static_cast<std::size_t>(Stage::Color)].reused);
    }
    ProgressiveRenderer hurried(std::make_shared<MapCache>(), 0);
    hurried.atRest(request, work);
    for (int n = 0; n < 8; ++n) {
        request.light.azimuth += 10;
        EXPECT_GT(hurried.moving(request, work).level.factor, 1);
    }
    EXPECT_TRUE(hurried.atRest(request, work).frame->stages[static_cast<std::size_t>(Stage::Color)].reused);
}

// Neither the full-size renderer nor that of smaller pictures keeps data of an earlier relief alive.
TEST(Progressive, ofAnotherReliefNothingIsKept) {
    const auto maps = std::make_shared<MapCache>();
    ProgressiveRenderer renderer(maps, 0);
    Work work(2);
    std::weak_ptr<const FloatImage> heights;
    std::weak_ptr<const ColorImage> color;
    {
        const FrameRequest first = requestFor({"elliptical", {}});
        heights = first.field.sharedHeights();
        color = first.color;
        renderer.atRest(first, work);
        EXPECT_GT(renderer.moving(first, work).level.factor, 1);
    }
    maps->clear();
    EXPECT_FALSE(heights.expired());
    EXPECT_FALSE(color.expired());
    renderer.atRest(requestFor({"bilinear", {}}), work);
    maps->clear();
    EXPECT_TRUE(heights.expired());
    EXPECT_TRUE(color.expired());
}

// While the filter's results are displayed, pictures become smaller but keep the filter.
TEST(Progressive, theFilterIsKeptWhileItIsDisplayed) {
    const FrameRequest request = requestFor(kFilters[0]);
    ProgressiveRenderer renderer(std::make_shared<MapCache>(), 0);
    renderer.keepFilter(true);
    const MovingLevel level = renderer.levelFor(request);
    EXPECT_GT(level.factor, 1);
    EXPECT_EQ(level.filter, request.filter);
}

}  // namespace
}  // namespace relief::test
