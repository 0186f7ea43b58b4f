// The guarantee of each listed tracer, compared with the exact hit: conservative methods never overshoot, and the error
// rates of approximate ones have not grown since they were recorded.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

#include <gtest/gtest.h>

#include "fields.h"
#include "images/pyramid.h"
#include "relief/cell_grid.h"
#include "relief/files.h"

namespace relief::test {
namespace {

// A hit further than this from the exact one, in texels along the ray, is wrong.
constexpr double kWrongTexels = 1;
// Factor by which rates may exceed the recorded ones (rounding on other machines, tuning of options).
constexpr double kWorse = 1.2;
// Rates of less than this many rays are not compared: one ray more is no trend.
constexpr double kFewRays = 5;
constexpr std::size_t kRateRays = 4000;
// A conservative method stops in front of the surface or on it; it may overshoot by the leaf's rounding at most.
constexpr double kRounding = 1e-12;

const std::vector<std::string> kFamilies{"bricks", "spikes", "pits", "columns", "city", "fractal", "hills"};

double texelsOff(const ViewRay& ray, const Hit& a, const Hit& b) {
    return std::abs(a.lambda - b.lambda) * std::max(1.0, std::hypot(ray.a, ray.b));
}

// 10^6 rays (10^7 with RELIEF_LONG) over reliefs, sizes, surfaces, addressings and depths for each such method.
TEST(Guarantees, conservativeMethodsNeverOvershoot) {
    const std::vector<MethodChoice> choices = choicesThatPromise(Guarantee::Conservative);
    if (choices.empty()) GTEST_SKIP() << "no conservative tracer is listed";
    const std::size_t wanted = std::getenv("RELIEF_LONG") != nullptr ? 10'000'000 : 1'000'000;
    const std::vector<std::pair<int, int>> sizes{{128, 128}, {100, 37}, {33, 64}};
    const std::size_t fields = kFamilies.size() * sizes.size() * 6;
    const std::size_t perField = wanted / (fields * choices.size()) + 1;
    MapCache cache;
    Work work;
    std::size_t total = 0;
    std::size_t limits = 0;
    std::uint64_t seed = 5000;
    for (const std::string& family : kFamilies) {
        for (const auto& [w, h] : sizes) {
            const Heights heights = share(makeRelief(family, w, h, seed));
            for (const Surface surface : allSurfaces()) {
                for (const Address address : allAddresses()) {
                    const HeightField field(heights, surface, address, 0.05 + 0.1 * static_cast<double>(seed % 4));
                    const RayBlock rays = randomRays(++seed, field, perField, 1);
                    HitBlock truth;
                    NullSink sink;
                    makeTracer({"exact", {}}, field, cache, work)->trace(rays, truth, sink, work);
                    for (const MethodChoice& choice : choices) {
                        if (!supports(choice, surface, address)) continue;
                        const auto tracer = makeTracer(choice, field, cache, work);
                        HitBlock hits;
                        tracer->trace(rays, hits, sink, work);
                        for (std::size_t i = 0; i < rays.size(); ++i) {
                            const bool late = truth.outcome[i] == Outcome::Hit && hits.outcome[i] != Outcome::Limit &&
                                              !(hits.lambda[i] <= truth.lambda[i] + kRounding);
                            ASSERT_FALSE(late) << describe(choice) << " on " << family << " " << describe(field)
                                               << " seed " << seed << " ray " << describe(rays[i]) << ": "
                                               << hits.lambda[i] << ", exact " << truth.lambda[i];
                            limits += hits.outcome[i] == Outcome::Limit ? 1 : 0;
                        }
                        total += rays.size();
                    }
                }
            }
        }
    }
    std::cout << total << " rays, seeds from 5000: no overshoot; " << limits << " step limits\n";
}

std::string rateKey(const MethodChoice& choice, const std::string& family, Surface surface) {
    return describe(choice) + "," + family + "," + std::string(surfaceName(surface));
}

std::map<std::string, double> recordedRates() {
    std::map<std::string, double> rates;
    std::ifstream file(RELIEF_WRONG_RATES);
    std::string line;
    while (std::getline(file, line)) {
        const std::size_t comma = line.rfind(',');
        if (comma == std::string::npos || line.starts_with("method,")) continue;
        rates[line.substr(0, comma)] = parseNumber(line.substr(comma + 1), RELIEF_WRONG_RATES);
    }
    return rates;
}

// Rates are recorded in wrong_rates.csv in this folder. For a new method, RELIEF_RECORD=FILE writes the measured ones.
TEST(Guarantees, approximateMethodsAreNoWorseThanRecorded) {
    const std::map<std::string, double> recorded = recordedRates();
    ASSERT_FALSE(recorded.empty());
    const char* record = std::getenv("RELIEF_RECORD");
    std::ofstream out(record != nullptr ? record : "");
    if (record != nullptr) out << "method,relief,surface,wrong_rate\n";
    MapCache cache;
    Work work;
    for (const std::string& family : kFamilies) {
        for (const Surface surface : allSurfaces()) {
            const HeightField field(share(makeRelief(family, 128, 128, 1)), surface, Address::Repeat, 0.1);
            const RayBlock rays = randomRays(7000, field, kRateRays, 5);
            HitBlock truth;
            NullSink sink;
            makeTracer({"exact", {}}, field, cache, work)->trace(rays, truth, sink, work);
            for (const MethodChoice& choice : choicesThatPromise(Guarantee::Approximate)) {
                if (!supports(choice, surface, Address::Repeat)) continue;
                HitBlock hits;
                makeTracer(choice, field, cache, work)->trace(rays, hits, sink, work);
                double wrong = 0;
                for (std::size_t i = 0; i < rays.size(); ++i) {
                    wrong += hits.outcome[i] != Outcome::Hit || texelsOff(rays[i], hits[i], truth[i]) > kWrongTexels;
                }
                const std::string key = rateKey(choice, family, surface);
                if (record != nullptr) out << key << "," << numberText(wrong / kRateRays) << "\n";
                const auto known = recorded.find(key);
                if (known == recorded.end()) {
                    ADD_FAILURE() << "no recorded rate; if it is right, add to wrong_rates.csv:\n"
                                  << key << "," << numberText(wrong / kRateRays);
                    continue;
                }
                EXPECT_LE(wrong, kWorse * known->second * kRateRays + kFewRays) << key;
            }
        }
    }
}

// Tracing with a base level equals tracing the mean pyramid's level as a height map. For sizes that are divisible by
// two, the bits are the same.
TEST(Guarantees, baseLevelTracesTheMeanLevel) {
    MapCache cache;
    Work work;
    const Heights heights = randomHeights(64, 32, 19);
    const Pyramid means(PyramidKind::Mean, *heights, work);
    for (const char* name : {"max-pyramid", "max-pyramid-paper"}) {
        for (const int level : {1, 2, 5}) {
            for (const Surface surface : allSurfaces()) {
                for (const Address address : allAddresses()) {
                    const HeightField field(heights, surface, address, 0.2);
                    const HeightField coarse(share(FloatImage(means.level(level))), surface, address, 0.2);
                    const auto tracer = makeTracer({name, {{"base", std::to_string(level)}}}, field, cache, work);
                    const auto truth = makeTracer({"exact", {}}, coarse, cache, work);
                    EXPECT_EQ(tracer->baseLevel(), level);
                    EXPECT_EQ(tracer->guarantee(), Guarantee::Approximate);
                    Random random(23);
                    const double scale = 1.0 / (1 << level);
                    for (int i = 0; i < 500; ++i) {
                        const ViewRay ray = randomRay(random, field, 2);
                        const Logged logged = traceLogged(*tracer, ray);
                        const Hit wanted =
                            traceLogged(*truth, {ray.s0 * scale, ray.t0 * scale, ray.a * scale, ray.b * scale}).hit;
                        ASSERT_EQ(logged.hit.outcome, wanted.outcome);
                        if (wanted.outcome != Outcome::Hit) continue;
                        ASSERT_EQ(logged.hit.lambda, wanted.lambda) << describe(field) << " ray " << describe(ray);
                        ASSERT_EQ(logged.hit.s, ray.s0 + wanted.lambda * ray.a);
                        for (const Step& step : logged.steps) ASSERT_GE(step.level, level);
                    }
                }
            }
        }
    }
}

// For other sizes no ray is lost, and the hit lies on the mean level's surface.
TEST(Guarantees, baseLevelOfOddSizesLosesNoRay) {
    MapCache cache;
    Work work;
    const HeightField field(randomHeights(37, 19, 29), Surface::Bilinear, Address::Repeat, 0.2);
    const Pyramid means(PyramidKind::Mean, field.heights(), work);
    const HeightField coarse(share(FloatImage(means.level(2))));
    const auto tracer = makeTracer({"max-pyramid", {{"base", "2"}}}, field, cache, work);
    Random random(31);
    for (int i = 0; i < 3000; ++i) {
        const ViewRay ray = randomRay(random, field, 2);
        const Hit hit = traceLogged(*tracer, ray).hit;
        ASSERT_EQ(hit.outcome, Outcome::Hit);
        // Reduced to the period first and scaled afterwards: the coarse texels do not divide the period.
        const double s = reduceToPeriod(ray.s0, 37) * 10 / 37 + hit.lambda * ray.a * 10 / 37;
        const double t = reduceToPeriod(ray.t0, 19) * 5 / 19 + hit.lambda * ray.b * 5 / 19;
        ASSERT_NEAR(coarse.at(s, t), 1 - hit.lambda, 1e-11) << describe(ray);
    }
}

}  // namespace
}  // namespace relief::test
