#include "images/tiled_levels.h"

#include <algorithm>
#include <array>

#include "images/pyramid.h"

namespace relief {

namespace {

template <class Number>
NumberType typeOf() {
    if (sizeof(Number) == 1) return NumberType::UInt8;
    return sizeof(Number) == 2 ? NumberType::UInt16 : NumberType::Float;
}

std::uint64_t numberBytesOf(const TiledLayout& layout) {
    return static_cast<std::uint64_t>(numberBytes(layout.type));
}

template <class Number>
class LevelsOf final : public TiledLevels {
  public:
    explicit LevelsOf(const TiledLayout& layout) : layout_(layout) {
        for (int l = 1; l < layout.levels; ++l) {
            const TilePage& page = layout.page(TileKind::Max, l);
            Rows rows{.width = static_cast<std::size_t>(page.width), .height = page.height};
            const std::size_t count = rows.width * static_cast<std::size_t>(std::min(kTileSide, page.height));
            rows.most.resize(count);
            rows.least.resize(count);
            rows.sums.resize(count);
            levels_.push_back(std::move(rows));
        }
    }

    void add(const std::byte* rows, int count, ThreadTeam& threads) override {
        if (levels_.empty()) return;
        const auto* const heights = reinterpret_cast<const Number*>(rows);
        const auto height = [](Number code) {
            return static_cast<double>(tileValue(typeOf<Number>(), reinterpret_cast<const std::byte*>(&code), 0));
        };
        reduce(heights, heights, heights, height, static_cast<std::size_t>(layout_.width), count, levels_.front(),
               threads);
    }

    void flush(ThreadTeam& threads, Sink sink) override {
        for (std::size_t i = 0; i < levels_.size(); ++i) {
            Rows& rows = levels_[i];
            if (!rows.complete()) continue;
            hand(static_cast<int>(i) + 1, rows, threads, sink);
            const auto same = [](double sum) { return sum; };
            if (i + 1 < levels_.size())
                reduce(rows.most.data(), rows.least.data(), rows.sums.data(), same, rows.width, rows.filled,
                       levels_[i + 1], threads);
            rows.first += rows.filled;
            rows.filled = 0;
        }
    }

    std::vector<std::byte> save() const override;
    bool restore(std::span<const std::byte> saved) override;

  private:
    // Rows [first, first + filled) of a level, of which no more than kTileSide are kept.
    struct Rows {
        std::size_t width = 0;
        int height = 0;
        int first = 0, filled = 0;
        std::vector<Number> most{}, least{};
        std::vector<double> sums{};  // of the heights of level 0 below each texel

        bool complete() const { return filled > 0 && (filled == kTileSide || first + filled == height); }
        std::size_t texels() const { return width * static_cast<std::size_t>(filled); }
    };

    // Adds `count` rows of the level below to a level: see chosenLevel() and summedLevel() in pyramid.cpp.
    template <class Sum, class ToSum>
    static void reduce(const Number* most, const Number* least, const Sum* sums, const ToSum& toSum, std::size_t width,
                       int count, Rows& into, ThreadTeam& threads) {
        threads.run((count + 1) / 2, 1, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t y = begin; y < end; ++y) {
                const std::size_t upper = width * static_cast<std::size_t>(2 * y);
                const std::size_t lower =
                    width * static_cast<std::size_t>(std::min<std::int64_t>(2 * y + 1, count - 1));
                const std::size_t out = into.texels() + into.width * static_cast<std::size_t>(y);
                choose(most + upper, most + lower, width, into.most.data() + out,
                       [](Number a, Number b) { return a < b ? b : a; });
                choose(least + upper, least + lower, width, into.least.data() + out,
                       [](Number a, Number b) { return b < a ? b : a; });
                double* const sum = into.sums.data() + out;
                std::fill_n(sum, into.width, 0.0);
                addPairs(sums + upper, toSum, width, sum);
                if (lower != upper) addPairs(sums + lower, toSum, width, sum);
            }
        });
        into.filled += (count + 1) / 2;
    }

    template <class Choose>
    static void choose(const Number* upper, const Number* lower, std::size_t width, Number* out, const Choose& chosen) {
        for (std::size_t x = 0; x < width / 2; ++x)
            out[x] = chosen(chosen(upper[2 * x], upper[2 * x + 1]), chosen(lower[2 * x], lower[2 * x + 1]));
        if (width % 2 == 1) out[width / 2] = chosen(upper[width - 1], lower[width - 1]);
    }

