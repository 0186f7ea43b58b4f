// Histograms over the rays of a view: every ray is in one bin, and a bin gives the pixels that it contains.
#include "measuring/bench/view_bench.h"

#include <cmath>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "algorithms/measuring/rendered_view.h"
#include "algorithms/relief/fields.h"
#include "scenario/step_sentence.h"

namespace relief::test {
namespace {

struct View : RenderedView {
    HitBlock exact;

    View(const MethodChoice& method, Address address)
        : RenderedView(HeightField(share(makeRelief("bricks", 64, 48, 1)), Surface::Bilinear, address, 0.3), method, 48,
                       36) {
        NullSink sink;
        makeTracer({"exact", {}}, request.field, *maps, work)->trace(frame->rays->rays, exact, sink, work);
    }
    bool covered(int x, int y) const { return frame->rays->polygon[frame->index(x, y)] != kNoPolygon; }
    double errorOf(int x, int y) const {
        const std::size_t i = frame->index(x, y);
        return answerError(frame->hits->hits[i], exact[i], *frame->ray(x, y));
    }
    std::int64_t stepsOf(int x, int y) {
        RayBlock one;
        one.push(*frame->ray(x, y));
        HitBlock hit;
        BlockCounts counts;
        tracer->trace(one, hit, counts, work);
        return counts.steps;
    }
};

std::int64_t sumOf(const std::vector<std::int64_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

void expectPixels(View& view, const FrameHistograms& data, HistogramPart part, const std::vector<std::int64_t>& bins) {
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
        const auto pixels =
            pixelsOfBin(*view.frame, view.request, *view.tracer, data, {part, bin}, *view.maps, view.work);
        EXPECT_EQ(static_cast<std::int64_t>(pixels.size()), bins[bin]);
        double before = std::numeric_limits<double>::infinity();
        std::set<std::pair<int, int>> different;
        for (const PixelPlace& at : pixels) {
            ASSERT_TRUE(view.covered(at.x, at.y));
            different.insert({at.x, at.y});
            double worse = 0;
            if (part == HistogramPart::Steps) {
                worse = static_cast<double>(view.stepsOf(at.x, at.y));
                EXPECT_EQ(static_cast<std::size_t>(worse) / static_cast<std::size_t>(data.stepWidth), bin);
            } else {
                worse = static_cast<double>(static_cast<float>(view.errorOf(at.x, at.y)));
                EXPECT_EQ(std::min(data.errorBin(worse), bins.size() - 1), bin);
                const std::size_t i = view.frame->index(at.x, at.y);
                EXPECT_EQ(view.frame->hits->hits.lambda[i] > view.exact.lambda[i], part == HistogramPart::Behind);
            }
            EXPECT_LE(worse, before);
            before = worse;
        }
        EXPECT_EQ(different.size(), pixels.size());
    }
}

TEST(ViewBench, everyRayLiesInOneBinThatLeadsToItsPixel) {
    for (const MethodChoice& method :
         {MethodChoice{"offset", {}}, MethodChoice{"layers", {{"layers", "9"}}}, MethodChoice{"max-pyramid", {}}}) {
        for (const Address address : {Address::Repeat, Address::Border}) {
            SCOPED_TRACE(describe(method));
            View view(method, address);
            const FrameHistograms data =
                frameHistograms(*view.frame, view.request, *view.tracer, *view.maps, view.work);
            std::int64_t covered = 0, steps = 0, most = 0;
            double largest = 0;
            for (int y = 0; y < view.request.height; ++y) {
                for (int x = 0; x < view.request.width; ++x) {
                    if (!view.covered(x, y)) continue;
                    ++covered;
                    const std::int64_t here = view.stepsOf(x, y);
                    steps += here;
                    most = std::max(most, here);
                    const double error = view.errorOf(x, y);
                    if (std::isfinite(error)) largest = std::max(largest, error);
                }
            }
            EXPECT_EQ(data.rays, covered);
            EXPECT_EQ(sumOf(data.steps), covered);
            EXPECT_EQ(data.stepsMost, most);
            EXPECT_DOUBLE_EQ(data.stepsMean, static_cast<double>(steps) / static_cast<double>(covered));
            EXPECT_LE(data.stepsP95, most);
            EXPECT_EQ(sumOf(data.before) + sumOf(data.behind) + data.exact + data.wrong, covered);
            EXPECT_NEAR(data.largest, largest, 1e-9);
            EXPECT_EQ(data.exact == covered, method.name == "max-pyramid");
            expectPixels(view, data, HistogramPart::Steps, data.steps);
            expectPixels(view, data, HistogramPart::Before, data.before);
            expectPixels(view, data, HistogramPart::Behind, data.behind);
            for (const auto& [part, count] :
                 {std::pair{HistogramPart::Exact, data.exact}, std::pair{HistogramPart::Wrong, data.wrong}}) {
                const auto pixels =
                    pixelsOfBin(*view.frame, view.request, *view.tracer, data, {part, 0}, *view.maps, view.work);
                EXPECT_EQ(static_cast<std::int64_t>(pixels.size()), count);
            }
        }
    }
}

TEST(ViewBench, theWorstPixelIsFarthestFromExact) {
    View view({"exact", {}}, Address::Repeat);
    const auto worst = [&](const MethodChoice& method) {
        return worstPixel(*view.frame, view.request, method, *view.maps, view.work);
    };
    EXPECT_FALSE(worst({"max-pyramid", {}}));
    const MethodChoice layers{"layers", {{"layers", "5"}}};
    const auto found = worst(layers);
    ASSERT_TRUE(found);
    View other(layers, Address::Repeat);
    float most = 0;
    for (int y = 0; y < view.request.height; ++y) {
        for (int x = 0; x < view.request.width; ++x) {
            if (other.covered(x, y)) most = std::max(most, static_cast<float>(other.errorOf(x, y)));
        }
    }
    EXPECT_EQ(static_cast<float>(other.errorOf(found->x, found->y)), most);
}

TEST(ViewBench, sampledRaysAreUniformAndNoMoreThanRequested) {
    View view({"exact", {}}, Address::Repeat);
    std::size_t covered = 0;
    for (int y = 0; y < view.request.height; ++y) {
        for (int x = 0; x < view.request.width; ++x) covered += view.covered(x, y) ? 1 : 0;
    }
    EXPECT_EQ(sampledRays(*view.frame, 1U << 20U).size(), covered);
    for (const std::size_t most : {1U, 7U, 100U}) {
        const RayBlock rays = sampledRays(*view.frame, most);
        EXPECT_LE(rays.size(), most);
        EXPECT_GE(4 * rays.size() + 3, most) << "too few to decide";
    }
}

TEST(ViewBench, rowsAreOfTheMethodsThatKnowTheSurface) {
    View view({"exact", {}}, Address::Clamp);
    const HeightField columns(view.request.field.sharedHeights(), Surface::Columns, Address::Clamp, 0.3);
    std::vector<MethodChoice> methods;
    for (const MethodDescription& method : tracerList()) methods.push_back({method.name, {}});
    const RayBlock rays = sampledRays(*view.frame, 200);
    for (const HeightField& field : {view.request.field, columns}) {
        const auto rows = benchRaysOfView(field, rays, methods, 1, *view.maps, view.work);
        std::vector<std::string> expected, found;
        for (const MethodChoice& method : methods) {
            if (supports(method, field.surface(), field.address())) expected.push_back(method.name);
        }
        for (const BenchRow& row : rows) {
            found.push_back(row.method.name);
            EXPECT_EQ(row.surface, field.surface());
            EXPECT_GT(row.rate, 0) << row.method.name;
            EXPECT_GE(row.stepsMean, 1) << row.method.name;
            EXPECT_LE(row.stepsMean, static_cast<double>(row.stepsMax)) << row.method.name;
            if (findTracer(row.method.name).guarantee == Guarantee::Exact) {
                EXPECT_EQ(row.errors.max, 0) << row.method.name;
                EXPECT_EQ(row.errors.wrongOutcome, 0) << row.method.name;
            }
        }
        EXPECT_EQ(found, expected);
    }
    EXPECT_TRUE(benchRaysOfView(view.request.field, RayBlock(), methods, 1, *view.maps, view.work).empty());
}

}  // namespace
}  // namespace relief::test
