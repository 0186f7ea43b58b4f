#include "images/recipe_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "images/recipe_parts.h"
#include "relief/errors.h"
#include "relief/memory.h"

// The recipes, for a relief whose shorter side has N texels. Sizes marked "at 128" are multiplied by N/128 and are at
// least one texel. Cells are stretched so that a whole number of them fits; therefore every relief but paper8x8 tiles.
// Ranges without a unit are heights.
//   bricks   32 x 16 at 128 in a running bond, mortar 5 at 128 of 0.08-0.12, faces 0.90-1.00
//   spikes   needles 1-2 texels wide on 1% of the texels, 0.6-1 over a ground of 0.02-0.05
//   pits     1% of the texels (of the 128 picture) seed square pits 3-9 at 128, 0-0.1 in a plateau of 0.93-1
//   columns  1.2% likewise, 1-3 at 128, 0.3-1 over 0.02-0.05
//   city     blocks of 12 at 128 with a building 8 wide, 0.5-1 over 0.02
//   fractal  value noise from 4 cells up, twice the cells and 0.6 of the amplitude an octave, stretched to [0, 1]
//   hills    six sines of whole frequencies up to 3, stretched to [0, 1]
//   steps    hills cut into 8 terraces
//   checker  0 and 1 in blocks of max(1, N/16) texels
//   paper8x8 the example of [MIP18], fig. 3
//   paper-walls  columns 7 2 2 2 2 2 2 2 10 in a slab 10 high, as in [DIST17], figs. 5 to 8. With 9 texels, relief
//                depth 10/9, columns and border, the point (4, any, 0.6) is 3 texels from the surface, and 4 texels
//                from what rays from above can meet
// Heights are multiples of 1/65535, which a 16-bit file stores exactly; those of paper8x8 are tenths. Only + - * / and
// rounding are used, so the result does not depend on a C library.
namespace relief {

namespace {

// Rows that need nothing but their number.
class Bricks final : public RecipeRows {
  public:
    explicit Bricks(const Canvas& canvas) : canvas_(canvas), faces_(canvas.seed, 1), grain_(canvas.seed, 2) {}
    void row(int y, float* out) const override {
        const int row = cellOf(y, down_, canvas_.height);
        const bool bed = y - cellBegin(row, down_, canvas_.height) < mortar_;
        // Half a brick. The shift wraps around, so that the bond continues across the seam.
        const int shift = row % 2 == 0 ? 0 : canvas_.width / (2 * across_);
        for (int x = 0; x < canvas_.width; ++x) {
            const int sx = (x + shift) % canvas_.width;
            const int column = cellOf(sx, across_, canvas_.width);
            const bool joint = bed || sx - cellBegin(column, across_, canvas_.width) < mortar_;
            const double rough = grain_.at(x, y);
            out[x] = height(joint ? 0.08 + 0.04 * rough : faces_.between(0.90, 0.96, column, row) + 0.04 * rough);
        }
    }

  private:
    Canvas canvas_;
    int across_ = canvas_.cells(canvas_.width, 32);
    int down_ = canvas_.cells(canvas_.height, 16, 2);
    int mortar_ = canvas_.scaled(5);
    Chance faces_, grain_;
};

// Squares at random places over rough ground. Where squares overlap, the highest or the lowest is kept.
struct Scatter {
    double groundLow, groundHigh;
    double low, high;
    int narrowest, widest;
    std::int64_t count;
    bool highest;
};

class Scattered final : public RecipeRows {
  public:
    Scattered(const Canvas& canvas, const Scatter& scatter)
        : canvas_(canvas), scatter_(scatter), ground_(canvas.seed, 3), place_(canvas.seed, 4), value_(canvas.seed, 5) {
        requireMemory(byteProduct({sizeof(std::uint32_t), static_cast<std::uint64_t>(scatter.count)}), "");
        // Counting sort by the row in which a square begins.
        begins_.resize(static_cast<std::size_t>(canvas.height) + 1);
        for (std::int64_t i = 0; i < scatter.count; ++i) ++begins_[static_cast<std::size_t>(top(i)) + 1];
        for (std::size_t y = 1; y < begins_.size(); ++y) begins_[y] += begins_[y - 1];
        std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
        squares_.resize(static_cast<std::size_t>(scatter.count));
        for (std::int64_t i = 0; i < scatter.count; ++i)
            squares_[next[static_cast<std::size_t>(top(i))]++] = static_cast<std::uint32_t>(i);
    }

