// Stored values of maps: rounded to the safe side, with marks kept distinguishable.
#include "relief/maps/stored_values.h"

#include <gtest/gtest.h>

#include "measuring/random_rays.h"

namespace relief::test {
namespace {

constexpr int kWidth = 37;
constexpr int kHeight = 29;
constexpr int kLayers = 5;

UnfilledVector<float> mixedValues(float largest) {
    Random random(3);
    UnfilledVector<float> values(static_cast<std::size_t>(kWidth * kHeight * kLayers));
    for (float& value : values) {
        const int kind = random.below(10);
        if (kind == 0) {
            value = StoredValues::kSurface;
        } else if (kind == 1) {
            value = StoredValues::kBuried;
        } else {
            value = kind == 2 ? 0 : static_cast<float>(random.unit()) * largest;
        }
    }
    values.front() = largest;
    return values;
}

class RoundedValues : public testing::TestWithParam<std::tuple<Precision, Rounding, float>> {};

TEST_P(RoundedValues, LieOnTheSafeSideWithinOneUnit) {
    const auto [precision, rounding, largest] = GetParam();
    const UnfilledVector<float> values = mixedValues(largest);
    const StoredValues stored(kWidth, kHeight, kLayers, values, precision, rounding);
    EXPECT_EQ(stored.bytes(), values.size() * (precision == Precision::U8 ? 1 : 2));
    std::size_t i = 0;
    for (int k = 0; k < kLayers; ++k) {
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x, ++i) {
                const float got = stored(x, y, k);
                if (values[i] < 0) {
                    ASSERT_EQ(got, values[i]);
                    continue;
                }
                const float late = rounding == Rounding::Down ? values[i] - got : got - values[i];
                ASSERT_GE(late, 0) << values[i] << " is stored as " << got;
                // One unit, and the rounding of a float product.
                ASSERT_LE(late, stored.unit() * 1.001F) << values[i] << " is stored as " << got;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, RoundedValues,
                         testing::Combine(testing::Values(Precision::U8, Precision::U16),
                                          testing::Values(Rounding::Down, Rounding::Up),
                                          testing::Values(1e-6F, 0.37F, 1.0F, 51.3F, 12345.678F)));

TEST(StoredValues, FloatsStayAsTheyAre) {
    const UnfilledVector<float> values = mixedValues(51.3F);
    const StoredValues stored(kWidth, kHeight, kLayers, values, Precision::Float, Rounding::Down);
    EXPECT_EQ(std::get<0>(stored.codes()), values);
    EXPECT_EQ(stored(5, 7, 3), values[static_cast<std::size_t>((3 * kHeight + 7) * kWidth + 5)]);
}

TEST(StoredValues, OfZerosAndMarksOnly) {
    const StoredValues stored(3, 1, 1, {0, StoredValues::kSurface, StoredValues::kBuried}, Precision::U8,
                              Rounding::Down);
    EXPECT_EQ(stored(0, 0, 0), 0);
    EXPECT_EQ(stored(1, 0, 0), StoredValues::kSurface);
    EXPECT_EQ(stored(2, 0, 0), StoredValues::kBuried);
}

}  // namespace
}  // namespace relief::test
