#include "mapping/rows/rows.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "algorithms/every_target.h"
#include "mapping/rows/row_kernels.h"
#include "mapping/rows/row_planner.h"
#include "row_cases.h"

namespace relief {
namespace {

using test::evaluated;
using test::EvaluatedRow;
using test::exactVariants;
using test::ForcedTarget;
using test::nameOf;
using test::Random;
using test::rowOfRatio;

constexpr std::uint64_t kSeed = 20182;
constexpr double kFloatRoundoff = 0x1p-24;

TEST(Rows, NamesAreUniqueAndRead) {
    for (int i = 0; i < kRowVariants; ++i) {
        const auto variant = static_cast<RowVariant>(i);
        EXPECT_EQ(rowVariant(rowVariantName(variant)), variant);
    }
    EXPECT_EQ(rowVariant("none"), std::nullopt);
}

// The bounds stated in rows.h; kSlack covers terms of second order in the roundoff.
constexpr double kSlack = 1.001;
template <typename T>
double statedBound(const Homography& map, const RowOptions& options, const EvaluatedRow& row, std::int64_t anchor) {
    const double roundoff = 0.5 * static_cast<double>(std::numeric_limits<T>::epsilon());
    const double count = static_cast<double>(row.valid.size());
    const double smallest = std::min(map.denominator(0.5, 0.5), map.denominator(count - 0.5, 0.5));
    const double terms = std::abs(map.qx) * count + std::abs(map.qy) + std::abs(map.q1);
    if (!drifts(options.variant)) return kSlack * 8 * roundoff * row.largest * terms / smallest;
    const double stretch = anchor > 0 ? std::min(static_cast<double>(anchor), count) : count;
    const double ratio = (smallest + std::abs(map.qx) * stretch) / smallest;
    const double steps = std::ceil(stretch / pixelsPerStep(options));
    return kSlack * row.largest * ((2 * steps + 3) * roundoff * ratio + 8 * 0x1p-53 * terms / smallest);
}

template <typename T>
void expectStatedBounds() {
    Random random(kSeed);
    for (int n = 0; n < 60; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed) + ", case " + std::to_string(n));
        const int width = random.whole(2000, 6000);
        const Homography map = rowOfRatio(width, std::exp2(random.real(-4.3, 4.3)), random.real(10.0, 5000.0),
                                          random.real(0.0, 4000.0), random.real(0.0, 4000.0), n % 2 == 0);
        for (RowOptions options : exactVariants()) {
            for (const int anchor : {kRecommended, kNever, 16, 50}) {
                options.anchor = anchor;
                SCOPED_TRACE(nameOf(options));
                const PixelSpan span{0, width};
                const EvaluatedRow row = evaluated<T>(map, 0.5, span, options);
                ASSERT_EQ(row.valid, span);
                ASSERT_TRUE(row.finite);
                const std::int64_t resolved = planRow<T>(map, 0.5, span, options).anchor;
                EXPECT_LE(row.worst, statedBound<T>(map, options, row, resolved));
                if (!drifts(options.variant)) break;
            }
        }
    }
}

TEST(Rows, EveryVariantIsTheMapWithinItsBoundInFloat) {
    expectStatedBounds<float>();
}
TEST(Rows, EveryVariantIsTheMapWithinItsBoundInDouble) {
    expectStatedBounds<double>();
}

// 16,384 pixels of a 4,096 texture.
constexpr int kLong = 16384;
constexpr double kTexture = 4096;

double worstDrift(const RowOptions& options, double lastQ) {
    double worst = 0;
    for (int n = 0; n < 8; ++n) {
        const Homography map = rowOfRatio(kLong, lastQ, kTexture, 37.0 + 500 * n, 4000.0 - 311 * n, n % 2 != 0);
        const EvaluatedRow row = evaluated<float>(map, 0.5, {0, kLong}, options);
        EXPECT_TRUE(row.finite && row.valid.size() == kLong);
        worst = std::max(worst, row.worst);
    }
    return worst;
}

