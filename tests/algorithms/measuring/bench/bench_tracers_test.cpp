// relief bench tracers: columns, files, and errors that can be verified by hand.
#include "measuring/bench/bench_tracers.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "algorithms/measuring/altered_tracer.h"
#include "measuring/bench/bench_columns.h"
#include "measuring/bench/pareto.h"
#include "relief/reliefs.h"

namespace relief::test {
namespace {

constexpr const char* kHeader =
    "height,size,surface,address,relief_depth,method,form,options,elevation,seed,threads,rate,spread,error_mean,error_"
    "p95,"
    "error_p9999,error_max,wrong_outcome,overshoots,steps_mean,steps_p95,steps_max,reads_mean,memory_bytes,"
    "build_seconds,compiler,cpu,commit\n";

std::shared_ptr<const FloatImage> relief(const char* name, int width, int height) {
    return std::make_shared<FloatImage>(makeRelief(name, width, height, 1));
}

BenchOptions small(std::vector<MeasuredMethod> methods) {
    BenchOptions options;
    options.maps = {{"bricks", relief("bricks", 64, 48)}};
    options.methods = std::move(methods);
    options.elevations = {25.0, std::nullopt};
    options.rays = 2000;
    options.rounds = 3;
    return options;
}

HitBlock hitsOf(const std::vector<Outcome>& outcomes, const std::vector<double>& lambdas) {
    HitBlock hits(outcomes.size());
    hits.outcome = outcomes;
    hits.lambda = lambdas;
    return hits;
}

TEST(BenchTracers, ColumnsAreThoseThatScriptsRelyOn) {
    EXPECT_EQ(benchCsvHeader(), kHeader);
}

// Every method in its reference implementation gives the same hits and counts, with the same maps.
TEST(BenchTracers, FormsDifferInRateOnly) {
    BenchOptions options = small({});
    options.elevations = {25.0};
    options.rays = 500;
    options.rounds = 1;
    for (const char* name : {"exact", "max-pyramid", "max-pyramid-paper", "cone", "layers", "distance", "hybrid"}) {
        for (const Form form : {Form::Simd, Form::Scalar}) {
            options.methods.push_back(measuredMethod({name, {}}, form));
        }
    }
    Work work;
    const std::vector<BenchRow> rows = benchTracers(options, work);
    ASSERT_EQ(rows.size(), 14U);
    for (std::size_t r = 0; r < rows.size(); r += 2) {
        SCOPED_TRACE(rows[r].method.name);
        EXPECT_EQ(rows[r].form, methodForm(rows[r].method));
        EXPECT_EQ(rows[r + 1].form, Form::Scalar);
        EXPECT_EQ(rows[r].errors.max, rows[r + 1].errors.max);
        EXPECT_EQ(rows[r].stepsMean, rows[r + 1].stepsMean);
        EXPECT_EQ(rows[r].readsMean, rows[r + 1].readsMean);
        EXPECT_EQ(rows[r].memoryBytes, rows[r + 1].memoryBytes);
    }
    EXPECT_EQ(rows[6].form, Form::Simd);
    EXPECT_EQ(methodForm({"cone", {{"sectors", "4"}}}), Form::Simd);
    EXPECT_EQ(methodForm({"max-pyramid", {{"base", "1"}}}), Form::Scalar);
    // Neither form dominates the other.
    const ParetoTable table = paretoTable(rows);
    EXPECT_TRUE(table.bothForms());
    EXPECT_EQ(table.points.size(), 12U) << "exact and the paper's recursion have one form";
    for (const Form form : {Form::Simd, Form::Scalar}) {
        const auto dominated = dominatedPoints(table.points, ErrorMeasure::Max);
        bool front = false;
        for (std::size_t p = 0; p < dominated.size(); ++p) {
            front = front || (table.points[p].form == form && !dominated[p]);
        }
        EXPECT_TRUE(front);
    }
    EXPECT_EQ(parseForm("lanes", "--form"), Form::Simd);
    EXPECT_THROW(parseForm("wide", "--form"), InputError);
}

TEST(BenchTracers, ErrorsByHand) {
    RayBlock rays;
    for (const double run : {0.0, 3.0, 30.0, 300.0, 0.5, 1.0, 1.0}) rays.push({0, 0, 0.6 * run, 0.8 * run});
    using enum Outcome;
    const std::vector<Outcome> true_{Hit, Hit, Hit, Hit, Hit, Miss, Miss};
    const HitBlock truth = hitsOf(true_, {0.5, 0.5, 0.5, 0.5, 0.5, NAN, NAN});
    const HitBlock hits = hitsOf({Hit, Hit, Hit, Miss, Limit, Hit, Miss}, {0.75, 0.25, 0.5, NAN, NAN, 0.5, NAN});
    const TracerErrors errors = tracerErrors(rays, truth, hits);
    EXPECT_EQ(errors.wrongOutcome, 3) << "a miss and a limit where exact hits, a hit where it misses";
    EXPECT_EQ(errors.overshoots, 2) << "one later, one missed";
    EXPECT_NEAR(errors.mean, (0.25 + 0.75 + 0) / 3, 1e-15);
    EXPECT_NEAR(errors.max, 0.75, 1e-15);
    EXPECT_NEAR(errors.p95, 0.75, 1e-15);
    const TracerErrors none =
        tracerErrors(rays, hitsOf(std::vector<Outcome>(7, Miss), std::vector<double>(7, NAN)), hits);
    EXPECT_TRUE(std::isnan(none.mean) && std::isnan(none.p95) && std::isnan(none.max));
}

TEST(BenchTracers, TracersAreMadeOnceAMap) {
    int made = 0;
    MeasuredMethod method = measuredMethod({"cone", {}});
    method.make = [&made, make = method.make](const HeightField& field, MapCache& maps, Work& work) {
        ++made;
        return make(field, maps, work);
    };
    BenchOptions options = small({method});
    Work work;
    const auto whole = benchTracers(options, work);
    ASSERT_EQ(whole.size(), 2U);
    EXPECT_EQ(made, 1);
    options.prepared = noPreparedTracers();
    made = 0;
    std::vector<BenchRow> parts;
    for (const Elevation& elevation : std::vector<Elevation>{25.0, std::nullopt}) {
        options.elevations = {elevation};
        for (BenchRow& row : benchTracers(options, work)) parts.push_back(std::move(row));
    }
    EXPECT_EQ(made, 1);
    ASSERT_EQ(parts.size(), whole.size());
    for (std::size_t r = 0; r < parts.size(); ++r) {
        EXPECT_EQ(parts[r].elevation, whole[r].elevation);
        EXPECT_EQ(parts[r].stepsMean, whole[r].stepsMean);
        EXPECT_EQ(parts[r].errors.max, whole[r].errors.max);
        EXPECT_EQ(parts[r].memoryBytes, whole[r].memoryBytes);
    }
    // A change of anything that maps depend on builds them again.
    options.reliefDepth = 0.2;
    benchTracers(options, work);
    EXPECT_EQ(made, 2);
    options.maps = {{"hills", relief("hills", 64, 48)}};
    benchTracers(options, work);
    EXPECT_EQ(made, 3);
    options.methods[0].choice.options["sectors"] = "4";
    benchTracers(options, work);
    EXPECT_EQ(made, 4);
    Work other(1);
    benchTracers(options, other);
    EXPECT_EQ(made, other.threads().size() == work.threads().size() ? 4 : 5);
}

TEST(BenchTracers, PercentilesAreNearestRanks) {
    constexpr std::size_t kRays = 10000;
    RayBlock rays(kRays);
    HitBlock truth(kRays);
    HitBlock hits(kRays);
    for (std::size_t i = 0; i < kRays; ++i) {
        rays.set(i, {0, 0, 1, 0});
        truth.set(i, Hit::at(rays[i], 0));
        hits.set(i, Hit::at(rays[i], static_cast<double>((i * 7919) % kRays + 1) / kRays));  // each lambda occurs once
    }
    const TracerErrors errors = tracerErrors(rays, truth, hits);
    EXPECT_EQ(errors.p95, 0.95);
    EXPECT_EQ(errors.p9999, 0.9999);
    EXPECT_EQ(errors.max, 1);
}

TEST(BenchTracers, ExactMethodsHaveNoErrorAndLayersHave) {
    Work work(2);
    std::vector<MeasuredMethod> methods = defaultMethods();
    methods.push_back(measuredMethod(parseMethodChoice("layers:layers=7", "--tracers")));
    const BenchOptions options = small(methods);
    const auto rows = benchTracers(options, work);
    ASSERT_EQ(rows.size(), 2 * methods.size());
    for (const BenchRow& row : rows) {
        EXPECT_GT(row.rate, 0);
        EXPECT_GE(row.spread, 0);
        EXPECT_GE(row.stepsMax, row.stepsP95);
        EXPECT_GE(static_cast<double>(row.stepsMax), row.stepsMean);
        const Guarantee guarantee = findTracer(row.method.name).guarantee;
        if (guarantee == Guarantee::Exact) {
            EXPECT_EQ(row.errors.max, 0) << row.method.name;
            EXPECT_EQ(row.errors.mean, 0);
            EXPECT_EQ(row.errors.wrongOutcome, 0);
        }
        if (guarantee != Guarantee::Approximate) {
            EXPECT_EQ(row.errors.overshoots, 0) << row.method.name;
        }
        if (row.method.name == "layers") {
            EXPECT_GT(row.errors.mean, 0);
            EXPECT_GT(row.errors.overshoots, 0);
            EXPECT_LE(row.errors.mean, row.errors.max);
        }
    }
    EXPECT_EQ(optionsText(rows[methods.size() - 1].method, true), "layers=7");
}

// With address border: a tracer that finds nothing in the left half has wrong outcomes exactly there.
TEST(BenchTracers, WrongOutcomesUnderBorder) {
    const auto blind = [](const ViewRay& ray, Hit& hit, std::uint32_t&, Overload) {
        if (ray.s0 < 2) hit = Hit::none(Outcome::Miss);
    };
    BenchOptions options = small({altered({"exact", {}}, blind)});
    options.maps = {{"step", std::make_shared<FloatImage>(4, 4, 0.5F)}};
    options.address = Address::Border;
    options.elevations = {90.0};
    options.rays = 100;
    Work work(1);
    const RayBlock rays =
        benchRays(HeightField(options.maps[0].heights, options.surface, options.address), 90.0, 100, options.seed);
    std::int64_t left = 0;
    for (const double s : rays.s0) left += s < 2 ? 1 : 0;
    ASSERT_TRUE(left > 0 && left < 100);
    const auto rows = benchTracers(options, work);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].errors.wrongOutcome, left);
    EXPECT_EQ(rows[0].errors.overshoots, left);
    EXPECT_EQ(rows[0].errors.max, 0) << "where both hit";
}

