// Where slabs stand: within the view, none over another or its title, and as large as the room allows.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "panes/pyramid/slab_piles.h"
#include "panes/turntable.h"

namespace reliefui {
namespace {

struct Seen {
    double x0, x1, y0, y1;  // pixels, y upwards; the slab from its front edge to its back
    double titleX1, titleY0;
};

std::vector<Seen> seenOf(const std::vector<std::vector<SlabSize>>& pyramids, const SlabPiles& piles) {
    std::vector<Seen> all;
    for (std::size_t n = 0; n < pyramids.size(); ++n) {
        for (std::size_t k = 0; k < pyramids[n].size(); ++k) {
            const SlabSize& size = pyramids[n][k];
            const SlabPlace& place = piles.places[n][k];
            const double up = place.z * std::cos(Turntable::kElevation) * piles.scale;
            const double deep = size.depth * std::sin(Turntable::kElevation) * piles.scale;
            const double x = place.x * piles.scale;
            all.push_back({x, x + size.width * piles.scale, up, up + deep, x + size.titleWidth, up - size.titleHeight});
        }
    }
    return all;
}

std::vector<std::vector<SlabSize>> pyramidsOf(int count, int levels, double depth, double title) {
    std::vector<SlabSize> slabs;
    for (int k = 0; k < levels; ++k) slabs.push_back({1, depth, (k == 0 ? 14 : 7) * title, 1.4 * title});
    return std::vector<std::vector<SlabSize>>(static_cast<std::size_t>(count), slabs);
}

TEST(SlabPiles, noneHidesAnotherAndAllAreWithinTheView) {
    for (const int count : {1, 3}) {
        for (const int levels : {1, 4, 9, 11, 14}) {
            for (const double depth : {0.2, 0.5, 1.0}) {
                for (const auto& [width, height] : {std::pair(1900.0, 850.0), {700.0, 900.0}, {400.0, 260.0}}) {
                    const auto pyramids = pyramidsOf(count, levels, depth, 14);
                    const SlabPiles piles = slabPiles(pyramids, width, height);
                    const std::string what = std::to_string(count) + " x " + std::to_string(levels) + " levels, " +
                                             std::to_string(depth) + " deep, on " + std::to_string(width);
                    const std::vector<Seen> seen = seenOf(pyramids, piles);
                    EXPECT_TRUE(piles.titled || count > 1 || width < 700) << what;
                    for (const Seen& a : seen) {
                        EXPECT_LE(a.x1, width) << what;
                        EXPECT_LE(a.y1, height) << what;
                        for (const Seen& b : seen) {
                            if (&a == &b) continue;
                            const double right = piles.titled ? std::max(a.x1, a.titleX1) : a.x1;
                            const double low = piles.titled ? a.titleY0 : a.y0;
                            EXPECT_TRUE(b.x0 >= right - 1e-6 || b.x1 <= a.x0 + 1e-6 || b.y0 >= a.y1 - 1e-6 ||
                                        b.y1 <= low + 1e-6)
                                << what;
                        }
                    }
                }
            }
        }
    }
}

// The finest undermost in each pile, each pile to the right of the one before.
TEST(SlabPiles, levelsGoUpwardsAndToTheRight) {
    const auto pyramids = pyramidsOf(3, 11, 0.5, 14);
    const SlabPiles piles = slabPiles(pyramids, 1900, 850);
    SlabPlace last{-1, -1, 0};
    for (const std::vector<SlabPlace>& places : piles.places) {
        EXPECT_EQ(places.size(), 11U);
        EXPECT_GT(places.front().pile, last.pile);
        for (const SlabPlace& place : places) {
            if (place.pile == last.pile) {
                EXPECT_GT(place.z, last.z);
                EXPECT_EQ(place.x, last.x);
            } else {
                EXPECT_EQ(place.z, 0);
                EXPECT_GT(place.x, last.x);
            }
            last = place;
        }
    }
}

// Whatever the shape of the page, the slabs take a good part of it.
TEST(SlabPiles, thePageIsFilled) {
    for (const int levels : {4, 7, 9, 11, 13}) {
        for (const double depth : {0.5, 1.0}) {
            for (const double aspect : {0.45, 0.7, 1.0, 1.6}) {
                const double width = 1900, height = aspect * width;
                const auto pyramids = pyramidsOf(1, levels, depth, 26);
                const SlabPiles piles = slabPiles(pyramids, width, height);
                double wide = 0, high = 0, area = 0;
                for (const Seen& seen : seenOf(pyramids, piles)) {
                    wide = std::max({wide, seen.x1, seen.titleX1});
                    high = std::max(high, seen.y1 + 1.4 * 26);
                    area += (seen.x1 - seen.x0) * (seen.y1 - seen.titleY0);
                }
                const std::string what = std::to_string(levels) + " levels, " + std::to_string(depth) + " deep, page " +
                                         std::to_string(aspect);
                EXPECT_GT(std::max(wide / width, high / height), 0.85) << what;
                EXPECT_GT(std::min(wide / width, high / height), 0.5) << what;
                EXPECT_GT(area / (width * height), 0.4) << what;
            }
        }
    }
}

}  // namespace
}  // namespace reliefui
