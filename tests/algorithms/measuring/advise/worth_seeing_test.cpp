#include "measuring/advise/worth_seeing.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "algorithms/measuring/rendered_view.h"
#include "algorithms/relief/fields.h"

namespace relief::test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kEndless = std::numeric_limits<float>::infinity();

TEST(WorthSeeing, TheLargestComeFirstAndApart) {
    std::vector<float> values(20 * 10, 0);
    values[0] = kNan;
    values[3 * 20 + 4] = 5;
    values[3 * 20 + 5] = 4;  // a neighbour of the maximum
    values[8 * 20 + 15] = kEndless;
    values[1 * 20 + 15] = 4;
    values[9] = -1;
    const auto found = largestApart(values, 20, 3, 10);
    const std::vector<PixelWorth> expected{{15, 8, kEndless}, {4, 3, 5}, {15, 1, 4}};
    EXPECT_EQ(found, expected);
    EXPECT_EQ(largestApart(values, 20, 3, 1).size(), 1U);
    EXPECT_EQ(largestApart(values, 20, 1, 10).size(), 4U) << "neighbours count if no distance is required";
}

struct Rendered : RenderedView {
    explicit Rendered(const MethodChoice& method)
        : RenderedView(HeightField(share(makeRelief("bricks", 48, 48, 1)), Surface::Bilinear), method, 60, 40) {}
};

TEST(WorthSeeing, WhatRanksIsWhatTheLayersSay) {
    Rendered view({"layers", {{"layers", "5"}}});
    const ErrorLayer errors = errorAgainstExact(*view.frame, view.request, *view.maps, view.work);
    const auto far = largestApart(errorWorth(Worth::Error, *view.frame, errors), 60, 4, 6);
    ASSERT_FALSE(far.empty());
    EXPECT_EQ(far.front().value, static_cast<float>(errors.largest));
    for (const PixelWorth& at : largestApart(errorWorth(Worth::Overshoot, *view.frame, errors), 60, 4, 6)) {
        const ErrorKind kind = errors.kinds[view.frame->index(at.x, at.y)];
        EXPECT_TRUE(kind == ErrorKind::Past || kind == ErrorKind::Wrong);
    }
    // The steps of every ray equal those of its log.
    const auto steps = largestApart(stepWorth(*view.frame, *view.tracer, view.work), 60, 4, 3);
    ASSERT_FALSE(steps.empty());
    RayBlock rays;
    rays.push(*view.frame->ray(steps.front().x, steps.front().y));
    HitBlock hits;
    StepLog log;
    view.tracer->trace(rays, hits, log, view.work);
    EXPECT_EQ(steps.front().value, static_cast<double>(log.steps.size()));
}

TEST(WorthSeeing, MethodsDisagreeAsMuchAsTheirHitsLieApart) {
    Rendered view({"layers", {{"layers", "5"}}});
    const auto exact = makeTracer({"exact", {}}, view.request.field, *view.maps, view.work);
    const std::vector<float> apart = disagreement(*view.frame, *exact, view.work);
    const ErrorLayer errors = errorAgainstExact(*view.frame, view.request, *view.maps, view.work);
    ASSERT_EQ(apart.size(), errors.texels.size());
    for (std::size_t i = 0; i < apart.size(); ++i) {
        if (std::isnan(errors.texels[i])) {
            EXPECT_TRUE(std::isnan(apart[i]));
        } else {
            ASSERT_EQ(apart[i], errors.texels[i]) << i;
        }
    }
    const auto itself = makeTracer(view.request.method, view.request.field, *view.maps, view.work);
    EXPECT_TRUE(largestApart(disagreement(*view.frame, *itself, view.work), 60, 4, 3).empty());
}

}  // namespace
}  // namespace relief::test
