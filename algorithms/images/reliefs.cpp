#include "relief/reliefs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

float height(double value) {
    return static_cast<float>(std::floor(std::clamp(value, 0.0, 1.0) * 65535.0 + 0.5) / 65535.0);
}

int rounded(double value) {
    return static_cast<int>(std::floor(value + 0.5));
}

// Arguments of a recipe.
struct Canvas {
    int width;
    int height;
    std::uint64_t seed;
    Work* work;  // may be null

    // Starts the progress; the recipe will pass over all rows `passes` times.
    void begin(std::int64_t passes = 1) const {
        if (work != nullptr) work->progress().begin("making the relief", passes * height);
    }
    // To be called at the end of each row.
    void rowDone() const {
        if (work == nullptr) return;
        work->throwIfStopped();
        work->progress().advance();
    }
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
    FloatImage image() const { return {width, height}; }
};

// Index of the cell, of `count` equal cells over `size` texels, that contains texel i, and where that cell begins.
int cellOf(int i, int count, int size) {
    return static_cast<int>(static_cast<std::int64_t>(i) * count / size);
}
int cellBegin(int cell, int count, int size) {
    return static_cast<int>((static_cast<std::int64_t>(cell) * size + count - 1) / count);
}

FloatImage bricks(const Canvas& canvas) {
    FloatImage out = canvas.image();
    const int across = canvas.cells(canvas.width, 32);
    const int down = canvas.cells(canvas.height, 16, 2);
    const int mortar = canvas.scaled(5);
    const Chance faces(canvas.seed, 1);
    const Chance grain(canvas.seed, 2);
    canvas.begin();
    for (int y = 0; y < canvas.height; ++y) {
        const int row = cellOf(y, down, canvas.height);
        const bool bed = y - cellBegin(row, down, canvas.height) < mortar;
        // Half a brick. The shift wraps around, so that the bond continues across the seam.
        const int shift = row % 2 == 0 ? 0 : canvas.width / (2 * across);
        for (int x = 0; x < canvas.width; ++x) {
            const int sx = (x + shift) % canvas.width;
            const int column = cellOf(sx, across, canvas.width);
            const bool joint = bed || sx - cellBegin(column, across, canvas.width) < mortar;
            const double rough = grain.at(x, y);
            out(x, y) = height(joint ? 0.08 + 0.04 * rough : faces.between(0.90, 0.96, column, row) + 0.04 * rough);
        }
        canvas.rowDone();
    }
    return out;
}

// Squares at random places over rough ground. Where squares overlap, choose(old, new) is kept.
struct Scatter {
    double groundLow, groundHigh;
    double low, high;
    int narrowest, widest;
    std::int64_t count;
};

template <class Choose>
FloatImage scattered(const Canvas& canvas, const Scatter& scatter, const Choose& choose) {
    FloatImage out = canvas.image();
    const Chance ground(canvas.seed, 3);
    canvas.begin();
    for (int y = 0; y < canvas.height; ++y) {
        for (int x = 0; x < canvas.width; ++x)
            out(x, y) = height(ground.between(scatter.groundLow, scatter.groundHigh, x, y));
        canvas.rowDone();
    }
    const Chance place(canvas.seed, 4);
    const Chance value(canvas.seed, 5);
    for (std::int64_t i = 0; i < scatter.count; ++i) {
        const int left = place.whole(0, canvas.width - 1, i, 0);
        const int top = place.whole(0, canvas.height - 1, i, 1);
        const int size = place.whole(scatter.narrowest, scatter.widest, i, 2);
        const float h = height(value.between(scatter.low, scatter.high, i));
        for (int y = top; y < top + std::min(size, canvas.height); ++y)
            for (int x = left; x < left + std::min(size, canvas.width); ++x) {
                float& texel = out(x % canvas.width, y % canvas.height);
                texel = choose(texel, h);
            }
    }
    return out;
}

constexpr auto kHigher = [](float a, float b) { return std::max(a, b); };
constexpr auto kLower = [](float a, float b) { return std::min(a, b); };

FloatImage spikes(const Canvas& canvas) {
    // A needle covers 1 or 4 texels, 2.5 on average.
    const double count = 0.01 * canvas.width * canvas.height / 2.5;
    return scattered(canvas,
                     {.groundLow = 0.02,
                      .groundHigh = 0.05,
                      .low = 0.6,
                      .high = 1,
                      .narrowest = 1,
                      .widest = 2,
                      .count = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::floor(count + 0.5)))},
                     kHigher);
}

FloatImage pits(const Canvas& canvas) {
    return scattered(canvas,
                     {.groundLow = 0.93,
                      .groundHigh = 1,
                      .low = 0,
                      .high = 0.1,
                      .narrowest = canvas.scaled(3),
                      .widest = canvas.scaled(9),
                      .count = canvas.seeds(0.01)},
                     kLower);
}

FloatImage columns(const Canvas& canvas) {
    return scattered(canvas,
                     {.groundLow = 0.02,
                      .groundHigh = 0.05,
                      .low = 0.3,
                      .high = 1,
                      .narrowest = canvas.scaled(1),
                      .widest = canvas.scaled(3),
                      .count = canvas.seeds(0.012)},
                     kHigher);
}

