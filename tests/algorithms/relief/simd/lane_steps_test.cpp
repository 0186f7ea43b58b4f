// The displayed steps are those that rendered the pixel: SIMD in double takes the steps that the reference logs, one by
// one.
#include "lane_steps.h"

#include <functional>

#include <gtest/gtest.h>

#include "lanes.h"
#include "relief/methods/cone.h"
#include "relief/methods/cone_dummer.h"
#include "relief/methods/distance_march.h"
#include "relief/methods/layers.h"
#include "relief/methods/offset_limited.h"
#include "relief/methods/relaxed_cone.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261125;
constexpr std::size_t kRays = 150;

// Returns the numbers that SIMD records for a step; empty if it records none.
using Numbers = std::function<std::vector<double>(const Step&)>;

template <class Tracer>
LaneSteps logged(const Tracer& tracer, const ViewRay& ray, const Numbers& numbersOf) {
    LogSink log;
    tracer.trace(ray, log);
    LaneSteps all;
    for (const Step& step : log.steps) {
        if (std::vector<double> numbers = numbersOf(step); !numbers.empty()) all.push_back(std::move(numbers));
    }
    return all;
}

std::string textOf(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers) text += ' ' + numberText(number);
    return text;
}

// The last number of each step, its lambda afterwards, no greater than 1: SIMD continues below the relief, the log does
// not.
std::vector<LaneSteps> endingAtOne(std::vector<LaneSteps> all) {
    for (LaneSteps& ray : all) {
        for (std::vector<double>& step : ray) step.back() = std::min(step.back(), 1.0);
    }
    return all;
}

// apt: returns true for rays that SIMD traces at all.
template <class Tracer>
std::size_t expectSameSteps(const Tracer& tracer, const RayBlock& rays, const Numbers& numbersOf,
                            const std::function<bool(const ViewRay&)>& apt,
                            const std::function<std::vector<LaneSteps>()>& inLanes) {
    std::vector<LaneSteps> reference;
    std::size_t steps = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool taken = rays[i].finite() && apt(rays[i]);
        reference.push_back(taken ? logged(tracer, rays[i], numbersOf) : LaneSteps{});
        steps += reference.back().size();
    }
    onEveryTarget([&] {
        const std::vector<LaneSteps> lanes = inLanes();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const std::string where = describe(tracer.field()) + ": " + describe(rays[i]);
            for (std::size_t n = 0; n < std::min(lanes[i].size(), reference[i].size()); ++n) {
                ASSERT_TRUE(lanes[i][n] == reference[i][n])
                    << where << ": step " << n << ":" << textOf(reference[i][n]) << ", in lanes" << textOf(lanes[i][n]);
            }
            ASSERT_EQ(lanes[i].size(), reference[i].size()) << where;
        }
    });
    return steps;
}

// Calls body for maps of unusual sizes with every surface and addressing.
void onAwkwardFields(const std::function<void(const HeightField&, const RayBlock&)>& body) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{1, 1}, {1, 7}, {5, 3}, {33, 18}}) {
        for (const Surface surface : allSurfaces()) {
            for (const Address address : allAddresses()) {
                const HeightField field(randomHeights(width, height, kSeed), surface, address, 0.3);
                body(field, awkwardRays(field, kSeed, kRays));
            }
        }
    }
}

TEST(LaneSteps, walksOverDistances) {
    std::size_t steps = 0;
    Work work(1);
    const Numbers numbers = [](const Step& step) -> std::vector<double> {
        const auto* const voxel = step.as<subject::Voxel>();
        if (voxel == nullptr) return {};
        // For a hit the log has the hit's lambda in place of the cell's end, to which SIMD continues.
        const double after = step.decision == Decision::Hit ? step.lambdaOut : step.lambdaAfter;
        return {static_cast<double>(voxel->i),
                static_cast<double>(voxel->j),
                static_cast<double>(voxel->k),
                step.value,
                step.lambdaIn,
                after};
    };
    onAwkwardFields([&](const HeightField& field, const RayBlock& rays) {
        MapCache cache;
        for (const DistanceKind kind : {DistanceKind::EuclideanConservative, DistanceKind::Refined}) {
            if (kind == DistanceKind::Refined && field.address() == Address::Clamp) continue;  // no such map exists
            for (const int footprint : {1, 4}) {
                for (const StepRule rule : {StepRule::Exit, StepRule::Classic}) {
                    DistanceParameters parameters;
                    parameters.footprint = footprint;
                    const DistanceWalk walk(field, distanceMap(kind, parameters, field, cache, work), rule);
                    const auto apt = [&](const ViewRay& ray) {
                        const GridRay on(walk.grid(), ray);
                        return on.inDomain() && walk.perLambda(on) > 0;
                    };
                    steps += expectSameSteps(walk, rays, numbers, apt,
                                             [&] { return endingAtOne(stepsInLanes(walk, rays)); });
                }
            }
        }
    });
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 50000U);
}

