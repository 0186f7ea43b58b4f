// The recipes of procedural reliefs, row by row, so that a relief may be larger than memory.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "images/height_rows.h"
#include "relief/reliefs.h"

namespace relief {

// Largest side of a relief that is made row by row, texels (kMaxReliefSide: in memory); recipes number their squares
// with 32 bits.
inline constexpr int kMaxRecipeSide = 1 << 18;

class RecipeRows {
  public:
    RecipeRows() = default;
    virtual ~RecipeRows() = default;
    RecipeRows(const RecipeRows&) = delete;
    RecipeRows& operator=(const RecipeRows&) = delete;

    // Passes over all rows, row() included.
    virtual int passes() const { return 1; }
    // Passes over all rows before row() is called, if the heights depend on all of them. rowDone: called after each
    // row, from any thread. Throws Cancelled.
    virtual void prepare(Work& /*work*/, const std::function<void()>& /*rowDone*/) {}
    // What prepare() has found, as text, and the reverse.
    virtual std::string learned() const { return "{}"; }
    virtual void restore(const std::string& /*learned*/) {}
    // Heights are multiples of 1/65535.
    virtual bool codes() const { return true; }
    // Writes the heights of row y. Thread-safe.
    virtual void row(int y, float* out) const = 0;
};

// Throws InputError for an unknown name or a size that the recipe does not support.
std::unique_ptr<RecipeRows> recipeRows(std::string_view name, int width, int height, std::uint64_t seed);

// A relief as heights in bands of rows: 16-bit codes, or floats where codes() is false. Throws as recipeRows().
std::unique_ptr<HeightRows> reliefHeightRows(std::string_view name, int width, int height, std::uint64_t seed);

}  // namespace relief
