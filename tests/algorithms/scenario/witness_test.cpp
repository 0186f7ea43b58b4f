// A witness is a scenario that shows one ray: the ray of its chosen pixel is the given one.
#include "scenario/witness.h"

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "rendering/frame.h"

namespace relief::test {

TEST(Witness, ItsPixelHasTheRay) {
    constexpr double kTexels = 1e-9;  // positions up to 100 texels and a few roundings of the camera's frame
    Scenario scenario;
    scenario.pictures.recipe = "bricks";
    scenario.reliefDepth = 0.15;
    Work work;
    AssetStore store;
    const HeightField field = frameRequest(scenario, store.load(scenario.pictures, work)).field;
    for (const ViewRay& ray : {ViewRay{10.25, 20.5, 3, -7}, ViewRay{40, 8, 0.5, 0.25}, ViewRay{30, 16, 300, 200}}) {
        const Scenario shown = witness(scenario, field, ray);
        const FrameRequest request = frameRequest(shown, store.load(shown.pictures, work));
        ASSERT_TRUE(shown.pixel);
        const auto seen = pixelRay(request, shown.pixel->x, shown.pixel->y);
        ASSERT_TRUE(seen) << ray.a;
        EXPECT_NEAR(seen->s0, ray.s0, kTexels);
        EXPECT_NEAR(seen->t0, ray.t0, kTexels);
        EXPECT_NEAR(seen->a, ray.a, kTexels * ray.a);
        EXPECT_NEAR(seen->b, ray.b, kTexels * std::abs(ray.b) + kTexels);
    }
}

}  // namespace relief::test