    void row(int y, float* out) const override {
        for (int x = 0; x < canvas_.width; ++x)
            out[x] = height(ground_.between(scatter_.groundLow, scatter_.groundHigh, x, y));
        for (int above = 0; above < std::min(scatter_.widest, canvas_.height); ++above) {
            const int begin = y - above + (y < above ? canvas_.height : 0);
            const auto at = static_cast<std::size_t>(begin);
            for (std::uint32_t n = begins_[at]; n < begins_[at + 1]; ++n) {
                const std::int64_t i = squares_[n];
                const int size = place_.whole(scatter_.narrowest, scatter_.widest, i, 2);
                if (above < size) put(i, size, out);
            }
        }
    }

  private:
    int top(std::int64_t i) const { return place_.whole(0, canvas_.height - 1, i, 1); }
    void put(std::int64_t i, int size, float* out) const {
        const int left = place_.whole(0, canvas_.width - 1, i, 0);
        const float h = height(value_.between(scatter_.low, scatter_.high, i));
        for (int x = left; x < left + std::min(size, canvas_.width); ++x) {
            float& texel = out[x % canvas_.width];
            texel = scatter_.highest ? std::max(texel, h) : std::min(texel, h);
        }
    }

    Canvas canvas_;
    Scatter scatter_;
    Chance ground_, place_, value_;
    std::vector<std::uint32_t> begins_, squares_;  // squares_[begins_[y]] is the first that begins in row y
};

Scatter spikes(const Canvas& canvas) {
    // A needle covers 1 or 4 texels, 2.5 on average.
    const double count = 0.01 * canvas.width * canvas.height / 2.5;
    return {.groundLow = 0.02,
            .groundHigh = 0.05,
            .low = 0.6,
            .high = 1,
            .narrowest = 1,
            .widest = 2,
            .count = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::floor(count + 0.5))),
            .highest = true};
}

Scatter pits(const Canvas& canvas) {
    return {.groundLow = 0.93,
            .groundHigh = 1,
            .low = 0,
            .high = 0.1,
            .narrowest = canvas.scaled(3),
            .widest = canvas.scaled(9),
            .count = canvas.seeds(0.01),
            .highest = false};
}

Scatter columns(const Canvas& canvas) {
    return {.groundLow = 0.02,
            .groundHigh = 0.05,
            .low = 0.3,
            .high = 1,
            .narrowest = canvas.scaled(1),
            .widest = canvas.scaled(3),
            .count = canvas.seeds(0.012),
            .highest = true};
}

class City final : public RecipeRows {
  public:
    explicit City(const Canvas& canvas) : canvas_(canvas), roofs_(canvas.seed, 6) {}
    void row(int y, float* out) const override {
        const int row = cellOf(y, down_, canvas_.height);
        const bool inRow = built(y - cellBegin(row, down_, canvas_.height));
        for (int x = 0; x < canvas_.width; ++x) {
            const int column = cellOf(x, across_, canvas_.width);
            const bool inside = inRow && built(x - cellBegin(column, across_, canvas_.width));
            out[x] = height(inside ? roofs_.between(0.5, 1, column, row) : 0.02);
        }
    }

  private:
    bool built(int offset) const { return offset >= street_ && offset < street_ + building_; }

    Canvas canvas_;
    int across_ = canvas_.cells(canvas_.width, 12);
    int down_ = canvas_.cells(canvas_.height, 12);
    int street_ = rounded(2 * canvas_.scale());
    int building_ = canvas_.scaled(8);
    Chance roofs_;
};

class Checker final : public RecipeRows {
  public:
    explicit Checker(const Canvas& canvas) : canvas_(canvas) {}
    void row(int y, float* out) const override {
        for (int x = 0; x < canvas_.width; ++x)
            out[x] = static_cast<float>((cellOf(x, across_, canvas_.width) + cellOf(y, down_, canvas_.height)) % 2);
    }

  private:
    // The number of blocks is even; otherwise two of one colour would meet at the seam.
    int blocks(int size) const {
        const int block = std::max(1, canvas_.side() / 16);
        const int pairs = std::max(1, (size + block) / (2 * block));
        return std::max(1, std::min(2 * pairs, size - size % 2));
    }
    Canvas canvas_;
    int across_ = blocks(canvas_.width);
    int down_ = blocks(canvas_.height);
};

class Paper8x8 final : public RecipeRows {
  public:
    explicit Paper8x8(const Canvas& /*canvas*/) {}
    bool codes() const override { return false; }
    void row(int y, float* out) const override {
        constexpr std::array<std::uint8_t, 64> kTenths{9, 8, 5, 6, 8, 6, 5, 6,  //
                                                       2, 3, 2, 6, 5, 7, 1, 2,  //
                                                       5, 4, 5, 4, 5, 4, 5, 4,  //
                                                       3, 7, 7, 3, 3, 6, 7, 3,  //
                                                       3, 4, 4, 5, 5, 4, 4, 3,  //
                                                       5, 2, 2, 3, 5, 4, 3, 2,  //
                                                       5, 4, 5, 4, 5, 4, 3, 2,  //
                                                       1, 7, 7, 3, 3, 7, 2, 3};
        for (int x = 0; x < 8; ++x) out[x] = static_cast<float>(kTenths[static_cast<std::size_t>(8 * y + x)] / 10.0);
    }
};

