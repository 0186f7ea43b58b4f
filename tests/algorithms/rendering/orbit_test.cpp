// Frames of an orbiting camera: the same bits as single frames, and memory use that does not grow.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "../../memory_use.h"
#include "algorithms/relief/fields.h"
#include "rendering/frame.h"

namespace relief::test {
namespace {

// Seconds of orbiting; the long run corresponds to a window that is left rotating.
constexpr double kShortSeconds = 12;
constexpr double kLongSeconds = 600;
// Megabytes after the first tenth of the time. A frame of this test has 4 MB of buffers, so two that are retained are
// noticed. Measured after some 1,700 frames: -1.2 and 0.2.
constexpr double kMostGrowth = 8;

FrameRequest orbitRequest() {
    FrameRequest request(HeightField(share(makeRelief("bricks", 128, 128, 1))));
    request.width = 240;
    request.height = 180;
    request.shadows = true;
    request.filter.name = "elliptical";
    return request;
}

TEST(Orbit, memoryDoesNotGrow) {
    Work work;
    const auto maps = std::make_shared<MapCache>();
    FrameRenderer renderer(maps);
    FrameRequest request = orbitRequest();
    const bool isLong = std::getenv("RELIEF_LONG") != nullptr;
    const double seconds = isLong ? kLongSeconds : kShortSeconds;
    const auto begin = std::chrono::steady_clock::now();
    const auto passed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
    double used = 0;
    std::size_t bytes = 0;
    std::int64_t frames = 0;
    std::shared_ptr<const Frame> shown;
    for (; passed() < seconds; ++frames) {
        request.camera.azimuth = std::fmod(0.7 * static_cast<double>(frames), 360);
        request.camera.elevation = 20 + static_cast<double>(frames % 50);
        request.light.azimuth = static_cast<double>(frames % 90);
        request.counts = frames % 7 == 0;
        if (frames % 20 == 0) request.filter.name = frames % 40 == 0 ? "elliptical" : "trilinear";
        // The depth of the relief varies; as in a window, the previous frame is still held while the next is rendered.
        request.field = HeightField(request.field.sharedHeights(), Surface::Bilinear, Address::Repeat,
                                    0.05 + 0.01 * static_cast<double>(frames % 10));
        shown = renderer.render(request, work);
        if (used == 0 && passed() > 0.1 * seconds) {
            used = usedMegabytes();
            bytes = maps->bytes();
        }
    }
    ASSERT_GT(frames, 20);
    std::printf("%lld frames, memory %+.1f MB\n", static_cast<long long>(frames), usedMegabytes() - used);
    EXPECT_EQ(maps->bytes(), bytes);
    // The max pyramid, its depths for SIMD, and the cones once they pay off.
    EXPECT_EQ(work.counters().values()[MessageId::CountMapBuilds], 3)
        << "neither depth nor filter nor light needs another map";
    EXPECT_LT(usedMegabytes() - used, kMostGrowth);
}

bool sameFrame(const Frame& a, const Frame& b) {
    if (!(a.light->color == b.light->color) || !(a.color->color == b.color->color)) return false;
    if (a.rays->polygon != b.rays->polygon || a.shadows->shadowed != b.shadows->shadowed) return false;
    for (std::size_t i = 0; i < a.hits->hits.size(); ++i) {
        if (!sameBits(a.hits->hits[i], b.hits->hits[i])) return false;
    }
    return true;
}

// Buffers are reused, but never while somebody still holds them.
TEST(Orbit, buffersAreReusedOnlyWhenNobodyHoldsThem) {
    Work work;
    FrameRenderer renderer(std::make_shared<MapCache>());
    FrameRequest request = orbitRequest();
    std::vector<std::pair<FrameRequest, std::shared_ptr<const Frame>>> held;
    std::vector<const RayStage*> seen;
    int again = 0;
    for (int n = 0; n < 12; ++n) {
        request.camera.azimuth = 25.0 * n;
        if (n == 6) request.width = 200;
        if (n == 9) request.shadows = false;
        const auto frame = renderer.render(request, work);
        again += static_cast<int>(std::count(seen.begin(), seen.end(), frame->rays.get()));
        seen.push_back(frame->rays.get());
        if (n % 4 == 0) held.emplace_back(request, frame);
        FrameRenderer alone(std::make_shared<MapCache>());
        EXPECT_TRUE(sameFrame(*frame, *alone.render(request, work))) << n;
    }
    EXPECT_GT(again, 3);
    for (const auto& [earlier, frame] : held) {
        FrameRenderer alone(std::make_shared<MapCache>());
        EXPECT_TRUE(sameFrame(*frame, *alone.render(earlier, work)));
    }
}

}  // namespace
}  // namespace relief::test
