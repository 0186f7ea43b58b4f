// Procedural reliefs: seeded, the same bits on every machine. The recipes stand in reliefs.cpp.
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
    std::string_view help;  // one line
    int defaultSize;        // square
    bool anySize;           // paper8x8 is 8 x 8 only
};

// bricks, spikes, pits, columns, city, fractal, hills, steps, checker, paper8x8, paper-walls
const std::vector<ReliefRecipe>& reliefRecipes();

// Heights in [0, 1]; tile seamlessly where the recipe allows. work: where rows are reported and when to stop; null: no
// report. Throws InputError for an unknown name or a size that the recipe does not take, Cancelled where the work is
// stopped.
FloatImage makeRelief(std::string_view name, int width, int height, std::uint64_t seed, Work* work = nullptr);

}  // namespace relief
