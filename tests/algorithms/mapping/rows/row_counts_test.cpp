// Operation counts of the row variants, obtained by instantiating their code with a scalar type that counts.
#include <gtest/gtest.h>

#include "mapping/rows/counting_scalar.h"
#include "mapping/rows/row_kernels.h"
#include "row_cases.h"

namespace relief {
namespace {

// Evaluates a row of n pixels; returns the operations after the row's terms are computed, and checks the values.
OperationCounts countsOf(const RowOptions& options, std::int64_t n, std::int64_t anchor) {
    OperationCounts counts;
    const auto make = [&](double value) { return Counted(value, &counts); };
    const Homography map = test::rowOfRatio(1 << 20, 0.2, 4096, 100, 900, false);
    const auto row = rowTerms<Counted>(map, 0.5, 0, n, anchor, make, make);
    counts = {};
    std::vector<Counted> u(static_cast<std::size_t>(n)), v(u);
    switch (options.variant) {
        case RowVariant::Affine:
            affineRow(row, u.data(), v.data());
            break;
        case RowVariant::Direct:
            directRow(row, u.data(), v.data());
            break;
        case RowVariant::RowConstant:
            rowConstantRow(row, u.data(), v.data());
            break;
        case RowVariant::Incremental:
            incrementalRow(row, u.data(), v.data());
            break;
        case RowVariant::IncrementalShared:
            incrementalSharedRow(row, u.data(), v.data());
            break;
        case RowVariant::IncrementalReciprocal:
            incrementalReciprocalRow(row, u.data(), v.data());
            break;
        case RowVariant::Opposed:
            opposedRow(row, u.data(), v.data());
            break;
        case RowVariant::Subspan:
            subspanRow(row, options.span, u.data(), v.data());
            break;
        default:
            streamsRow(row, options.streams, u.data(), v.data());
    }
    for (std::int64_t i = 0; i < n; ++i) {
        const LongTexel truth = truthAt(map, 0.5, i);
        if (options.variant == RowVariant::Affine || options.variant == RowVariant::Subspan) continue;
        EXPECT_NEAR(u[static_cast<std::size_t>(i)].value(), static_cast<double>(truth.s), 1e-6);
        EXPECT_NEAR(v[static_cast<std::size_t>(i)].value(), static_cast<double>(truth.t), 1e-6);
    }
    return counts;
}

// A number of pixels that contains whole steps, spans and anchor intervals of every case below; the cost of so many
// additional pixels is measured.
constexpr std::int64_t kPeriod = 2 * 16 * 3 * 7 * 5;
OperationCounts perPeriod(const RowOptions& options, std::int64_t anchor = 0) {
    const OperationCounts more = countsOf(options, 2 * kPeriod + 1, anchor);
    const OperationCounts less = countsOf(options, kPeriod + 1, anchor);
    return {more.mul - less.mul, more.add - less.add, more.div - less.div};
}

TEST(RowCounts, AreThoseOfTheTable) {
    const auto times = [](std::int64_t mul, std::int64_t add, std::int64_t div) {
        return OperationCounts{mul * kPeriod, add * kPeriod, div * kPeriod};
    };
    EXPECT_EQ(perPeriod({RowVariant::Affine}), times(0, 2, 0));
    EXPECT_EQ(perPeriod({RowVariant::Direct}), times(8, 8, 2));
    EXPECT_EQ(perPeriod({RowVariant::RowConstant}), times(4, 4, 2));
    EXPECT_EQ(perPeriod({RowVariant::Incremental}), times(0, 4, 2));
    EXPECT_EQ(perPeriod({RowVariant::IncrementalShared}), times(0, 3, 2));
    EXPECT_EQ(perPeriod({RowVariant::IncrementalReciprocal}), times(2, 3, 1));
    EXPECT_EQ(perPeriod({RowVariant::Opposed}), times(0, 3, 2));
    for (const int k : {1, 2, 3, 7, 16}) {
        RowOptions options{RowVariant::Streams};
        options.streams = k;
        EXPECT_EQ(perPeriod(options), times(0, 3, 2)) << k;
    }
    for (const int m : {1, 2, 7, 16}) {
        RowOptions options{RowVariant::Subspan};
        options.span = m;
        EXPECT_EQ(perPeriod(options), (OperationCounts{4 * kPeriod / m, 2 * kPeriod + 3 * kPeriod / m, kPeriod / m}))
            << m;
    }
}

TEST(RowCounts, OfRestarts) {
    // Three multiplications and additions per restart (a denominator used for both u and v is computed once), and with
    // streams those of their offsets.
    const std::int64_t restarts = kPeriod / 48;
    const auto more = [](const OperationCounts& a, const OperationCounts& b) {
        return OperationCounts{a.mul - b.mul, a.add - b.add, a.div - b.div};
    };
    for (const RowVariant variant :
         {RowVariant::Incremental, RowVariant::IncrementalShared, RowVariant::IncrementalReciprocal}) {
        EXPECT_EQ(more(perPeriod({variant}, 48), perPeriod({variant})),
                  (OperationCounts{3 * restarts, 3 * restarts, 0}));
    }
    const RowOptions streams{RowVariant::Streams};
    EXPECT_EQ(more(perPeriod(streams, 48), perPeriod(streams)),
              (OperationCounts{3 * restarts, (3 + 3 * 16) * restarts, 0}));
    const RowOptions subspan{RowVariant::Subspan};
    EXPECT_EQ(more(perPeriod(subspan, 48), perPeriod(subspan)), (OperationCounts{3 * restarts, 3 * restarts, 0}));
}

TEST(RowCounts, OfARowsTerms) {
    OperationCounts counts;
    const auto make = [&](double value) { return Counted(value, &counts); };
    rowTerms<Counted>(test::rowOfRatio(100, 0.5, 64, 0, 1, false), 0.5, 3, 100, 0, make, make);
    EXPECT_EQ(counts, (OperationCounts{6, 6, 0}));
}

}  // namespace
}  // namespace relief