    template <class Sum, class ToSum>
    static void addPairs(const Sum* row, const ToSum& toSum, std::size_t width, double* out) {
        for (std::size_t x = 0; x < width / 2; ++x) out[x] += toSum(row[2 * x]) + toSum(row[2 * x + 1]);
        if (width % 2 == 1) out[width / 2] += toSum(row[width - 1]);
    }

    void hand(int level, const Rows& rows, ThreadTeam& threads, Sink sink) {
        means_.resize(rows.texels());
        threads.run(rows.filled, 1, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t y = begin; y < end; ++y) {
                const std::int64_t down = coveredTexels(rows.first + y, level, layout_.height);
                const std::size_t at = rows.width * static_cast<std::size_t>(y);
                for (std::size_t x = 0; x < rows.width; ++x) {
                    const std::int64_t count = down * coveredTexels(static_cast<std::int64_t>(x), level, layout_.width);
                    means_[at + x] = static_cast<float>(rows.sums[at + x] / static_cast<double>(count));
                }
            }
        });
        const auto bytes = [](const auto& numbers) { return reinterpret_cast<const std::byte*>(numbers.data()); };
        sink(layout_.page(TileKind::Max, level), rows.first, rows.filled, bytes(rows.most));
        sink(layout_.page(TileKind::Min, level), rows.first, rows.filled, bytes(rows.least));
        sink(layout_.page(TileKind::Mean, level), rows.first, rows.filled, bytes(means_));
    }

    TiledLayout layout_;
    std::vector<Rows> levels_;
    std::vector<float> means_;
};

template <class Number>
std::vector<std::byte> LevelsOf<Number>::save() const {
    std::vector<std::byte> saved;
    const auto append = [&](const void* from, std::size_t bytes) {
        const auto* const first = static_cast<const std::byte*>(from);
        saved.insert(saved.end(), first, first + bytes);
    };
    for (const Rows& rows : levels_) {
        const std::array<std::int32_t, 2> where{rows.first, rows.filled};
        append(where.data(), sizeof where);
        append(rows.most.data(), rows.texels() * sizeof(Number));
        append(rows.least.data(), rows.texels() * sizeof(Number));
        append(rows.sums.data(), rows.texels() * sizeof(double));
    }
    return saved;
}

template <class Number>
bool LevelsOf<Number>::restore(std::span<const std::byte> saved) {
    const auto take = [&](void* to, std::size_t bytes) {
        if (saved.size() < bytes) return false;
        std::memcpy(to, saved.data(), bytes);
        saved = saved.subspan(bytes);
        return true;
    };
    for (Rows& rows : levels_) {
        std::array<std::int32_t, 2> where{};
        if (!take(where.data(), sizeof where)) return false;
        if (where[0] < 0 || where[0] > rows.height || where[1] < 0 || where[1] > std::min(kTileSide, rows.height))
            return false;
        rows.first = where[0];
        rows.filled = where[1];
        if (!take(rows.most.data(), rows.texels() * sizeof(Number)) ||
            !take(rows.least.data(), rows.texels() * sizeof(Number)) ||
            !take(rows.sums.data(), rows.texels() * sizeof(double)))
            return false;
    }
    return saved.empty();
}

}  // namespace

std::unique_ptr<TiledLevels> TiledLevels::of(const TiledLayout& layout) {
    if (layout.type == NumberType::UInt8) return std::make_unique<LevelsOf<std::uint8_t>>(layout);
    if (layout.type == NumberType::UInt16) return std::make_unique<LevelsOf<std::uint16_t>>(layout);
    return std::make_unique<LevelsOf<float>>(layout);
}

std::uint64_t TiledLevels::savedBytes(const TiledLayout& layout) {
    std::uint64_t bytes = 0;
    for (int l = 1; l < layout.levels; ++l) {
        const TilePage& page = layout.page(TileKind::Max, l);
        const auto texels =
            static_cast<std::uint64_t>(page.width) * static_cast<std::uint64_t>(std::min(kTileSide, page.height));
        bytes += 2 * sizeof(std::int32_t) + texels * (2 * numberBytesOf(layout) + sizeof(double));
    }
    return bytes;
}

std::uint64_t TiledLevels::memoryBytes(const TiledLayout& layout) {
    // The levels, and the means of the widest.
    return savedBytes(layout) + static_cast<std::uint64_t>(layout.width) / 2 * kTileSide * sizeof(float);
}

}  // namespace relief