TEST(BenchTracers, CsvAndJsonHoldTheSameNumbers) {
    Work work(1);
    BenchOptions options = small({measuredMethod({"layers-bisection", {}}), measuredMethod({"exact", {}})});
    options.maps[0].name = "a \"quoted\", odd name.png";
    std::string csv = benchCsvHeader();
    options.onRow = [&](const BenchRow& row) { csv += benchCsvLine(row); };
    auto rows = benchTracers(options, work);
    rows[0].errors.mean = NAN;
    const auto json = nlohmann::json::parse(benchJson(rows));
    ASSERT_EQ(json.size(), rows.size());
    EXPECT_NE(csv.find("\"a \"\"quoted\"\", odd name.png\""), std::string::npos);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::string line = benchCsvLine(rows[r]);
        ASSERT_TRUE(line.ends_with('\n'));
        line.pop_back();
        const auto fields = csvFields(line);
        ASSERT_EQ(fields.size(), benchColumns().size());
        ASSERT_EQ(json[r].size(), benchColumns().size());
        for (std::size_t c = 0; c < fields.size(); ++c) {
            const auto& value = json[r].at(std::string(benchColumns()[c].name));
            if (value.is_null()) {
                EXPECT_EQ(fields[c].text, "");
            } else if (value.is_string()) {
                EXPECT_EQ(fields[c].text, value.get<std::string>());
            } else {
                EXPECT_EQ(std::stod(fields[c].text), value.get<double>()) << benchColumns()[c].name;
            }
        }
    }
    EXPECT_TRUE(json[0]["error_mean"].is_null());
    EXPECT_EQ(json[0]["options"], "bisections=8:layers=64");
    EXPECT_EQ(json[0]["elevation"], 25);
    EXPECT_EQ(json[2]["elevation"], "random");
}

