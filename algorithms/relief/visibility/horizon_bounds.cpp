#include "relief/visibility/horizon_bounds.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/parallel.h"
#include "relief/visibility/any_hit.h"

namespace relief {

namespace {

// Strips that a thread sweeps at once, and lines whose heights are transposed together.
constexpr int kStrips = 256, kBlock = 16;
// Values that are read beyond a row, a vector of 16 among them.
constexpr int kBeyond = 24;
// Runs of the light, texels per slab. Below: straight above, where a ray takes no step. Above: the rays' own rounding
// nears the margins.
constexpr double kLeastRun = 1e-3, kMostRun = 65536;
// Heights per cell; faster light clears every cell at once.
constexpr double kMostRise = 4;
// Steps of stored heights below which the map is flat: far below the margins.
constexpr double kLeastUnit = 1e-20;
// No bound.
constexpr float kNone = -1;
// Steps of the stored heights.
constexpr double kSteps = 65500;

}  // namespace

bool HorizonBounds::suits(const HeightField& field, glm::dvec2 run) {
    const double most = std::max(std::abs(run.x), std::abs(run.y));
    return field.tiles() == nullptr && field.texels() <= kMaxPackedTexels && most >= kLeastRun && most <= kMostRun;
}

int HorizonBounds::Frame::texel(std::int64_t at, int cells, int size, bool back) const {
    if (columns && back) at = cells - 1 - at;
    if (!columns && back) at = cells - at;
    if (!columns && !wraps) --at;
    if (!wraps) return static_cast<int>(std::clamp<std::int64_t>(at, 0, size - 1));
    const std::int64_t rest = at % size;
    return static_cast<int>(rest < 0 ? rest + size : rest);
}

HorizonBounds::HorizonBounds(const HeightField& field, glm::dvec2 run, Work& work) : field_(field), run_(run) {
    assert(suits(field, run));
    const CellGrid grid(field);
    Frame& f = frame_;
    f.swapped = std::abs(run.y) > std::abs(run.x);
    const GridAxis &x = f.swapped ? grid.y : grid.x, &y = f.swapped ? grid.x : grid.y;
    const double along = f.swapped ? run.y : run.x, across = f.swapped ? run.x : run.y;
    f.backX = along < 0, f.backY = across < 0;
    f.wraps = x.wraps, f.columns = field.surface() == Surface::Columns;
    f.nx = x.cells, f.ny = y.cells, f.sizeX = x.texels, f.sizeY = y.texels;
    f.shiftX = x.shift, f.shiftY = y.shift;
    f.slope = std::abs(across / along);
    f.rise = 1 / std::abs(along);
    f.stride = static_cast<std::size_t>(f.wraps ? f.ny : f.ny + 2);

    const auto [low, high] = minMax<float>(work, field.heights().pixels());
    lowest_ = static_cast<double>(low);
    const auto highest = static_cast<double>(high);
    unit_ = (highest - lowest_) / kSteps;
    if (f.wraps) {
        // After that many lines a bound of `highest` has sunk to `lowest`; a shorter lead only loosens the bounds.
        leadIn_ = static_cast<int>(std::min(2.0 * f.nx, (highest - lowest_) / f.rise + 2));
        outside_ = static_cast<float>(highest);
    } else {
        // Under clamp the outer texels go on for ever; under border nothing is there.
        outside_ = field.address() == Address::Border ? kNone : static_cast<float>(highest);
    }
    // What the sweep does not reach is the last line of a map that does not wrap: nothing is known beyond it.
    entries_.resize(static_cast<std::size_t>(f.nx + 1) * f.stride,
                    (outside_ < 0 ? 0U : static_cast<std::uint32_t>(kSteps)) << 16U);
    // Strips by their place on line 0; those of a map that does not wrap begin up to its whole shift before it.
    const int first = f.wraps ? 0 : -1 - static_cast<int>(std::floor(f.slope * f.nx));
    const int last = f.wraps ? f.ny : f.ny + 1;
    parallelFor(work, (last - first + kStrips - 1) / kStrips, [&](int n) {
        const int from = first + n * kStrips;
        sweep(from, std::min(from + kStrips, last));
    });
}

// The rows of heights of a block of lines, and the state of a run of strips.
struct HorizonBounds::Strips {
    Strips(int first, int count, float outside)
        : first(first),
          count(count),
          upper(static_cast<std::size_t>(count + kBeyond), outside),
          lower(upper.size(), kNone),
          steep(3 * upper.size()),
          out(upper.size()) {}