FloatImage city(const Canvas& canvas) {
    FloatImage out = canvas.image();
    const int across = canvas.cells(canvas.width, 12);
    const int down = canvas.cells(canvas.height, 12);
    const int street = rounded(2 * canvas.scale());
    const int building = canvas.scaled(8);
    const Chance roofs(canvas.seed, 6);
    const auto built = [&](int offset) { return offset >= street && offset < street + building; };
    canvas.begin();
    for (int y = 0; y < canvas.height; ++y) {
        const int row = cellOf(y, down, canvas.height);
        const bool inRow = built(y - cellBegin(row, down, canvas.height));
        for (int x = 0; x < canvas.width; ++x) {
            const int column = cellOf(x, across, canvas.width);
            const bool inside = inRow && built(x - cellBegin(column, across, canvas.width));
            out(x, y) = height(inside ? roofs.between(0.5, 1, column, row) : 0.02);
        }
        canvas.rowDone();
    }
    return out;
}

// Maps the lowest value to 0 and the highest to 1; a constant picture becomes 0.5.
FloatImage stretched(const Image<double>& values) {
    FloatImage out(values.width(), values.height());
    const auto [low, high] = std::minmax_element(values.pixels().begin(), values.pixels().end());
    const double base = *low;
    const double span = *high - *low;
    for (std::size_t i = 0; i < out.size(); ++i)
        out.pixels()[i] = height(span > 0 ? (values.pixels()[i] - base) / span : 0.5);
    return out;
}

// Position of texel i between the nodes of a periodic lattice.
struct LatticePoint {
    int node;
    int next;
    double weight;  // of `next`, after smoothing
};

std::vector<LatticePoint> latticePoints(int size, int cells) {
    std::vector<LatticePoint> points(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
        const int node = cellOf(i, cells, size);
        const double f = static_cast<double>(static_cast<std::int64_t>(i) * cells % size) / size;
        points[static_cast<std::size_t>(i)] = {node, (node + 1) % cells, f * f * (3 - 2 * f)};
    }
    return points;
}

void addOctave(const Canvas& canvas, Image<double>& values, int cellsAcross, int cellsDown, double amplitude,
               const Chance& chance) {
    const auto across = latticePoints(values.width(), cellsAcross);
    const auto down = latticePoints(values.height(), cellsDown);
    std::vector<double> nodes(static_cast<std::size_t>(cellsAcross));
    for (int y = 0; y < values.height(); ++y) {
        const LatticePoint& py = down[static_cast<std::size_t>(y)];
        for (int i = 0; i < cellsAcross; ++i) {
            const double upper = chance.at(i, py.node);
            nodes[static_cast<std::size_t>(i)] = upper + (chance.at(i, py.next) - upper) * py.weight;
        }
        const auto row = values.row(y);
        for (std::size_t x = 0; x < row.size(); ++x) {
            const double left = nodes[static_cast<std::size_t>(across[x].node)];
            const double right = nodes[static_cast<std::size_t>(across[x].next)];
            row[x] += amplitude * (left + (right - left) * across[x].weight);
        }
        canvas.rowDone();
    }
}

FloatImage fractal(const Canvas& canvas) {
    Image<double> values(canvas.width, canvas.height);
    double amplitude = 1;
    std::int64_t octaves = 1;
    while (std::int64_t{16} << (octaves - 1) <= canvas.side()) ++octaves;
    canvas.begin(octaves);
    // The longer side gets proportionally more cells.
    for (std::int64_t cells = 4; cells == 4 || cells * 2 <= canvas.side(); cells *= 2, amplitude *= 0.6) {
        const auto along = [&](int size) {
            const std::int64_t count = (cells * size + canvas.side() / 2) / canvas.side();
            return static_cast<int>(std::clamp<std::int64_t>(count, 1, size));
        };
        addOctave(canvas, values, along(canvas.width), along(canvas.height), amplitude,
                  Chance(canvas.seed, 100 + static_cast<std::uint64_t>(cells)));
    }
    return stretched(values);
}

// sin(2 pi turns) for turns >= 0, within 1e-6. A polynomial, so that the bits are the same on every platform.
double sineOfTurns(double turns) {
    double q = (turns - std::floor(turns)) * 4;  // quarters, [0, 4)
    if (q > 3)
        q -= 4;
    else if (q > 1)
        q = 2 - q;
    const double x = q * 1.5707963267948966;
    const double s = x * x;
    return x * (1 + s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 - s / 39916800)))));
}

