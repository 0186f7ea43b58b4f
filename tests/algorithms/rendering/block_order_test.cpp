// The order of pixels within tiles: each pixel occurs once, and neighbours are close in the order.
#include "rendering/block_order.h"

#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace relief {
namespace {

std::vector<std::pair<int, int>> ordered(const PixelArea& tile) {
    std::vector<std::pair<int, int>> pixels;
    inBlockOrder(tile, [&](int x, int y) { pixels.emplace_back(x, y); });
    return pixels;
}

TEST(BlockOrder, EveryPixelOnce) {
    for (const PixelArea& tile :
         {PixelArea{0, 0, 64, 16}, PixelArea{128, 32, 131, 33}, PixelArea{64, 16, 97, 29}, PixelArea{7, 5, 8, 6}}) {
        const auto pixels = ordered(tile);
        const std::set<std::pair<int, int>> once(pixels.begin(), pixels.end());
        EXPECT_EQ(pixels.size(), static_cast<std::size_t>((tile.x1 - tile.x0) * (tile.y1 - tile.y0)));
        EXPECT_EQ(once.size(), pixels.size());
        for (const auto& [x, y] : pixels) {
            EXPECT_TRUE(x >= tile.x0 && x < tile.x1 && y >= tile.y0 && y < tile.y1) << x << ", " << y;
        }
    }
}

TEST(BlockOrder, SixteenPixelsAreOneBlockOfWholeTiles) {
    const auto pixels = ordered({64, 32, 128, 48});
    for (std::size_t first = 0; first < pixels.size(); first += 16) {
        const auto [left, top] = pixels[first];
        EXPECT_EQ(left % kBlockSide, 0);
        EXPECT_EQ(top % kBlockSide, 0);
        for (std::size_t i = 0; i < 16; ++i) {
            EXPECT_EQ(pixels[first + i].first, left + static_cast<int>(i % 4));
            EXPECT_EQ(pixels[first + i].second, top + static_cast<int>(i / 4));
        }
    }
    // Each 256 pixels fill a square before the next one begins.
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        EXPECT_EQ((pixels[i].first - 64) / kSquareSide, static_cast<int>(i / 256)) << i;
    }
}

}  // namespace
}  // namespace relief