TEST(LaneSteps, marchesByDistances) {
    std::size_t steps = 0;
    Work work(1);
    const Numbers numbers = [](const Step& step) -> std::vector<double> {
        if (step.decision != Decision::Advance || step.as<subject::Sphere>() == nullptr) return {};
        return {step.lambdaIn, step.value, step.lambdaAfter};
    };
    onAwkwardFields([&](const HeightField& field, const RayBlock& rays) {
        MapCache cache;
        const auto map = distanceMap(DistanceKind::Euclidean, {}, field, cache, work);
        for (const MarchEnd end :
             {MarchEnd{MarchStop::Surface, 0}, MarchEnd{MarchStop::Distance, 0.01}, MarchEnd{MarchStop::Never, 0}}) {
            const DistanceMarch march(field, map, 24, end);
            // Other rays are traced by the exact method, or cross more periods than can be counted.
            const auto apt = [&](const ViewRay& ray) {
                return std::hypot(ray.a, ray.b) <= map->maxRun && std::max(std::abs(ray.a), std::abs(ray.b)) < 0x1p40;
            };
            const MarchSearch search{field, *map, 24, end};
            steps += expectSameSteps(march, rays, numbers, apt, [&] { return stepsInLanes(search, rays); });
        }
    });
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 20000U);
}

TEST(LaneSteps, walksOverTexelCones) {
    std::size_t steps = 0;
    Work work(1);
    onAwkwardFields([&](const HeightField& field, const RayBlock& rays) {
        MapCache cache;
        const CellGrid grid(field);
        const Numbers numbers = [&](const Step& step) -> std::vector<double> {
            if (step.as<subject::Cone>() == nullptr) return {};
            // For a hit the log has the hit's lambda in place of the cell's end, to which SIMD continues.
            const double after = step.decision == Decision::Hit ? step.lambdaOut : step.lambdaAfter;
            return {static_cast<double>(step.i - grid.x.firstName),
                    static_cast<double>(step.j - grid.y.firstName),
                    step.value,
                    step.lambdaIn,
                    step.lambdaOut,
                    after};
        };
        for (const int sectors : {1, 5}) {
            for (const Precision precision : {Precision::Float, Precision::U16, Precision::U8}) {
                ConeParameters parameters;
                parameters.sectors = sectors;
                parameters.precision = precision;
                const auto map = coneMap(ConeKind::Conservative, parameters, field, cache, work);
                const auto apt = [&](const ViewRay& ray) { return GridRay(grid, ray).inDomain(); };
                steps += expectSameSteps(ConeTracer(field, map), rays, numbers, apt, [&] {
                    return endingAtOne(stepsInLanes(ConeCellSearch{field, grid, *map}, rays));
                });
            }
        }
    });
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 20000U);
}

TEST(LaneSteps, marchesByTexelCones) {
    std::size_t steps = 0;
    Work work(1);
    const Numbers numbers = [](const Step& step) -> std::vector<double> {
        if (step.decision == Decision::Refine) return {step.lambdaIn, step.lambdaOut, step.value};
        if (step.as<subject::Cone>() == nullptr) return {};
        return {step.lambdaIn, step.value, step.lambdaAfter};
    };
    onAwkwardFields([&](const HeightField& field, const RayBlock& rays) {
        MapCache cache;
        for (const ConeKind kind : {ConeKind::Dummer, ConeKind::Robust, ConeKind::Relaxed, ConeKind::RelaxedRobust}) {
            const bool robust = kind == ConeKind::Robust || kind == ConeKind::RelaxedRobust;
            if (robust && field.surface() != Surface::Bilinear) continue;
            for (const Precision precision : {Precision::Float, Precision::U8}) {
                for (const int bisections : {0, 6}) {
                    ConeParameters parameters;
                    parameters.precision = precision;
                    if (areRelaxed(kind)) parameters.radius = 8;
                    const auto map = coneMap(kind, parameters, field, cache, work);
                    const auto apt = [](const ViewRay& ray) {
                        return std::max({std::abs(ray.s0), std::abs(ray.t0), std::abs(ray.a), std::abs(ray.b)}) <
                               0x1p40;
                    };
                    steps += expectSameSteps(ConeMarch(field, map, 15, bisections), rays, numbers, apt, [&] {
                        return stepsInLanes(ConeMarchSearch{field, *map, 15, bisections}, rays);
                    });
                }
            }
        }
    });
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 20000U);
}

// traceSegment() as trace(), the same segment for all rays.
template <class Tracer>
struct Within {
    const Tracer& tracer;
    Segment segment;
    const HeightField& field() const { return tracer.field(); }
    void trace(const ViewRay& ray, LogSink& log) const { tracer.traceSegment(ray, segment, log); }
};