TEST(BenchTracers, TheTableHasRateAndErrorOnOneLine) {
    Work work(1);
    const auto rows = benchTracers(small({measuredMethod({"layers", {{"layers", "5"}}})}), work);
    const std::string text = benchText(rows);
    const std::size_t line = text.find("  layers:layers=5");
    ASSERT_NE(line, std::string::npos) << text;
    const std::string words = text.substr(line, text.find('\n', line) - line);
    // Two tables of a title, a head and a row; between and after them blank lines; three lines that explain the
    // columns.
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2 * 3 + 1 + 1 + 3) << text;
    EXPECT_NE(text.find("Mrays/s"), std::string::npos);
    EXPECT_GT(words.size(), 60U) << words;
    EXPECT_EQ(benchText({}), "") << "no row has the facts of the last lines";
}

TEST(BenchTracers, RaysOfAViewComeFromItsElevation) {
    const HeightField field(relief("hills", 40, 30), Surface::Bilinear, Address::Repeat, 0.25);
    for (const double degrees : {80.0, 25.0, 2.0}) {
        const RayBlock rays = benchRays(field, degrees, 1000, 3);
        ASSERT_EQ(rays.size(), 1000U);
        int near = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const double run = std::hypot(rays.a[i], rays.b[i]);
            EXPECT_NEAR(std::atan2(field.slabTexels(), run) * 180 / std::numbers::pi, degrees, 1e-9);
            ASSERT_TRUE(rays.s0[i] >= 0 && rays.s0[i] < 40 && rays.t0[i] >= 0 && rays.t0[i] < 30);
            if (i > 0 && std::hypot(rays.s0[i] - rays.s0[i - 1], rays.t0[i] - rays.t0[i - 1]) < 40.0 / 36) ++near;
        }
        EXPECT_GT(near, 800) << "neighbours, but for the ends of rows and the picture's edges";
    }
    const RayBlock down = benchRays(field, 90.0, 10, 3);
    EXPECT_EQ(down.a, std::vector<double>(10, 0.0));
    const RayBlock random = benchRays(field, std::nullopt, 100, 3);
    // Rays drawn from a lowest elevation on: none is flatter.
    const double steepest = field.slabTexels() / std::tan(40 * std::numbers::pi / 180);
    const RayBlock steep = benchRays(field, std::nullopt, 100, 3, 40);
    std::size_t flatter = 0;
    for (std::size_t i = 0; i < steep.size(); ++i) {
        EXPECT_LE(std::hypot(steep.a[i], steep.b[i]), steepest * (1 + 1e-12));
        flatter += std::hypot(random.a[i], random.b[i]) > steepest ? 1U : 0U;
    }
    EXPECT_GT(flatter, 0U);
    EXPECT_EQ(std::set<double>(random.a.begin(), random.a.end()).size(), 100U);
}