TEST(Rows, AnchoredDriftStaysBelowABilinearWeight) {
    for (const RowVariant variant : {RowVariant::Incremental, RowVariant::IncrementalShared,
                                     RowVariant::IncrementalReciprocal, RowVariant::Opposed, RowVariant::Streams}) {
        for (const double lastQ : {0.8, 0.3, 0.05}) {
            RowOptions options{variant};
            SCOPED_TRACE(nameOf(options) + ", q falls to " + std::to_string(lastQ));
            const double recommended = worstDrift(options, lastQ);
            EXPECT_LT(recommended, kAnchorError);
            options.anchor = kNever;
            const double never = worstDrift(options, lastQ);
            // 16 SIMD streams drift a sixteenth as much, which is still more than the bound of the anchored form.
            EXPECT_GT(never, 4 * kAnchorError);
            RecordProperty(std::string(rowVariantName(variant)) + " " + std::to_string(lastQ),
                           std::to_string(recommended) + " against " + std::to_string(never));
        }
    }
    EXPECT_EQ(recommendedAnchor<float>(kTexture, 0, {RowVariant::Incremental}), 6);
    EXPECT_EQ(recommendedAnchor<float>(kTexture, 0, {RowVariant::Streams}), 96);
    EXPECT_EQ(recommendedAnchor<float>(kTexture, 0.001, {RowVariant::Streams}), 80) << "q changes by 8% in 80 pixels";
    EXPECT_GT(recommendedAnchor<double>(kTexture, 0, {RowVariant::Incremental}), 10000);
    EXPECT_EQ(recommendedAnchor<float>(1e9, 0, {RowVariant::Incremental}), 1) << "never less than a step";
    EXPECT_LT((2 * 6 + 3) * kFloatRoundoff * kTexture, kAnchorError);
}

TEST(Rows, RecommendedAnchorsAreTheLongestThatTheBoundAllows) {
    Random random(kSeed + 3);
    for (int n = 0; n < 2000; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed + 3) + ", case " + std::to_string(n));
        const double texels = std::exp2(random.real(0.0, 20.0)), error = std::exp2(random.real(-12.0, 0.0));
        const double change = n % 5 == 0 ? 0 : std::exp2(random.real(-30.0, -4.0));
        RowOptions options{RowVariant::Streams};
        options.streams = random.whole(1, 40);
        const std::int64_t anchor = recommendedAnchor<float>(texels, change, options, error);
        ASSERT_EQ(anchor % options.streams, 0);
        const auto bound = [&](std::int64_t pixels) {
            const double steps = static_cast<double>(pixels) / options.streams;
            return (2 * steps + 3) * kFloatRoundoff * texels * (1 + static_cast<double>(pixels) * change);
        };
        ASSERT_GE(anchor, options.streams);
        if (anchor > options.streams) {
            EXPECT_LE(bound(anchor), error * (1 + 1e-12));
        }
        if (anchor < 64 * options.streams) {
            EXPECT_GT(bound(anchor + options.streams), error * (1 - 1e-12));
        }
    }
}

TEST(Rows, AffineIsWrongByTheClosedForm) {
    for (const double ratio : {1.0, 1.5, 4.0, 9.0, 20.0}) {
        for (const bool mirrored : {false, true}) {
            // The closed form applies between the centres of the first and last pixel, half a pixel inside the ends.
            const int width = 4001;
            const Homography map = rowOfRatio(width, 1 / ratio, 1000, 70, 900, mirrored);
            const double first = map.denominator(0.5, 0.5), last = map.denominator(width - 0.5, 0.5);
            const AffineError closed = affineError(std::max(first, last) / std::min(first, last));
            const double change =
                static_cast<double>(std::abs(truthAt(map, 0.5, width - 1).s - truthAt(map, 0.5, 0).s));
            std::vector<double> u(width), v(width);
            evaluateRow(map, 0.5, {0, width}, {RowVariant::Affine}, u.data(), v.data());
            // The other coordinate is also right at the ends, and halfway in the middle.
            const auto firstV = static_cast<double>(truthAt(map, 0.5, 0).t);
            const auto lastV = static_cast<double>(truthAt(map, 0.5, width - 1).t);
            EXPECT_NEAR(v.front(), firstV, 1e-6) << ratio;
            EXPECT_NEAR(v[width / 2], (firstV + lastV) / 2, 1e-6) << ratio;
            EXPECT_NEAR(v.back(), lastV, 1e-6) << ratio;
            double worst = 0, place = 0;
            for (int n = 0; n < width; ++n) {
                const double error =
                    std::abs(u[static_cast<std::size_t>(n)] - static_cast<double>(truthAt(map, 0.5, n).s));
                if (error > worst) worst = error, place = n;
            }
            // The largest error is found within a pixel of its true position, where the curve is flat to second order.
            EXPECT_NEAR(worst / change, closed.share, 1e-6) << ratio;
            if (ratio == 1) continue;
            const double fraction = place / (width - 1);
            EXPECT_NEAR(mirrored ? 1 - fraction : fraction, closed.fraction, 1.0 / width) << ratio;
        }
    }
    EXPECT_NEAR(affineError(4).share, 1.0 / 3, 1e-15);
    EXPECT_NEAR(affineError(4).fraction, 2.0 / 3, 1e-15);
}