    int first, count;  // strips by their place on line 0
    std::vector<float> upper, lower, steep;
    std::vector<std::uint32_t> out;
    // Row k holds the heights on line firstLine + k, from place firstPlace on.
    int firstLine = 0, firstPlace = 0, across = 0;
    std::vector<float> rows;
    std::vector<int> texels;

    void read(const HorizonBounds& bounds, int begin, int end);
    const float* row(int line, int place) const {
        return rows.data() + std::ptrdiff_t{line - firstLine} * across + (place - firstPlace);
    }
};

// Transposes, mirrors and repeats the heights on the lines begin - 1 to end as the map needs them.
void HorizonBounds::Strips::read(const HorizonBounds& bounds, int begin, int end) {
    const Frame& f = bounds.frame_;
    const auto width = static_cast<std::size_t>(bounds.field_.width());
    const float* const heights = bounds.field_.heights().data();
    const int lines = end - begin + 2;
    firstLine = begin - 1, firstPlace = first + f.shift(begin);
    across = count + f.shift(end) - f.shift(begin) + kBeyond;
    rows.resize(static_cast<std::size_t>(lines) * static_cast<std::size_t>(across));
    texels.resize(static_cast<std::size_t>(lines));
    for (int k = 0; k < lines; ++k) texels[static_cast<std::size_t>(k)] = f.texelX(firstLine + k);
    for (int c = 0; c < across; ++c) {
        const auto other = static_cast<std::size_t>(f.texelY(firstPlace + c));
        const float* const from = heights + (f.swapped ? other : other * width);
        float* to = rows.data() + c;
        for (const int texel : texels) {
            *to = from[static_cast<std::size_t>(texel) * (f.swapped ? width : 1)];
            to += across;
        }
    }
}

// Sweeps the strips that begin at the places first to last - 1 of line 0, against the light.
void HorizonBounds::sweep(int first, int last) {
    const Frame& f = frame_;
    Strips strips(first, last - first, outside_);
    const bool border = field_.address() == Address::Border;
    // Directed away from what is close: the upper bound sinks too slowly, the lower one too fast.
    const float rise = static_cast<float>(std::min(f.rise, kMostRise));
    const float step = kHorizonStep * std::max(1.0F, rise);
    float* const steep = strips.steep.data();
    const std::size_t room = strips.upper.size();
    for (int end = f.nx + leadIn_; end > 0; end -= kBlock) {
        const int begin = std::max(end - kBlock, 0);
        strips.read(*this, begin, end);
        for (int l = end - 1; l >= begin; --l) {
            const int place = first + f.shift(l);
            const double fraction = f.slope * l - f.shift(l);
            sweepHorizonLine({strips.row(l, place),
                              strips.row(f.columns ? l - 1 : l + 1, place),
                              {steep, steep + room, steep + 2 * room},
                              strips.upper.data(),
                              strips.lower.data(),
                              strips.out.data(),
                              static_cast<std::size_t>(strips.count),
                              static_cast<float>(fraction),
                              static_cast<float>(f.slope),
                              rise,
                              rise - step,
                              rise + step,
                              f.columns,
                              fraction + f.slope > 0,
                              fraction + f.slope > 1,
                              static_cast<float>(lowest_),
                              unit_ > kLeastUnit ? static_cast<float>(1 / unit_) : 0.0F});
            for (int k = 0; border && k < strips.count; ++k) {
                // Strips that lie partly outside the picture.
                if (place + k >= 1 && place + k <= f.ny - 3) continue;
                strips.lower[static_cast<std::size_t>(k)] = kNone;
                strips.out[static_cast<std::size_t>(k)] &= 0xffff0000U;
            }
            if (l <= f.nx) store(l, place, {strips.out.data(), static_cast<std::size_t>(strips.count)});
        }
    }
}

// Stores the entries of the strips from `place` on line l on.
void HorizonBounds::store(int l, int place, std::span<const std::uint32_t> row) {
    const Frame& f = frame_;
    const int count = static_cast<int>(row.size());
    for (int k = 0; k < count;) {
        const int c = f.wraps ? (place + k) % f.ny : place + k;
        if (c < -1) {
            ++k;
            continue;
        }
        if (!f.wraps && c > f.ny) return;
        const int more = std::min(count - k, (f.wraps ? f.ny : f.ny + 1) - c);
        std::copy_n(row.begin() + k, more, entries_.begin() + static_cast<std::ptrdiff_t>(f.entry(l, c)));
        k += more;
    }
}

}  // namespace relief
