// What the recipes of reliefs.cpp are made of.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "images/recipe_rows.h"

namespace relief {

// splitmix64's finalizer: every bit of the result depends on every bit of the key.
constexpr std::uint64_t mixed(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

// Random numbers that depend on the seed and on a purpose, not on the order of the calls.
class Chance {
  public:
    Chance(std::uint64_t seed, std::uint64_t purpose) : key_(mixed(mixed(seed) ^ purpose)) {}
    std::uint64_t bits(std::int64_t i, std::int64_t j = 0) const {
        return mixed(mixed(key_ ^ static_cast<std::uint64_t>(i)) ^ static_cast<std::uint64_t>(j));
    }
    // Uniform in [0, 1).
    double at(std::int64_t i, std::int64_t j = 0) const { return static_cast<double>(bits(i, j) >> 11) * 0x1p-53; }
    double between(double low, double high, std::int64_t i, std::int64_t j = 0) const {
        return low + (high - low) * at(i, j);
    }
    // Uniform in [low, high].
    int whole(int low, int high, std::int64_t i, std::int64_t j = 0) const {
        return low + static_cast<int>(bits(i, j) % static_cast<std::uint64_t>(high - low + 1));
    }

  private:
    std::uint64_t key_;
};

// A height, rounded to a multiple of 1/65535.
inline float height(double value) {
    return static_cast<float>(std::floor(std::clamp(value, 0.0, 1.0) * 65535.0 + 0.5) / 65535.0);
}

inline int rounded(double value) {
    return static_cast<int>(std::floor(value + 0.5));
}

// Arguments of a recipe.
struct Canvas {
    int width;
    int height;
    std::uint64_t seed;

    int side() const { return std::min(width, height); }
    double scale() const { return side() / 128.0; }
    int scaled(double at128) const { return std::max(1, rounded(at128 * scale())); }
    // Number of cells of that size that fit into `size` texels; a multiple of `step` where there is room.
    int cells(int size, double at128, int step = 1) const {
        const double count = step * std::floor(size / (at128 * scale() * step) + 0.5);
        return static_cast<int>(std::clamp(count, 1.0, static_cast<double>(size)));
    }
    // Number of seeds that cover the fraction `share` of the texels of the 128 picture.
    std::int64_t seeds(double share) const {
        const double shrink = std::max(1.0, scale());
        const double texels = static_cast<double>(width) * height / (shrink * shrink);
        return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::floor(share * texels + 0.5)));
    }
};

// Index of the cell, of `count` equal cells over `size` texels, that contains texel i, and where that cell begins.
inline int cellOf(int i, int count, int size) {
    return static_cast<int>(static_cast<std::int64_t>(i) * count / size);
}
inline int cellBegin(int cell, int count, int size) {
    return static_cast<int>((static_cast<std::int64_t>(cell) * size + count - 1) / count);
}

// Recipes of recipe_terrain.cpp.
std::unique_ptr<RecipeRows> makeFractal(const Canvas& canvas);
std::unique_ptr<RecipeRows> makeHills(const Canvas& canvas);
std::unique_ptr<RecipeRows> makeSteps(const Canvas& canvas);

}  // namespace relief