TEST(BenchTracers, SlowReferencesGetFewerRaysWithANote) {
    BenchOptions options = small({measuredMethod({"offset", {}})});
    options.elevations = {2.0};
    options.referenceCells = 20000;
    std::vector<std::string> notes;
    options.onNote = [&](const Message& message) { notes.push_back(sentence(message)); };
    std::int64_t rays = 0;
    options.methods = {altered({"exact", {}}, [&](const ViewRay&, Hit&, std::uint32_t&, Overload overload) {
        if (overload == Overload::Counting) ++rays;
    })};
    Work work(1);
    benchTracers(options, work);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("instead of 2000"), std::string::npos) << notes[0];
    EXPECT_NE(notes[0].find(std::to_string(rays) + " rays"), std::string::npos) << notes[0];
    EXPECT_TRUE(rays >= 256 && rays < 2000) << rays;
}

TEST(BenchTracers, MethodsAndElevationsAreReadAsTheyAreWritten) {
    const MethodChoice choice = parseMethodChoice("layers-bisection:layers=128:bisections=4", "--tracers");
    EXPECT_EQ(choice, (MethodChoice{"layers-bisection", {{"layers", "128"}, {"bisections", "4"}}}));
    EXPECT_EQ(parseMethodChoice(methodText(choice), "--tracers"), choice);
    EXPECT_EQ(methodText({"exact", {}}), "exact");
    for (const char* wrong : {"", "nothing", "layers:", "layers:layers", "layers:=3", "layers:layers=0",
                              "layers:layers=x", "layers:colour=3", ":layers=3", "exact:layers=3"}) {
        EXPECT_THROW(parseMethodChoice(wrong, "--tracers"), InputError) << wrong;
    }
    EXPECT_EQ(parseElevation("2.5", "--elevations"), Elevation(2.5));
    EXPECT_EQ(parseElevation("random", "--elevations"), Elevation());
    for (const char* wrong : {"", "0", "-3", "90.5", "nan", "steep", "8 "}) {
        EXPECT_THROW(parseElevation(wrong, "--elevations"), InputError) << wrong;
    }
}

}  // namespace
}  // namespace relief::test
