// Distance transforms of sampled functions, against all pairs of points.
#include "relief/maps/lower_envelope.h"

#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/every_target.h"
#include "algorithms/relief/fields.h"

namespace relief::test {
namespace {

// The intersections of parabolas are rounded to float; a value taken beyond one has an error of that size.
constexpr double kFloatRounding = 2e-6;

struct Case {
    int width;
    int height;
    bool wraps;
    bool gaps;
};

class Envelope : public testing::TestWithParam<Case> {};

double away(int a, int b, int size, bool wraps, bool gaps) {
    int d = std::abs(a - b);
    if (wraps) d = std::min(d, size - d);
    return gaps ? std::max(d - 1, 0) : d;
}

TEST_P(Envelope, IsTheLeastOverAllPlaces) {
    const Case c = GetParam();
    const double dx = c.gaps ? 1 : 0.75;
    const double dy = c.gaps ? 1 : 1.5;
    for (const float largest : {2.0F, 60.0F, 900.0F, 1000.0F, 4e6F}) {
        FloatImage f(c.width, c.height);
        Random random(static_cast<std::uint64_t>(c.width * 100 + c.height));
        // Many values are equal or zero.
        for (float& v : f.pixels()) v = random.below(3) == 0 ? 0.0F : largest * static_cast<float>(random.unit());
        if (largest > 100) {
            for (float& v : f.pixels()) v = largest;
            const bool atCorner = largest == 1000.0F;  // as far away as a place can be
            f(atCorner ? c.width - 1 : c.width / 2, atCorner ? c.height - 1 : c.height / 3) = 0;
        }
        const FloatImage given = f;
        EnvelopeScratch scratch;
        const auto transform = [&](FloatImage& image) {
            if (c.gaps) {
                gapEnvelope2D(image, c.wraps, scratch);
            } else {
                envelope2D(image, dx, dy, c.wraps, scratch);
            }
        };
        transform(f);
        onEveryTarget([&] {
            FloatImage again = given;
            transform(again);
            ASSERT_EQ(again, f);
        });
        for (int y = 0; y < c.height; ++y) {
            for (int x = 0; x < c.width; ++x) {
                double least = 1e30;
                for (int j = 0; j < c.height; ++j) {
                    for (int i = 0; i < c.width; ++i) {
                        const double wayX = away(x, i, c.width, c.wraps, c.gaps) * dx;
                        const double wayY = away(y, j, c.height, c.wraps, c.gaps) * dy;
                        least = std::min(least, wayX * wayX + wayY * wayY + static_cast<double>(given(i, j)));
                    }
                }
                ASSERT_NEAR(f(x, y), least, kFloatRounding * (1 + least)) << x << ", " << y << " of " << largest;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Envelope,
                         testing::Values(Case{17, 13, false, false}, Case{17, 13, true, false},
                                         Case{16, 8, true, false}, Case{1, 9, true, false}, Case{2, 3, true, false},
                                         Case{17, 13, false, true}, Case{17, 13, true, true}, Case{16, 8, true, true},
                                         Case{1, 1, true, true}, Case{2, 5, true, true}, Case{1, 7, false, true},
                                         // Wider than the transform's window.
                                         Case{1200, 2, false, false}, Case{1, 2100, true, true},
                                         Case{2, 1300, false, true}, Case{2100, 1, true, false}));

}  // namespace
}  // namespace relief::test
