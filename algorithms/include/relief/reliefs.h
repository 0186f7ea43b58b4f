// Procedural reliefs: seeded, with the same bits on every machine. The recipes are in reliefs.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "relief/image.h"
#include "relief/work.h"

namespace relief {

struct ReliefRecipe {
    std::string_view name;
    std::string_view title;  // human-readable, a few words
    std::string_view help;   // one line
    int defaultSize;         // default width and height
    bool anySize;            // false: only the default size (paper8x8)
};

// Returns the recipes: bricks, spikes, pits, columns, city, fractal, hills, steps, checker, paper8x8, paper-walls.
const std::vector<ReliefRecipe>& reliefRecipes();
// Returns the recipe of this name. Throws InputError naming the subject, with the known names.
const ReliefRecipe& findRecipe(std::string_view name, const std::string& subject);
// Throws InputError naming the recipe if the recipe does not support this size in texels.
void checkRecipeSize(const ReliefRecipe& recipe, int width, int height);

// Makes a relief with heights in [0, 1], which tiles seamlessly if the recipe allows it. work: receives progress by
// rows and may stop the call; null: neither. Throws InputError for an unknown name or a size that the recipe does not
// support, and Cancelled.
FloatImage makeRelief(std::string_view name, int width, int height, std::uint64_t seed, Work* work = nullptr);

}  // namespace relief