FloatImage hills(const Canvas& canvas) {
    Image<double> values(canvas.width, canvas.height);
    const Chance chance(canvas.seed, 7);
    constexpr int kWaves = 6;
    canvas.begin(kWaves);
    for (int wave = 0; wave < kWaves; ++wave) {
        // The first two waves run along the axes, so that heights vary in both directions.
        const int kx = wave == 1 ? 0 : wave == 0 ? 1 : chance.whole(1, 3, wave, 0);
        const int ky = wave == 0 ? 0 : wave == 1 ? 1 : chance.whole(-3, 3, wave, 1);
        const double phase = chance.at(wave, 2) + 8;  // keeps the argument positive
        const double amplitude = chance.between(0.4, 1, wave, 3);
        for (int y = 0; y < canvas.height; ++y) {
            for (int x = 0; x < canvas.width; ++x) {
                const double turns = static_cast<double>(static_cast<std::int64_t>(kx) * x) / canvas.width +
                                     static_cast<double>(static_cast<std::int64_t>(ky) * y) / canvas.height;
                values(x, y) += amplitude * sineOfTurns(turns + phase);
            }
            canvas.rowDone();
        }
    }
    return stretched(values);
}

FloatImage steps(const Canvas& canvas) {
    FloatImage out = hills(canvas);
    for (float& h : out.pixels()) h = height(std::min(7.0, std::floor(static_cast<double>(h) * 8)) / 7);
    return out;
}

FloatImage checker(const Canvas& canvas) {
    FloatImage out = canvas.image();
    const int block = std::max(1, canvas.side() / 16);
    // The number of blocks is even; otherwise two of one colour would meet at the seam.
    const auto blocks = [block](int size) {
        const int pairs = std::max(1, (size + block) / (2 * block));
        return std::max(1, std::min(2 * pairs, size - size % 2));
    };
    const int across = blocks(canvas.width);
    const int down = blocks(canvas.height);
    for (int y = 0; y < canvas.height; ++y)
        for (int x = 0; x < canvas.width; ++x) {
            const int sum = cellOf(x, across, canvas.width) + cellOf(y, down, canvas.height);
            out(x, y) = static_cast<float>(sum % 2);
        }
    return out;
}

FloatImage paper8x8(const Canvas&) {
    constexpr std::array<std::uint8_t, 64> kTenths{9, 8, 5, 6, 8, 6, 5, 6,  //
                                                   2, 3, 2, 6, 5, 7, 1, 2,  //
                                                   5, 4, 5, 4, 5, 4, 5, 4,  //
                                                   3, 7, 7, 3, 3, 6, 7, 3,  //
                                                   3, 4, 4, 5, 5, 4, 4, 3,  //
                                                   5, 2, 2, 3, 5, 4, 3, 2,  //
                                                   5, 4, 5, 4, 5, 4, 3, 2,  //
                                                   1, 7, 7, 3, 3, 7, 2, 3};
    FloatImage out(8, 8);
    for (std::size_t i = 0; i < kTenths.size(); ++i) out.pixels()[i] = static_cast<float>(kTenths[i] / 10.0);
    return out;
}

// Columns of heights 7 2 2 2 2 2 2 2 10 tenths; all rows are the same.
FloatImage paperWalls(const Canvas& canvas) {
    constexpr std::array<double, 9> kHeights{0.7, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 1.0};
    FloatImage out = canvas.image();
    for (int y = 0; y < canvas.height; ++y)
        for (int x = 0; x < canvas.width; ++x) {
            const auto column = static_cast<std::size_t>(cellOf(x, static_cast<int>(kHeights.size()), canvas.width));
            out(x, y) = height(kHeights[column]);
        }
    return out;
}

struct Maker {
    ReliefRecipe recipe;
    FloatImage (*make)(const Canvas&);
};

constexpr std::array kMakers{
    Maker{{"bricks", "bricks", "brick wall in a running bond with deep mortar", 256, true}, bricks},
    Maker{{"spikes", "spikes", "thin needles on a low ground", 256, true}, spikes},
    Maker{{"pits", "pits", "square pits in a high plateau", 256, true}, pits},
    Maker{{"columns", "thin columns", "thin columns on a low ground", 256, true}, columns},
    Maker{{"city", "city", "blocks with buildings of different heights", 256, true}, city},
    Maker{{"fractal", "fractal terrain", "rough terrain: value noise in octaves", 256, true}, fractal},
    Maker{{"hills", "hills", "smooth hills: a few sines", 256, true}, hills},
    Maker{{"steps", "terraces", "eight terraces with vertical walls", 256, true}, steps},
    Maker{{"checker", "checkerboard", "blocks of 0 and 1", 256, true}, checker},
    Maker{{"paper8x8", "the paper's 8 × 8", "the 8 x 8 example of the max pyramid's paper", 8, false}, paper8x8},
    Maker{{"paper-walls", "walls and a trench",
           "two walls with a trench between them: the example of the refined map's paper", 9, true},
          paperWalls},
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

FloatImage makeRelief(std::string_view name, int width, int height, std::uint64_t seed, Work* work) {
    checkRecipeSize(findRecipe(name, {}), width, height);
    const auto maker =
        std::find_if(kMakers.begin(), kMakers.end(), [&](const Maker& m) { return m.recipe.name == name; });
    const std::string subject(name);
    // Some recipes accumulate in double first.
    requireMemory(byteProduct({static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height),
                               sizeof(double) + sizeof(float)}),
                  subject + ":" + std::to_string(width) + "x" + std::to_string(height), MemoryHint::SmallerSize);
    return maker->make({width, height, seed, work});
}

}  // namespace relief
