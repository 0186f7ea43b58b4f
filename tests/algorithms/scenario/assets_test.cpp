#include "scenario/scenario.h"

#include <gtest/gtest.h>

#include "relief/errors.h"
#include "relief/reliefs.h"

namespace relief::test {
namespace {

TEST(Assets, aProceduralReliefIsInvertedAsAPictureIs) {
    Pictures pictures;
    pictures.recipe = "bricks";
    pictures.recipeWidth = 20;
    pictures.recipeHeight = 12;
    AssetStore store;
    Work work(1);
    const Assets plain = store.load(pictures, work);
    pictures.reading.invert = true;
    const Assets inverted = store.load(pictures, work);
    ASSERT_EQ(plain.heights->size(), 240U);
    for (std::size_t i = 0; i < plain.heights->size(); ++i) {
        EXPECT_EQ(inverted.heights->pixels()[i], 1 - plain.heights->pixels()[i]);
    }
}

TEST(Assets, withoutHeightsThereIsNothing) {
    Pictures pictures;
    pictures.recipe.clear();
    AssetStore store;
    Work work(1);
    EXPECT_THROW(store.load(pictures, work), InputError);
}

}  // namespace
}  // namespace relief::test
