// The surface along a ray: it is the traced one, and subsampling keeps its extremes.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "panes/distance/distance_drawing.h"
#include "panes/distance/distance_slice.h"
#include "relief/tracers/map_choice.h"
#include "traced_ray.h"

namespace reliefui {
namespace {

using relief::Address;
using relief::Surface;

// Returns the height of the polyline at lambda, interpolated between its points.
double heightOn(const std::vector<Point>& line, double lambda) {
    const auto next =
        std::lower_bound(line.begin(), line.end(), lambda, [](const Point& p, double x) { return p.x < x; });
    if (next == line.begin()) return next->y;
    if (next == line.end()) return line.back().y;
    const Point& b = *next;
    const Point& a = *(next - 1);
    return b.x > a.x ? a.y + (lambda - a.x) / (b.x - a.x) * (b.y - a.y) : b.y;
}

TEST(Slice, theSurfaceIsTheOneThatIsTraced) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            const Traced t("fractal", 37, 20, surface, address);
            for (int n = 0; n < 20; ++n) {
                const double far = address == Address::Repeat ? 500 : 0;
                const relief::ViewRay ray{unit(random) * 37 + far, unit(random) * 20 - far, unit(random) * 60 - 30,
                                          unit(random) * 60 - 30};
                SliceRange range;
                range.columns = 4000;
                range.rows = 1000;
                const SurfaceLine line = surfaceAlong(t.walk(), ray, range);
                ASSERT_FALSE(line.points.empty());
                EXPECT_TRUE(std::is_sorted(line.points.begin(), line.points.end(),
                                           [](const Point& p, const Point& q) { return p.x < q.x; }));
                EXPECT_NEAR(line.points.back().x, lambdaInside(t.walk(), ray), kRounding);
                const double quarterPixel = 0.25 / range.rows;
                for (int k = 0; k < 300; ++k) {
                    const double lambda = unit(random) * line.points.back().x;
                    EXPECT_NEAR(heightOn(line.points, lambda), surfaceAt(t.field, ray, lambda),
                                quarterPixel + kRounding)
                        << lambda;
                }
            }
        }
    }
}

// A plateau is at least as high as the surface below it, and covers exactly the ray's interval in the texel.
TEST(Slice, plateausLieOverTheSurfaceAndCoverTheRay) {
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
        const Traced t("hills", 37, 20, Surface::Bilinear, address);
        for (int n = 0; n < 20; ++n) {
            const relief::ViewRay ray{unit(random) * 37, unit(random) * 20, unit(random) * 90 - 45,
                                      unit(random) * 90 - 45};
            SliceRange range;
            range.columns = 1e6;
            for (int level = 0; level <= t.walk().top(); ++level) {
                double at = 0;
                for (const Plateau& plateau : plateausAlong(t.walk(), ray, level, range)) {
                    EXPECT_FALSE(plateau.joined);
                    EXPECT_EQ(plateau.texel.level, level);
                    EXPECT_EQ(plateau.texel.lambdaIn, at) << "no gap, no overlap";
                    at = plateau.texel.lambdaOut;
                    const double middle = (plateau.texel.lambdaIn + plateau.texel.lambdaOut) / 2;
                    EXPECT_LE(surfaceAt(t.field, ray, middle), plateau.texel.value + kRounding);
                }
                EXPECT_NEAR(at, lambdaInside(t.walk(), ray), kRounding);
            }
        }
    }
}

TEST(Slice, thinningKeepsHighestAndLowest) {
    const Traced t("spikes", 256, 256, Surface::Columns, Address::Repeat);
    const relief::ViewRay ray{3.3, 7.1, 7000, 3000};
    SliceRange fine;
    fine.columns = 1e6;
    SliceRange coarse;
    coarse.columns = 500;
    const SurfaceLine all = surfaceAlong(t.walk(), ray, fine);
    const SurfaceLine thin = surfaceAlong(t.walk(), ray, coarse);
    EXPECT_FALSE(all.thinned);
    EXPECT_TRUE(thin.thinned);
    EXPECT_GT(all.points.size(), 15000u);
    EXPECT_LE(thin.points.size(), 4 * 501u);
    const auto lower = [](const Point& p, const Point& q) { return p.y < q.y; };
    const auto [low, high] = std::minmax_element(all.points.begin(), all.points.end(), lower);
    const auto [thinLow, thinHigh] = std::minmax_element(thin.points.begin(), thin.points.end(), lower);
    EXPECT_EQ(low->y, thinLow->y);
    EXPECT_EQ(high->y, thinHigh->y);
}