// Inside `hybrid` the same walks trace segments.
TEST(LaneSteps, staysWithinSegments) {
    std::size_t steps = 0;
    Work work(1);
    // Lambdas and values; for a hit in a cell the log has the hit's lambda in place of the cell's end.
    const Numbers cones = [](const Step& step) -> std::vector<double> {
        if (step.as<subject::Cone>() == nullptr) return {};
        return {step.value, step.lambdaIn, step.lambdaOut};
    };
    const Numbers march = [](const Step& step) -> std::vector<double> {
        if (step.decision == Decision::Refine) return {step.lambdaIn, step.lambdaOut, step.value};
        if (step.as<subject::Cone>() == nullptr) return {};
        return {step.lambdaIn, step.value, step.lambdaAfter};
    };
    const Numbers voxels = [](const Step& step) -> std::vector<double> {
        if (step.as<subject::Voxel>() == nullptr) return {};
        return {step.value, step.lambdaIn};
    };
    // Keeps the numbers of the lanes' steps from `first` to `last` - 1.
    const auto part = [](std::vector<LaneSteps> all, int first, int last) {
        for (LaneSteps& ray : all) {
            for (std::vector<double>& step : ray) step = {step.begin() + first, step.begin() + last};
        }
        return all;
    };
    onAwkwardFields([&](const HeightField& field, const RayBlock& rays) {
        MapCache cache;
        const CellGrid grid(field);
        const auto conservative = coneMap(ConeKind::Conservative, {}, field, cache, work);
        const auto dummer = coneMap(ConeKind::Dummer, {}, field, cache, work);
        const auto distances = distanceMap(DistanceKind::EuclideanConservative, {}, field, cache, work);
        const ConeTracer cells(field, conservative);
        const ConeMarch marching(field, dummer, 15, 4);
        const DistanceWalk walk(field, distances);
        const auto exact = [&](const ViewRay& ray) {
            const GridRay on(grid, ray);
            return on.inDomain() && walk.perLambda(on) > 0;
        };
        const auto near = [](const ViewRay& ray) {
            return std::max({std::abs(ray.s0), std::abs(ray.t0), std::abs(ray.a), std::abs(ray.b)}) < 0x1p40;
        };
        for (const Segment segment : {Segment{0, 0.3}, Segment{0.25, 0.7}, Segment{0.5, 0.5}, Segment{0.6, 1}}) {
            const std::vector<Segment> segments(rays.size(), segment);
            const Segment* const all = segments.data();
            steps += expectSameSteps(Within<ConeTracer>{cells, segment}, rays, cones, exact, [&] {
                return part(stepsInLanes(ConeCellSearch{field, grid, *conservative}, rays, all), 2, 5);
            });
            steps += expectSameSteps(Within<ConeMarch>{marching, segment}, rays, march, near, [&] {
                return stepsInLanes(ConeMarchSearch{field, *dummer, 15, 4}, rays, all);
            });
            steps += expectSameSteps(Within<DistanceWalk>{walk, segment}, rays, voxels, exact,
                                     [&] { return part(stepsInLanes(walk, rays, all), 3, 5); });
        }
    });
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 20000U);
}

TEST(LaneSteps, shiftsByOffset) {
    std::size_t steps = 0;
    const Numbers numbers = [](const Step& step) -> std::vector<double> {
        if (step.decision != Decision::Hit) return {};
        return {step.value, step.lambdaAfter};
    };
    onAwkwardFields([&](const HeightField& field, const RayBlock& rays) {
        const auto near = [](const ViewRay& ray) { return std::max(std::abs(ray.s0), std::abs(ray.t0)) < 0x1p40; };
        // Rays that are shifted out of the map are sampled as well, but the log has only their miss.
        const auto staysInside = [&](const ViewRay& ray, double lambda) {
            return SampledSurface(field, ray).inside(lambda);
        };
        const auto inLanes = [&](bool limited) {
            std::vector<LaneSteps> all = stepsInLanes(OffsetSearch{field, limited}, rays);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                if (!all[i].empty() && !staysInside(rays[i], all[i].front().back())) all[i].clear();
            }
            return all;
        };
        steps += expectSameSteps(OffsetTracer(field), rays, numbers, near, [&] { return inLanes(false); });
        steps += expectSameSteps(OffsetLimitedTracer(field), rays, numbers, near, [&] { return inLanes(true); });
    });
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 5000U);
}

TEST(LaneSteps, searchesThroughLayers) {
    std::size_t steps = 0;
    const Numbers numbers = [](const Step& step) -> std::vector<double> {
        const auto* const layer = step.as<subject::Layer>();
        if (layer == nullptr) return {};
        return {static_cast<double>(layer->n), step.lambdaOut, step.value};
    };
    onAwkwardFields([&](const HeightField& field, const RayBlock& rays) {
        LayersTracer::Options options;
        options.layers = 17;
        const LayersTracer layers(field, options);
        const LayerSearch search{field, 17, LayerRefinement::None, 0};
        const auto apt = [&](const ViewRay& ray) {
            return field.address() != Address::Repeat || std::max(std::abs(ray.a), std::abs(ray.b)) < 0x1p40;
        };
        steps += expectSameSteps(layers, rays, numbers, apt, [&] {
            std::vector<LaneSteps> all = stepsInLanes(search, rays);
            // Converted to the value in the log: the surface's height.
            for (LaneSteps& ray : all) {
                for (std::vector<double>& step : ray) step[2] = step[2] + 1 - step[1];
            }
            return all;
        });
    });
    std::printf("%zu steps\n", steps);
    EXPECT_GT(steps, 20000U);
}

}  // namespace
}  // namespace relief::test
