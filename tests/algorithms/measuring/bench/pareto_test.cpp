// The points and the front that the Pareto chart shows, for hand-made tables.
#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "measuring/bench/pareto.h"

namespace relief::test {
namespace {

BenchRow row(const std::string& method, double nanoseconds, double mean, double most, const std::string& map = "bricks",
             Form form = Form::Scalar) {
    BenchRow one;
    one.height = map + ":8x8:1";
    one.width = one.heightTexels = 8;
    one.method.name = method;
    one.form = form;
    one.elevation = 60.0;
    one.rate = 1e9 / nanoseconds;
    one.errors.mean = one.errors.p95 = one.errors.p9999 = mean;
    one.errors.max = most;
    return one;
}

TEST(Pareto, TimesAreMeantGeometricallyErrorsPlainly) {
    std::vector<BenchRow> rows{row("exact", 100, 0, 0), row("layers", 10, 0.5, 3), row("layers", 40, 1.5, 2, "hills"),
                               row("exact", 400, 0, 0, "hills"), row("offset", 5, 9, 9)};
    rows[1].errors.wrongOutcome = 2;
    rows[2].errors.wrongOutcome = 3;
    rows[1].stepsMean = 4;
    rows[2].stepsMean = 8;
    rows[1].spread = 0.2;
    rows[2].spread = 0.1;
    const ParetoTable table = paretoTable(rows);
    EXPECT_EQ(table.cells, 2U);
    EXPECT_EQ(table.leftOut, std::vector<std::string>{"offset"}) << "measured in one cell only";
    ASSERT_EQ(table.points.size(), 2U);
    const ParetoPoint& layers = table.points[1];
    EXPECT_EQ(layers.name, "layers");
    EXPECT_NEAR(layers.nanoseconds, std::sqrt(10.0 * 40.0), 1e-9);
    EXPECT_NEAR(table.points[0].nanoseconds, 200, 1e-9);
    EXPECT_DOUBLE_EQ(layers.errorOf(ErrorMeasure::Mean), 1);
    EXPECT_DOUBLE_EQ(layers.errorOf(ErrorMeasure::Max), 3);
    EXPECT_EQ(layers.wrongOutcome, 5);
    EXPECT_DOUBLE_EQ(layers.steps, 6);
    EXPECT_DOUBLE_EQ(layers.spread, 0.2);
    EXPECT_FALSE(table.bothForms());
    // If no ray has the right outcome, the mean error is undefined.
    rows[2].errors.mean = rows[2].errors.max = std::nan("");
    const ParetoPoint some = paretoTable(rows).points[1];
    EXPECT_DOUBLE_EQ(some.errorOf(ErrorMeasure::Mean), 0.5);
    EXPECT_DOUBLE_EQ(some.errorOf(ErrorMeasure::Max), 3);
}

TEST(Pareto, DominatedIsWhatAnotherOfItsFormBeats) {
    Random random(8);
    int dominatedOnes = 0, others = 0;
    for (int table = 0; table < 300; ++table) {
        std::vector<ParetoPoint> points(static_cast<std::size_t>(1 + random.below(7)));
        for (ParetoPoint& point : points) {
            point.nanoseconds = 1 + random.below(4);
            point.error.fill(random.below(5) == 0 ? std::nan("") : 0.5 * random.below(3));
            point.wrongOutcome = random.below(2);
            point.form = random.below(4) == 0 ? Form::Simd : Form::Scalar;
        }
        const std::vector<bool> found = dominatedPoints(points, ErrorMeasure::P95);
        for (std::size_t b = 0; b < points.size(); ++b) {
            bool beaten = false;
            for (const ParetoPoint& a : points) {
                if (a.form != points[b].form) continue;
                const auto worse = [](double x, double y) { return std::isnan(x) ? !std::isnan(y) : x > y; };
                const bool slower = worse(points[b].nanoseconds, a.nanoseconds);
                const bool lessExact = worse(points[b].error[1], a.error[1]);
                const bool wronger = points[b].wrongOutcome > a.wrongOutcome;
                const bool ever = worse(a.nanoseconds, points[b].nanoseconds) ||
                                  worse(a.error[1], points[b].error[1]) || a.wrongOutcome > points[b].wrongOutcome;
                beaten = beaten || (!ever && (slower || lessExact || wronger));
            }
            EXPECT_EQ(found[b], beaten) << table << " " << b;
            ++(beaten ? dominatedOnes : others);
        }
    }
    EXPECT_GT(dominatedOnes, 100);
    EXPECT_GT(others, 100);
}

TEST(Pareto, ATableIsReadBack) {
    std::vector<BenchRow> rows{row("exact", 100, 0, 0), row("layers", 20, 0.5, 3), row("offset", 5, 9, 9),
                               row("cone", 50, 0, 0)};
    rows[1].method.options["layers"] = "128";
    rows[2].elevation.reset();
    rows[3].errors.mean = std::nan("");
    rows[0].height = "a \"b\",\nc.png";
    rows[0].commit = "1234567";  // a text, whatever its letters
    std::string csv = benchCsvHeader();
    for (const BenchRow& one : rows) csv += benchCsvLine(one);
    for (const std::vector<BenchRow>& back : {parseBenchJson(benchJson(rows), "x.json"), parseBenchCsv(csv, "x.csv")}) {
        ASSERT_EQ(back.size(), rows.size());
        for (std::size_t r = 0; r < rows.size(); ++r) {
            EXPECT_EQ(benchCsvLine(back[r]), benchCsvLine(rows[r]));
            EXPECT_EQ(shortMethodName(back[r].method), shortMethodName(rows[r].method));
        }
        EXPECT_EQ(shortMethodName(back[1].method), "layers:layers=128");
    }
}

TEST(Pareto, BrokenTablesAreRefused) {
    const std::vector<BenchRow> table{row("exact", 20, 0, 0), row("layers", 20, 0.5, 3)};
    const std::string good = benchJson(table);
    const auto broken = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    const std::vector<std::string> texts{"",
                                         "{",
                                         "[]",
                                         "{}",
                                         "[1]",
                                         "[{\"variant\": \"direct\"}]",
                                         good.substr(0, good.size() / 2),
                                         broken("\"rate\": 50000000.0", "\"rate\": 0"),
                                         broken("\"rate\": 50000000.0", "\"rate\": \"fast\""),
                                         broken("\"rate\": 50000000.0", "\"rate\": 1e999"),
                                         broken("\"8x8\"", "\"8\""),
                                         broken("\"8x8\"", "\"1e300x2\""),
                                         broken("bilinear", "smooth"),
                                         broken("\"relief_depth\": ", "\"relief_depth\": null, \"was\": "),
                                         broken("\"spread\": ", "\"spread\": null, \"was\": "),
                                         broken("\"elevation\": ", "\"elevation\": null, \"was\": "),
                                         broken("\"cpu\"", "\"CPU\"")};
    const auto expectRefused = [](const std::string& text, const auto& parse) {
        try {
            parse(text, "x.y");
            ADD_FAILURE() << text.substr(0, 60);
        } catch (const InputError& error) {
            const std::string line = error.text(Language::English);
            EXPECT_EQ(line.rfind("x.y: ", 0), 0u) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        }
    };
    for (const std::string& text : texts) expectRefused(text, parseBenchJson);
    const std::string header = benchCsvHeader();
    const std::string line = benchCsvLine(table[0]);
    std::string notANumber = line;
    const std::string rate = "," + benchField(table[0].rate) + ",";
    notANumber.replace(notANumber.find(rate), rate.size(), ",fast,");
    for (const std::string& text : {std::string(), header, std::string("variant,width\ndirect,100\n"), header + "a,b\n",
                                    header + line.substr(0, line.size() / 2),
                                    header + line + line.substr(0, line.size() - 1), header + notANumber, good}) {
        expectRefused(text, parseBenchCsv);
    }
}

}  // namespace
}  // namespace relief::test
