// relief stress must find faults put into tracers, and find none in the listed tracers.
#include "measuring/verify/stress.h"

#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"
#include "algorithms/measuring/altered_tracer.h"
#include "measuring/verify/stress_cases.h"
#include "relief/cell_grid.h"
#include "relief/files.h"
#include "relief/reliefs.h"
#include "scenario/ray_files.h"

namespace relief::test {
namespace {

class StressTest : public ::testing::Test {
  protected:
    // A run with a fixed number of cases, which does not depend on time.
    StressReport run(std::vector<MeasuredMethod> methods, int threads = 2, int moreRays = 0) {
        StressOptions options;
        options.seconds = 0;
        options.seed = 7;
        options.moreRays = moreRays;
        options.methods = std::move(methods);
        options.parts = {StressPart::Tracers};
        options.folder = folder_ / ".";
        Work work(threads);
        return stress(options, work);
    }
    // Returns the first violation of that check.
    static const StressViolation* find(const StressReport& report, const std::string& check) {
        for (const StressViolation& v : report.violations) {
            if (v.fault.check == check) return &v;
        }
        return nullptr;
    }

    // Returns the lambda that `exact` finds for a printed command, parsed from its text alone.
    static double exactLambda(const std::string& command) {
        const auto word = [&](const std::string& flag, const std::string& otherwise) {
            const std::size_t at = command.find(" " + flag + " ");
            if (at == std::string::npos) return otherwise;
            const std::size_t begin = at + flag.size() + 2;
            return command.substr(begin, command.find(' ', begin) - begin);
        };
        Work work(1);
        FloatImage heights;
        const std::string recipe = word("--relief", "");
        if (recipe.empty()) {
            HeightReadOptions reading;
            reading.range = parseHeightRange(word("--range", "auto"));
            heights = readHeight(word("--height", ""), reading, work).heights;
        } else {
            const std::size_t x = recipe.find('x', recipe.find(':'));
            const std::size_t colon = recipe.rfind(':');
            heights = makeRelief(recipe.substr(0, recipe.find(':')),
                                 std::stoi(recipe.substr(recipe.find(':') + 1, x - recipe.find(':') - 1)),
                                 std::stoi(recipe.substr(x + 1, colon - x - 1)), std::stoull(recipe.substr(colon + 1)));
        }
        const HeightField field(std::make_shared<FloatImage>(std::move(heights)),
                                parseSurface(word("--surface", "bilinear")), parseAddress(word("--address", "repeat")));
        MapCache maps;
        RayBlock rays;
        rays.push(parseRayText(word("--ray", ""), "--ray"));
        HitBlock hits;
        NullSink null;
        makeTracer({"exact", {}}, field, maps, work)->trace(rays, hits, null, work);
        return hits.lambda[0];
    }

