#include "measuring/bench/bench_rows.h"

#include <cmath>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mapping/rows/derivatives.h"

namespace relief {
namespace {

// Small enough for a test; each block has both full SIMD vectors and a remainder.
RowBenchOptions smallOptions() {
    RowBenchOptions options;
    options.widths = {640, 1001};
    options.elevations = {60, 8};
    options.pixels = 4000;
    options.rounds = 2;
    return options;
}

TEST(BenchRows, TheWallFillsTheRowAndFadesAsStated) {
    for (const double elevation : {60.0, 25.0, 8.0, 90.0, 0.1}) {
        for (const std::int64_t width : {640, 65536}) {
            const Homography map = obliqueWall(4096, width, elevation);
            const RowBlock block = wallRows(width, 7, elevation);
            const double last = static_cast<double>(width);
            // Texels; the map itself is rounded at the edges of a wall seen almost edge-on.
            EXPECT_NEAR(map.at(0, 0).s, 0, 1e-6);
            EXPECT_NEAR(map.at(last, 0).s, 4096, 1e-6);
            EXPECT_NEAR(map.at(last, block.firstY - 0.5 * block.stepY).t, 0, 1e-6);
            EXPECT_NEAR(map.at(last, block.firstY + 6.5 * block.stepY).t, 4096, 1e-6);
            const double near = kWallDistance - 0.5 * std::cos(elevation * 3.14159265358979 / 180);
            const double far = kWallDistance + 0.5 * std::cos(elevation * 3.14159265358979 / 180);
            EXPECT_NEAR(map.denominator(last, 0) / map.denominator(0, 0), near / far, 1e-9);
        }
    }
}

TEST(BenchRows, MeasuresEveryVariantWithItsCountsAndError) {
    const RowBenchOptions options = smallOptions();
    Work work;
    std::size_t reported = 0;
    RowBenchOptions reporting = options;
    reporting.onRow = [&](const RowBenchRow&) { ++reported; };
    const auto rows = benchRows(reporting, work);
    ASSERT_EQ(rows.size(), 2 * 2 * 2 * options.methods.size());
    EXPECT_EQ(reported, rows.size());
    for (const RowBenchRow& row : rows) {
        SCOPED_TRACE(rowBenchCsvLine(row));
        EXPECT_GT(row.rate, 0);
        EXPECT_TRUE(row.spread >= 0);
        const bool isFloat = row.precision == RowPrecision::Float;
        if (row.variant == "fill") {
            EXPECT_TRUE(std::isnan(row.errorMax));
        } else if (row.variant == "affine") {
            EXPECT_GT(row.errorMax, 100);
        } else if (row.variant == "subspan") {
            EXPECT_GT(row.errorMax, row.span > 1 ? 1e-3 : 0);
        } else if (row.variant.starts_with("derivatives")) {
            EXPECT_LT(row.errorMax, isFloat ? 1e-2 : 1e-9);
        } else if (isFloat && row.anchor > 0) {
            EXPECT_LT(row.errorMax, kAnchorError);
        } else if (!isFloat) {
            EXPECT_LT(row.errorMax, 1e-7);
        }
        if (row.variant == "direct") {
            EXPECT_TRUE(row.counts.mul == 8 && row.counts.add == 8 && row.counts.div == 2);
        }
        if (row.variant == "incremental") {
            const double restarts = row.anchor > 0 ? 3.0 / static_cast<double>(row.anchor) : 0;
            EXPECT_NEAR(row.counts.mul, restarts, 1e-12);
            EXPECT_NEAR(row.counts.add, 4 + restarts, 1e-12);
        }
        if (row.variant == "subspan" && row.anchor == 0) {
            EXPECT_NEAR(row.counts.div, 1.0 / static_cast<double>(row.span), 1e-12);
            EXPECT_NEAR(row.counts.mul, 4.0 / static_cast<double>(row.span), 1e-12);
            EXPECT_NEAR(row.counts.add, 2 + 3.0 / static_cast<double>(row.span), 1e-12);
        }
        if (row.variant == "derivatives-cached") {
            EXPECT_TRUE(row.counts.mul == 1 && row.counts.add == 4 && row.counts.div == 1);
        }
    }
}

TEST(BenchRows, ListsCountsAreThoseThatAreCounted) {
    for (const RowMethodDescription& description : rowMethodList()) {
        RowMethod method = parseRowMethod(description.name, "");
        if (description.name == "subspan") continue;  // told with m
        const PixelCounts counts = pixelCounts(method, 1, 0);
        std::istringstream text(description.counts);
        double mul = -1, add = -1, div = -1;
        char slash = 0;
        text >> mul >> slash >> add >> slash >> div;
        EXPECT_TRUE(counts.mul == mul && counts.add == add && counts.div == div) << description.name;
        EXPECT_FALSE(description.help.empty());
    }
}

TEST(BenchRows, PlannedSpansKeepTheirError) {
    RowBenchOptions options = smallOptions();
    options.methods = {parseRowMethod("subspan:error=0.25", ""), parseRowMethod("subspan:error=2:anchor=0", "")};
    options.precisions = {RowPrecision::Double};
    Work work;
    options.widths = {20000};  // wide enough for long planned spans
    const auto rows = benchRows(options, work);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double error = i % 2 == 0 ? 0.25 : 2;
        EXPECT_LE(rows[i].errorMax, error * (1 + 1e-9));
        EXPECT_GT(rows[i].errorMax, 0.8 * error) << "not far below: " << rows[i].span;
        EXPECT_GT(rows[i].span, 8);
    }
}

TEST(BenchRows, SpellingsAreChecked) {
    EXPECT_EQ(parseRowMethod("streams:streams=4:anchor=0", "").settings.streams, 4);
    for (const char* wrong :
         {"", "none", "direct:streams=2", "streams:streams=0", "streams:streams=5000", "streams:x=1", "subspan:span",
          "subspan:span=0", "incremental:anchor=-2", "subspan:error=x"}) {
        EXPECT_THROW(parseRowMethod(wrong, "--variants"), InputError) << wrong;
    }
}

TEST(BenchRows, TablesHaveTheirColumns) {
    RowBenchOptions options = smallOptions();
    options.widths = {64};
    options.methods = {parseRowMethod("streams", ""), parseRowMethod("fill", "")};
    Work work;
    const auto rows = benchRows(options, work);
    EXPECT_EQ(rowBenchCsvHeader(),
              "variant,width,elevation,precision,streams,span,anchor,threads,mul,add,div,rate,spread,error_max,rows\n");
    const auto json = nlohmann::json::parse(rowBenchJson(rows));
    ASSERT_EQ(json.size(), rows.size());
    EXPECT_EQ(json[0]["variant"], "streams");
    EXPECT_EQ(json[0]["streams"], 16);
    EXPECT_TRUE(json[1]["error_max"].is_null());
    EXPECT_EQ(rowBenchCsvLine(rows[1]).back(), '\n');
    EXPECT_NE(rowBenchText(rows).find("64 pixels per row, elevation 8 degrees, double"), std::string::npos);
}

TEST(BenchRows, TextHasABlockForEachWidthElevationPrecisionAndNumberOfRows) {
    std::vector<RowBenchRow> rows(5);
    rows[1].width = rows[2].width = rows[3].width = rows[4].width = 64;
    rows[2].elevation = rows[3].elevation = rows[4].elevation = 8;
    rows[3].precision = rows[4].precision = RowPrecision::Double;
    rows[4].rows = 2;
    for (std::size_t n = 1; n < rows.size(); ++n) {
        const std::string text = rowBenchText(std::span(rows).subspan(n - 1, 2));
        EXPECT_NE(text.find("pixels per row"), text.rfind("pixels per row")) << text;
    }
}

TEST(BenchRows, CanBeStopped) {
    std::stop_source stop;
    stop.request_stop();
    Work work(0, stop.get_token());
    EXPECT_THROW(benchRows(smallOptions(), work), Cancelled);
}

}  // namespace
}  // namespace relief