// Columns of heights 7 2 2 2 2 2 2 2 10 tenths; all rows are the same.
class PaperWalls final : public RecipeRows {
  public:
    explicit PaperWalls(const Canvas& canvas) : canvas_(canvas) {}
    void row(int, float* out) const override {
        constexpr std::array<double, 9> kHeights{0.7, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 1.0};
        for (int x = 0; x < canvas_.width; ++x)
            out[x] =
                height(kHeights[static_cast<std::size_t>(cellOf(x, static_cast<int>(kHeights.size()), canvas_.width))]);
    }

  private:
    Canvas canvas_;
};

template <class Recipe>
std::unique_ptr<RecipeRows> made(const Canvas& canvas) {
    return std::make_unique<Recipe>(canvas);
}

template <Scatter (*scatter)(const Canvas&)>
std::unique_ptr<RecipeRows> scattered(const Canvas& canvas) {
    return std::make_unique<Scattered>(canvas, scatter(canvas));
}

struct Maker {
    ReliefRecipe recipe;
    std::unique_ptr<RecipeRows> (*make)(const Canvas&);
};

constexpr std::array kMakers{
    Maker{{"bricks", "bricks", "brick wall in a running bond with deep mortar", 256, true}, made<Bricks>},
    Maker{{"spikes", "spikes", "thin needles on a low ground", 256, true}, scattered<spikes>},
    Maker{{"pits", "pits", "square pits in a high plateau", 256, true}, scattered<pits>},
    Maker{{"columns", "thin columns", "thin columns on a low ground", 256, true}, scattered<columns>},
    Maker{{"city", "city", "blocks with buildings of different heights", 256, true}, made<City>},
    Maker{{"fractal", "fractal terrain", "rough terrain: value noise in octaves", 256, true}, makeFractal},
    Maker{{"hills", "hills", "smooth hills: a few sines", 256, true}, makeHills},
    Maker{{"steps", "terraces", "eight terraces with vertical walls", 256, true}, makeSteps},
    Maker{{"checker", "checkerboard", "blocks of 0 and 1", 256, true}, made<Checker>},
    Maker{{"paper8x8", "the paper's 8 × 8", "the 8 x 8 example of the max pyramid's paper", 8, false}, made<Paper8x8>},
    Maker{{"paper-walls", "walls and a trench",
           "two walls with a trench between them: the example of the refined map's paper", 9, true},
          made<PaperWalls>},
};

}  // namespace

const std::vector<ReliefRecipe>& reliefRecipes() {
    static const std::vector<ReliefRecipe> recipes = [] {
        std::vector<ReliefRecipe> list;
        list.reserve(kMakers.size());
        for (const Maker& maker : kMakers) list.push_back(maker.recipe);
        return list;
    }();
    return recipes;
}

const ReliefRecipe& findRecipe(std::string_view name, const std::string& subject) {
    std::string known;
    for (const ReliefRecipe& recipe : reliefRecipes()) {
        if (recipe.name == name) return recipe;
        known.append(known.empty() ? "" : ", ").append(recipe.name);
    }
    throw InputError(subject, unknownName({"what", MessageId::WordRelief}, std::string(name), known));
}

void checkRecipeSize(const ReliefRecipe& recipe, int width, int height) {
    const std::string subject(recipe.name);
    if (width < 1 || height < 1)
        throw InputError(subject, Message(MessageId::PictureEmpty, {{"width", width}, {"height", height}}));
    const int fixed = recipe.defaultSize;
    if (!recipe.anySize && (width != fixed || height != fixed))
        throw InputError(
            subject, Message(MessageId::ReliefSize, {{"wanted", std::to_string(fixed) + " x " + std::to_string(fixed)},
                                                     {"width", width},
                                                     {"height", height}}));
}

std::unique_ptr<RecipeRows> recipeRows(std::string_view name, int width, int height, std::uint64_t seed) {
    checkRecipeSize(findRecipe(name, {}), width, height);
    const auto maker =
        std::find_if(kMakers.begin(), kMakers.end(), [&](const Maker& m) { return m.recipe.name == name; });
    return maker->make({width, height, seed});
}

}  // namespace relief