TEST(Rows, RowsThatReachTheHorizonAreCut) {
    Random random(kSeed + 1);
    int cut = 0;
    for (int n = 0; n < 400; ++n) {
        SCOPED_TRACE("seed " + std::to_string(kSeed + 1) + ", case " + std::to_string(n));
        Homography map;
        map.sx = random.real(-2.0, 2.0), map.sy = random.real(-2.0, 2.0), map.s1 = random.real(-2000.0, 2000.0);
        map.tx = random.real(-2.0, 2.0), map.ty = random.real(-2.0, 2.0), map.t1 = random.real(-2000.0, 2000.0);
        map.qx = random.real(-2e-3, 2e-3), map.qy = random.real(-2e-3, 2e-3), map.q1 = random.real(-1.0, 1.0);
        map = map.normalised();
        // Also rows with q = 0 at a pixel's centre up to rounding, or slightly beside it.
        const auto exactQ = [&](double x) {
            return static_cast<long double>(map.qx) * x + static_cast<long double>(map.qy) * 7.5L + map.q1;
        };
        if (n % 4 < 2) {
            map.q1 = 0;
            map.q1 = -static_cast<double>(exactQ(n % 4 == 0 ? 100.5 : 100.5001));
        }
        const PixelSpan span{0, random.whole(1, 3000)};
        std::vector<RowOptions> all = exactVariants();
        all.push_back({RowVariant::Affine});
        all.push_back({RowVariant::Subspan});
        all.push_back({RowVariant::RowsParallel});
        for (RowOptions options : all) {
            options.anchor = n % 3 == 0 ? kNever : kRecommended;
            SCOPED_TRACE(nameOf(options));
            for (const EvaluatedRow& row :
                 {evaluated<float>(map, 7.5, span, options), evaluated<double>(map, 7.5, span, options)}) {
                EXPECT_TRUE(row.finite);
                // The evaluated q is at least half of the true one.
                if (options.variant != RowVariant::Affine && options.variant != RowVariant::Subspan) {
                    EXPECT_LE(row.wildest, 1.01);
                }
                for (std::int64_t i = row.valid.begin; i < row.valid.end; ++i) {
                    ASSERT_GT(exactQ(static_cast<double>(i) + 0.5), 0);
                }
                if (row.valid.size() != span.size()) ++cut;
            }
            // Only pixels with q below the stated bound were cut off.
            const RowPlan plan = planRow<float>(map, 7.5, span, options);
            const double minQ = smallestRowQ<float>(map, 7.5, span, options, kNever);
            for (std::int64_t i = span.begin; i < span.end; ++i) {
                if (map.denominator(static_cast<double>(i) + 0.5, 7.5) <= minQ) continue;
                ASSERT_TRUE(i >= plan.valid.begin && i < plan.valid.end) << i;
            }
        }
    }
    EXPECT_GT(cut, 1000);
}

TEST(Rows, PixelsThatAreCutOffAreNotTouched) {
    Homography map;
    map.qx = -0.01, map.q1 = 1;  // the horizon is at x = 100
    std::vector<float> u(300, -7.0F), v(300, -7.0F);
    const PixelSpan valid = evaluateRow(map, 0.5, {20, 320}, {RowVariant::Opposed}, u.data(), v.data());
    EXPECT_EQ(valid, (PixelSpan{20, 100}));
    for (std::size_t n = 80; n < 300; ++n) EXPECT_EQ(u[n], -7.0F);
    EXPECT_NE(u[79], -7.0F);
    map = {1, 0, 0, 0, 1, 0, 0, 0, -1};  // wholly behind the eye
    EXPECT_TRUE(evaluateRow(map, 0.5, {0, 300}, {RowVariant::Streams}, u.data(), v.data()).empty());
    EXPECT_TRUE(evaluateRow(map, 0.5, {5, 5}, {RowVariant::Streams}, u.data(), v.data()).empty());
}