TEST(Slice, aPlaceIsFoundAgainFromItsPointInAnySlice) {
    const Place3 place{3.25, 7.5, 4};
    constexpr double kSlab = 12;
    for (const SliceAxis axis : {SliceAxis::X, SliceAxis::Y, SliceAxis::Z}) {
        const Point at = toSlice(axis, kSlab, place);
        EXPECT_EQ(fromSlice(axis, kSlab, place[static_cast<std::size_t>(axis)], at), place);
    }
}

// The slice of a distance map through a relief of columns.
struct CityMap {
    Traced traced{"city", 37, 20, Surface::Columns, Address::Repeat};
    SlicedMap sliced{relief::buildMap("euclidean", {}, traced.field, traced.cache, traced.work), traced.field};
    DistanceSource source;
    CityMap() {
        source.field = &traced.field;
        source.maxima = traced.source.maxima;
        source.first = &sliced;
    }
};

// The plot begins and ends within texels, whose surface is seen in part.
TEST(Slice, theSurfaceReachesBothSidesOfThePlot) {
    const CityMap city;
    for (const SliceAxis axis : {SliceAxis::X, SliceAxis::Y}) {
        for (const double width : {300.0, 470.0}) {
            DistanceOptions options;
            options.axis = axis;
            options.isoLines = false;
            const DistancePicture picture = distancePicture(city.source, options, 0, width, 300, {});
            const DistanceFrame& frame = picture.frame;
            double low = frame.plot.x1, high = frame.plot.x0;
            for (const Item& item : picture.drawing.items) {
                if (item.id.kind != ItemKind::Surface) continue;
                for (const Point& p : std::get<Polyline>(item.primitive).points) {
                    low = std::min(low, p.x);
                    high = std::max(high, p.x);
                }
            }
            EXPECT_NEAR(low, frame.plot.x0, 1e-6) << frame.window.x0;
            EXPECT_NEAR(high, frame.plot.x1, 1e-6) << frame.window.x1;
        }
    }
}

TEST(Slice, aStepBeyondTheLastIsTheLast) {
    CityMap city;
    const relief::ViewRay ray{3.3, 7.1, 14, 9};
    city.traced.trace(ray, {"distance-conservative", {}});
    city.source.hasRay = true;
    city.source.ray = ray;
    city.source.hit = city.traced.source.hit;
    std::vector<relief::Step> steps = city.traced.log.steps;
    city.source.steps = &steps;
    ASSERT_GT(steps.size(), 3U);
    for (; !steps.empty(); steps.pop_back()) {
        const int last = static_cast<int>(steps.size()) - 1;
        for (const SliceAxis axis : {SliceAxis::X, SliceAxis::Y}) {
            DistanceOptions options;
            options.axis = axis;
            EXPECT_EQ(distanceFrame(city.source, options, last + 3, 400, 300).cut,
                      distanceFrame(city.source, options, last, 400, 300).cut);
        }
    }
}

// Conservative cones belong to cells between texel centres, published ones to the texels.
TEST(SlicedMap, conesAreSampledAtTheirPositions) {
    relief::FloatImage heights(9, 7);
    std::mt19937 random(4);
    for (float& h : heights.pixels()) h = static_cast<float>(random() % 1000) / 1000;
    const relief::HeightField field(std::make_shared<const relief::FloatImage>(heights), Surface::Bilinear,
                                    Address::Repeat, 0.2);
    relief::MapCache cache;
    relief::Work work(1);
    for (const char* kind : {"cone", "cone-dummer"}) {
        const relief::StoredMap stored = relief::buildMap(kind, {}, field, cache, work);
        const auto& cones = *std::get<std::shared_ptr<const relief::ConeMap>>(stored);
        const SlicedMap sliced(stored, field);
        const double shift = std::string(kind) == "cone" ? 0.5 : 0;
        for (int j = 1; j < 6; ++j) {
            for (int i = 1; i < 8; ++i) {
                EXPECT_EQ(sliced.at({i + shift + 0.3, j + shift + 0.2, 0.01}, 0), cones.slopes(i, j, 0)) << kind;
            }
        }
    }
}

}  // namespace
}  // namespace reliefui