    relief::testing::TemporaryFolder folder_;
};

TEST_F(StressTest, ListedTracersKeepTheirPromises) {
    const StressReport report = run({});
    EXPECT_EQ(report.violationCount, 0U) << stressText(report, 7);
    EXPECT_GE(report.cases, kStressCasesAtLeast);
    for (const MeasuredMethod& method : defaultMethods()) {
        ASSERT_EQ(report.methods.count(method.choice.name), 1U);
        const auto& rays = report.methods.at(method.choice.name).rays;
        std::vector<std::string> missing;
        for (const StressRayFamily& family : stressRayFamilies()) {
            if (!rays.contains(std::string(family.name))) missing.emplace_back(family.name);
        }
        // A method of one surface takes part in half of the few cases.
        EXPECT_LE(missing.size(), method.surfaces.size() < 2 ? 1U : 0U)
            << method.choice.name << ": " << commaList(missing);
        EXPECT_GT(report.methods.at(method.choice.name).logs, 0U);
        EXPECT_LE(report.methods.at(method.choice.name).worstBound, 1.0);
    }
}

// Rays with more steps than the stated bound, or that gave up because of it: thin maps whose seams cut all levels, rays
// beyond the domain.
TEST_F(StressTest, StepBoundsHoldOnThinMapsAndBeyondTheDomain) {
    struct Found {
        const char* recipe;
        int width, height;
        std::uint64_t seed;
        Surface surface;
        ViewRay ray;
    };
    const std::vector<Found> all{
        {"bricks", 5, 3, 931411, Surface::Columns, {2.055919, 1.792920881, 75208032.0864554, 196034780.3595006}},
        {"spikes", 16384, 3, 92947, Surface::Bilinear, {10570.749, 0.37296873, -1e+200, 9.315718026946779e+199}},
        {"spikes", 16384, 3, 92947, Surface::Bilinear, {13118.025225611165, 1.3913564, -65.5928651, -1057.4889}},
        {"checker", 3, 16384, 1, Surface::Bilinear, {2.3759816, 8894.6315, 0, 4.470321658288422e+299}},
        {"pits", 1, 1000, 1, Surface::Bilinear, {0.3768749, 995.814957, 12.2685, 0}},
        {"spikes", 33, 2, 764250, Surface::Bilinear, {2.0428060188460733, 1.1852827161587962, -1e-9, -1282.2770637}},
    };
    Work work(1);
    for (const Found& found : all) {
        const HeightField field(
            std::make_shared<FloatImage>(makeRelief(found.recipe, found.width, found.height, found.seed)),
            found.surface);
        MapCache maps;
        RayBlock rays(1);
        rays.set(0, found.ray);
        HitBlock truth;
        NullSink null;
        makeTracer({"exact", {}}, field, maps, work)->trace(rays, truth, null, work);
        for (const MeasuredMethod& method : methodVariants()) {
            if (method.buildsMaps && field.heights().size() > kStressBuildTexels) continue;
            if (!method.supports(field.surface(), field.address())) continue;
            const auto tracer = method.make(field, maps, work);
            HitBlock hits;
            BlockCounts counts;
            tracer->trace(rays, hits, counts, work);
            const auto fault = answerFault(*tracer, found.ray, {hits[0], hits.steps[0], hits.reads[0]}, truth[0]);
            EXPECT_FALSE(fault) << methodText(method.choice) << " over " << found.recipe << ": " << fault->check << ", "
                                << fault->detail;
        }
    }
}

TEST_F(StressTest, CasesDependOnTheSeedAlone) {
    const StressReport one = run({}, 1);
    const StressReport two = run({}, 2);
    ASSERT_EQ(one.cases, two.cases);
    EXPECT_EQ(one.maps, two.maps);
    EXPECT_EQ(one.sizes, two.sizes);
    for (const auto& [name, coverage] : one.methods) {
        EXPECT_EQ(coverage.rays, two.methods.at(name).rays) << name;
        EXPECT_EQ(coverage.forms, two.methods.at(name).forms) << name;
        EXPECT_EQ(coverage.worstBound, two.methods.at(name).worstBound) << name;
    }
}

// A fault that one ray in ten thousand shows is found among the further rays, which are traced as blocks.
TEST_F(StressTest, MoreRaysFindRareFaults) {
    const auto rarely = [](const ViewRay& ray, Hit& hit, std::uint32_t&, Overload) {
        const std::uint64_t mixed = std::bit_cast<std::uint64_t>(ray.s0) ^
                                    std::rotl(std::bit_cast<std::uint64_t>(ray.t0), 17) ^
                                    std::rotl(std::bit_cast<std::uint64_t>(ray.a), 31);
        if ((mixed * 0x9E3779B97F4A7C15U >> 40U) % 10'000 == 1) hit = Hit::none(Outcome::Limit);
    };
    const MeasuredMethod method = altered({"max-pyramid", {}}, rarely);
    const StressReport few = run({method}), many = run({method}, 2, 40);
    EXPECT_EQ(few.violationCount, 0U);
    EXPECT_NE(find(many, "limit"), nullptr);
    const auto rays = [](const StressReport& report) { return report.methods.at("max-pyramid").rays.at("ordinary"); };
    EXPECT_EQ(rays(many), 41 * rays(few));
}

TEST_F(StressTest, AHitThatIsTooLateIsShownWithItsCommand) {
    const auto later = [](const ViewRay& ray, Hit& hit, std::uint32_t&, Overload) {
        if (hit.outcome == Outcome::Hit && hit.lambda > 0.25 && hit.lambda < 1) {
            hit = Hit::at(ray, std::nextafter(hit.lambda, 2));
        }
    };
    const StressReport exact = run({altered({"max-pyramid", {}}, later)});
    const StressViolation* bits = find(exact, "bits");
    ASSERT_NE(bits, nullptr);
    EXPECT_EQ(bits->command.substr(0, 13), "relief trace ");
    EXPECT_NE(bits->command.find("--tracer max-pyramid"), std::string::npos) << bits->command;
    EXPECT_NE(bits->command.find("--ray "), std::string::npos) << bits->command;
    EXPECT_NE(stressText(exact, 7).find(bits->command + "\n"), std::string::npos);

    EXPECT_NE(bits->fault.detail.find("exact: lambda " + numberText(exactLambda(bits->command))), std::string::npos)
        << bits->fault.detail << ": " << bits->command;

    // Of conservative methods by more than rounding.
    const auto muchLater = [](const ViewRay& ray, Hit& hit, std::uint32_t&, Overload) {
        if (hit.outcome == Outcome::Hit && hit.lambda > 0.25 && hit.lambda < 1) hit = Hit::at(ray, hit.lambda + 1e-11);
    };
    const StressReport late = run({altered({"max-pyramid", {}}, muchLater, Guarantee::Conservative)});
    EXPECT_NE(find(late, "overshoot"), nullptr);
    const StressReport vague = run({altered({"max-pyramid", {}}, later, Guarantee::Approximate)});
    EXPECT_EQ(vague.violationCount, 0U) << "approximate methods have no such guarantee";
}

TEST_F(StressTest, EarlierIsConservative) {
    const auto earlier = [](const ViewRay& ray, Hit& hit, std::uint32_t&, Overload) {
        if (hit.outcome == Outcome::Hit) hit = Hit::at(ray, hit.lambda * 0.5);
    };
    EXPECT_EQ(run({altered({"exact", {}}, earlier, Guarantee::Conservative)}).violationCount, 0U);
}

TEST_F(StressTest, EveryKindOfFaultIsFound) {
    const auto check = [&](const std::string& name, const AlteredTracer::Alter& alter) {
        const StressReport report = run({altered({"exact", {}}, alter)});
        EXPECT_NE(find(report, name), nullptr) << name << "\n" << stressText(report, 7);
    };
    check("not-finite", [](const ViewRay&, Hit& hit, std::uint32_t&, Overload) { hit.s = std::nan(""); });
    check("not-finite", [](const ViewRay& ray, Hit& hit, std::uint32_t&, Overload) { hit = Hit::at(ray, 1.5); });
    check("inconsistent", [](const ViewRay&, Hit& hit, std::uint32_t&, Overload) { hit.t += 1; });
    check("miss", [](const ViewRay&, Hit& hit, std::uint32_t&, Overload) { hit = Hit::none(Outcome::Miss); });
    check("limit", [](const ViewRay&, Hit& hit, std::uint32_t&, Overload) { hit = Hit::none(Outcome::Limit); });
    check("steps", [](const ViewRay&, Hit&, std::uint32_t& steps, Overload) { steps = 1U << 31U; });
    check("sinks", [](const ViewRay& ray, Hit& hit, std::uint32_t&, Overload overload) {
        if (overload == Overload::Plain && hit.outcome == Outcome::Hit) hit = Hit::at(ray, hit.lambda / 2);
    });
    check("sinks", [](const ViewRay& ray, Hit& hit, std::uint32_t&, Overload overload) {
        if (overload == Overload::Logging && hit.outcome == Outcome::Hit) hit = Hit::at(ray, hit.lambda / 2);
    });
    check("sinks", [](const ViewRay&, Hit&, std::uint32_t& steps, Overload overload) {
        if (overload == Overload::Counting && steps > 0) --steps;
    });
}

TEST_F(StressTest, LogsMustEndWithTheirOutcome) {
    CountedHit counted{Hit::at({1, 2, 3, 4}, 0.5), 2, 7};
    StepLog log;
    log.steps.resize(2);
    log.reads = {7};
    log.steps[1].decision = Decision::Hit;
    EXPECT_FALSE(logFault(counted, counted.hit, log));
    log.steps[1].decision = Decision::Test;
    ASSERT_TRUE(logFault(counted, counted.hit, log));
    EXPECT_EQ(logFault(counted, counted.hit, log)->check, "log");
    log.steps[1].decision = Decision::Hit;
    log.steps[0].lambdaOut = std::nan("");
    EXPECT_EQ(logFault(counted, counted.hit, log)->check, "log");
    log.steps[0].lambdaOut = 0;
    counted.reads = 8;
    EXPECT_EQ(logFault(counted, counted.hit, log)->check, "sinks");
}

// A tracer in an endless loop cannot be stopped, but its ray must be reported.
TEST_F(StressTest, ARayThatHangsIsReported) {
    std::atomic<bool> named = false;
    std::atomic<int> left = 1;
    // The tracer continues once its ray has been reported, so the test does not depend on a time.
    const auto hang = [&](const ViewRay&, Hit&, std::uint32_t&, Overload) {
        if (left.fetch_sub(1) != 1) return;
        while (!named) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    StressOptions options;
    options.seconds = 0;
    options.parts = {StressPart::Tracers};
    options.folder = folder_ / ".";
    options.methods = {altered({"exact", {}}, hang)};
    options.hangSeconds = 0.05;
    std::string command;
    options.onHang = [&](const StressViolation& violation) {
        command = violation.command;
        named = true;
    };
    Work work(2);
    stress(options, work);
    EXPECT_NE(command.find("--ray "), std::string::npos) << command;
}

TEST_F(StressTest, MapsSurviveTheirFiles) {
    Random random(3);
    Work work(1);
    for (const StressMapFamily& family : stressMapFamilies()) {
        const StressMap map = family.make(13, 9, random);
        for (const float h : map.heights->pixels()) ASSERT_TRUE(h >= 0 && h <= 1) << family.name;
        const std::string path = folder_ / "map.exr";
        writeHeight(path, *map.heights, true);
        HeightReadOptions reading;
        reading.range.kind = HeightRange::Kind::Full;
        EXPECT_EQ(readHeight(path, reading, work).heights, *map.heights) << family.name;
    }
}

// Whether the ray passes the middle of a texel at that texel's height.
bool meetsANode(const HeightField& field, const ViewRay& ray) {
    for (int j = 0; j < field.height(); ++j) {
        for (int i = 0; i < field.width(); ++i) {
            const double lambda = 1 - static_cast<double>(field.texel(i, j));
            const double s = ray.s0 + lambda * ray.a - i - 0.5, t = ray.t0 + lambda * ray.b - j - 0.5;
            if (std::hypot(s, t) <= 1e-9 * (1 + std::hypot(ray.a, ray.b))) return true;
        }
    }
    return false;
}

TEST_F(StressTest, RaysAreWhatTheirFamilySays) {
    Random random(5);
    const HeightField uneven(std::make_shared<FloatImage>(makeRelief("fractal", 9, 6, 1)));
    const HeightField field(stressMapFamilies().front().make(31, 17, random).heights);
    const CellGrid grid(field);
    for (const StressRayFamily& family : stressRayFamilies()) {
        int inDomain = 0;
        constexpr int kRays = 200;
        for (int r = 0; r < kRays; ++r) {
            const ViewRay ray = family.make(field, random);
            ASSERT_TRUE(ray.finite()) << family.name;
            inDomain += GridRay(grid, ray).inDomain() ? 1 : 0;
            if (family.name == "vertical") {
                ASSERT_TRUE(ray.a == 0 && ray.b == 0);
            }
            if (family.name == "far-start") {
                ASSERT_GE(std::abs(ray.s0), 1e6 - 32);
            }
            if (family.name == "through-nodes") {
                ASSERT_TRUE(meetsANode(uneven, family.make(uneven, random)));
            }
        }
        if (family.name == "beyond" || family.name == "huge") {
            EXPECT_EQ(inDomain, 0) << family.name;
        } else if (family.name == "at-limit") {
            EXPECT_TRUE(inDomain > 0 && inDomain < kRays) << inDomain << ": both sides of the limit";
        } else {
            EXPECT_EQ(inDomain, kRays) << family.name;
        }
    }
}

}  // namespace
}  // namespace relief::test