TEST(Rows, ThreadsDoNotChangeABit) {
    const Homography map = rowOfRatio(1000, 0.1, 4096, 3, 700, false);
    for (const RowBlock& block : {RowBlock{1000, 37, 0.5, 1}, RowBlock{1, 3, 0.5, 1}, RowBlock{70001, 5, 0.1, 0.01},
                                  RowBlock{640, 1, 0.5, 1}, RowBlock{300000, 3, 0.5, 1}}) {
        for (const int anchor : {kNever, kRecommended}) {
            RowOptions serial{RowVariant::Streams};
            serial.anchor = anchor;
            RowOptions parallel = serial;
            parallel.variant = RowVariant::RowsParallel;
            TexelRows<float> a(block.width, block.rows), b(block.width, block.rows);
            Work one(1), all;
            evaluateRows(map, block, serial, a, one);
            evaluateRows(map, block, parallel, b, all);
            for (std::int64_t r = 0; r < block.rows; ++r) {
                ASSERT_EQ(a.valid(r), b.valid(r));
                ASSERT_FALSE(a.valid(r).empty());
                for (std::int64_t i = a.valid(r).begin; i < a.valid(r).end; ++i) {
                    ASSERT_EQ(a.u(r)[i], b.u(r)[i]);
                    ASSERT_EQ(a.v(r)[i], b.v(r)[i]);
                }
            }
        }
    }
}

TEST(Rows, LongWorkCanBeStopped) {
    std::stop_source stop;
    stop.request_stop();
    Work work(0, stop.get_token());
    TexelRows<float> rows(100, 100);
    EXPECT_THROW(evaluateRows(Homography{}, {100, 100}, {RowVariant::Direct}, rows, work), Cancelled);
    EXPECT_THROW(evaluateRows(Homography{}, {100, 100}, {RowVariant::RowsParallel}, rows, work), Cancelled);
}

template <typename T>
void expectLanesLikeScalars() {
    const auto targets = laneTargets();
    ASSERT_GE(targets.size(), 1U);
    Random random(kSeed + 2);
    for (const int k : {2, 4, 8, 16, 32}) {
        ASSERT_TRUE(hasStreamLanes(k));
        for (const std::int64_t count : {1, 2, 3, 15, 16, 17, 31, 33, 63, 64, 65, 1000, 4097}) {
            const Homography map =
                rowOfRatio(4100, std::exp2(random.real(-4.0, 4.0)), 4096, random.real(0.0, 4096.0), 99, k == 8);
            for (const int steps : {0, 1, 5}) {
                const auto row = rowTerms<T>(map, 0.5, 0, count, steps * k);
                const auto size = static_cast<std::size_t>(count);
                std::vector<T> u(size), v(size);
                streamsRow(row, k, u.data(), v.data());
                TexelRows<T> room(count + 1, 1);
                for (const std::int64_t target : targets) {
                    const ForcedTarget forced(target);
                    for (const int shift : {0, 1}) {
                        for (const bool pastCache : {false, true}) {
                            T* lu = room.u(0) + shift;
                            T* lv = room.v(0) + shift;
                            std::fill_n(lu, count, T(-1));
                            std::fill_n(lv, count, T(-1));
                            streamsRowLanes(row, k, pastCache, lu, lv);
                            finishStores();
                            ASSERT_TRUE(std::equal(u.begin(), u.end(), lu) && std::equal(v.begin(), v.end(), lv))
                                << laneTargetName(target) << ", k = " << k << ", " << count << " pixels, " << steps
                                << " steps, shift " << shift << (pastCache ? ", past the cache" : "");
                        }
                    }
                }
            }
        }
    }
}

TEST(RowLanes, GiveTheScalarTextsBitsOnEveryInstructionSetInFloat) {
    expectLanesLikeScalars<float>();
    std::string names;
    for (const std::int64_t target : laneTargets()) names += std::string(laneTargetName(target)) + " ";
    RecordProperty("targets", names);
}
TEST(RowLanes, GiveTheScalarTextsBitsOnEveryInstructionSetInDouble) {
    expectLanesLikeScalars<double>();
}

}  // namespace
}  // namespace relief
