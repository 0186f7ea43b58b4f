// The cache keeps its content within its budget: maps, and the heights that they belong to.
#include <gtest/gtest.h>

#include "relief/map_cache.h"

namespace relief::test {

namespace {

struct Small {
    std::size_t bytes() const { return 100; }
};

TEST(MapCache, HeightsThatItKeepsAliveCountOnce) {
    auto heights = std::make_shared<const FloatImage>(50, 50);
    const std::size_t picture = heights->bytes();
    MapCache cache(2 * picture);
    cache.put({"a", heights}, std::make_shared<const Small>());
    EXPECT_EQ(cache.bytes(), picture + 100);
    cache.put({"b", heights}, std::make_shared<const Small>());
    EXPECT_EQ(cache.bytes(), picture + 200);
    // Maps of a second picture: there is no room for both, so the first picture is dropped with everything that belongs
    // to it.
    const std::weak_ptr<const FloatImage> first = heights;
    heights.reset();
    EXPECT_FALSE(first.expired());
    cache.put({"a", std::make_shared<const FloatImage>(50, 50)}, std::make_shared<const Small>());
    EXPECT_TRUE(first.expired());
    EXPECT_EQ(cache.bytes(), picture + 100);
}

}  // namespace

}  // namespace relief::test
