#include "mapping/rows/row_errors.h"

#include <gtest/gtest.h>

#include "row_cases.h"

namespace relief {
namespace {

std::vector<RowOptions> allVariants() {
    std::vector<RowOptions> all;
    for (int i = 0; i < kRowVariants; ++i) {
        RowOptions options{static_cast<RowVariant>(i)};
        options.streams = 5;
        options.span = 7;
        all.push_back(options);
        options.anchor = kNever;
        all.push_back(options);
    }
    return all;
}

TEST(RowErrors, CurvesAreTheVariantsThemselves) {
    const Homography map = test::rowOfRatio(500, 0.1, 4096, 10, 900, false);
    for (const PixelSpan span : {PixelSpan{0, 500}, PixelSpan{33, 34}, PixelSpan{3, 402}, PixelSpan{0, 560}}) {
        const RowErrors row = rowErrors<float>(map, 0.5, span, allVariants());
        const auto size = static_cast<std::size_t>(span.size());
        ASSERT_EQ(row.x.size(), size);
        ASSERT_EQ(row.curves.size(), allVariants().size());
        for (const RowCurve& curve : row.curves) {
            SCOPED_TRACE(test::nameOf(curve.options));
            const auto found = test::evaluated<float>(map, 0.5, span, curve.options);
            EXPECT_EQ(curve.valid, found.valid);
            EXPECT_NEAR(curve.worst, found.worst, 1e-8 + 1e-9 * found.largest) << "double beside the horizon";
            ASSERT_TRUE(curve.u.size() == size && curve.v.size() == size && curve.error.size() == size &&
                        curve.stream.size() == size);
            for (std::size_t i = 0; i < size; ++i) {
                const std::int64_t pixel = span.begin + static_cast<std::int64_t>(i);
                const bool in = pixel >= curve.valid.begin && pixel < curve.valid.end;
                ASSERT_EQ(std::isnan(curve.u[i]), !in);
                ASSERT_EQ(std::isnan(curve.error[i]), !in);
            }
            if (!curve.valid.empty()) {
                EXPECT_EQ(curve.error[static_cast<std::size_t>(curve.worstPixel - span.begin)], curve.worst);
            }
        }
    }
    EXPECT_TRUE(rowErrors<double>(map, 0.5, {4, 4}, allVariants()).curves.empty());
}

// At the pixels listed as exact the error is only the rounding of w, q and the quotient; between them it is larger.
TEST(RowErrors, ExactPixelsAreExact) {
    const Homography map = test::rowOfRatio(3000, 0.1, 4096, 10, 900, false);
    const double rounding = 3.01 * 0x1p-24 * 4096;
    for (const RowOptions& options : allVariants()) {
        SCOPED_TRACE(test::nameOf(options));
        const RowErrors row = rowErrors<float>(map, 0.5, {0, 3000}, {options});
        const RowCurve& curve = row.curves.front();
        if (!drifts(options.variant)) {
            EXPECT_TRUE(curve.exact.empty());
            continue;
        }
        ASSERT_FALSE(curve.exact.empty());
        EXPECT_TRUE(std::is_sorted(curve.exact.begin(), curve.exact.end()));
        // Without anchors, spans drift from one division to the next.
        if (options.variant == RowVariant::Subspan && curve.anchor == 0) continue;
        const double allowed = options.variant == RowVariant::Subspan ? kAnchorError : rounding;
        for (const std::int64_t pixel : curve.exact) {
            EXPECT_LE(curve.error[static_cast<std::size_t>(pixel)], allowed) << pixel;
        }
    }
}

TEST(RowErrors, StreamsAreReported) {
    const Homography map = test::rowOfRatio(100, 0.5, 64, 0, 1, false);
    RowOptions streams{RowVariant::Streams};
    streams.streams = 3;
    streams.anchor = 6;
    const RowErrors row = rowErrors<double>(map, 0.5, {0, 9}, {streams, {RowVariant::Opposed}});
    EXPECT_EQ(row.curves[0].stream, (std::vector<std::int32_t>{0, 1, 2, 0, 1, 2, 0, 1, 2}));
    EXPECT_EQ(row.curves[0].exact, (std::vector<std::int64_t>{0, 6}));
    EXPECT_EQ(row.curves[1].stream, (std::vector<std::int32_t>{0, 0, 0, 0, 0, 1, 1, 1, 1}));
    EXPECT_EQ(row.curves[1].exact, (std::vector<std::int64_t>{0, 4, 8}));
}

}  // namespace
}  // namespace relief
