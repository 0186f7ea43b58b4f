#include "images/pyramid.h"

#include <algorithm>
#include <bit>
#include <set>

#include "base/parallel.h"

namespace relief {

namespace {

// Pyramids of at least this number of texels take long enough to show progress.
constexpr std::size_t kProgressTexels = std::size_t{1} << 22;

// Rows of a level per task, so that narrow levels are not divided into too many tasks.
int rowGrain(int width) {
    return std::max(1, (1 << 14) / width);
}

template <class RowFunction>
void forRows(int width, int height, bool tell, Work& work, const RowFunction& rowFunction) {
    parallelRanges(work, height, rowGrain(width), [&](int first, int last) {
        for (int y = first; y < last; ++y) rowFunction(y);
        if (tell) work.progress().advance(last - first);
    });
}

// Builds the next coarser level by a choice between values: maximum or minimum.
template <class Choose>
FloatImage chosenLevel(const FloatImage& below, bool tell, Work& work, const Choose& choose) {
    FloatImage level((below.width() + 1) / 2, (below.height() + 1) / 2);
    forRows(level.width(), level.height(), tell, work, [&](int y) {
        const auto upper = below.row(2 * y);
        // A missing neighbour beyond the last row or column is replaced by that row or column: the choice is the same.
        const auto lower = below.row(std::min(2 * y + 1, below.height() - 1));
        const auto out = level.row(y);
        const std::size_t pairs = upper.size() / 2;
        for (std::size_t x = 0; x < pairs; ++x)
            out[x] = choose(choose(upper[2 * x], upper[2 * x + 1]), choose(lower[2 * x], lower[2 * x + 1]));
        if (pairs < out.size()) out[pairs] = choose(upper.back(), lower.back());
    });
    return level;
}

// Sums level 0's texels below each texel of the level, so that a mean is rounded once and not once per level.
template <class T>
Image<double> summedLevel(const Image<T>& below, bool tell, Work& work) {
    Image<double> level((below.width() + 1) / 2, (below.height() + 1) / 2);
    forRows(level.width(), level.height(), tell, work, [&](int y) {
        const auto out = level.row(y);
        for (int from = 2 * y; from < std::min(2 * y + 2, below.height()); ++from) {
            const auto row = below.row(from);
            const std::size_t pairs = row.size() / 2;
            for (std::size_t x = 0; x < pairs; ++x)
                out[x] += static_cast<double>(row[2 * x]) + static_cast<double>(row[2 * x + 1]);
            if (pairs < out.size()) out[pairs] += static_cast<double>(row.back());
        }
    });
    return level;
}

FloatImage meansOf(const Image<double>& sums, int l, const FloatImage& base, bool tell, Work& work) {
    FloatImage level(sums.width(), sums.height());
    forRows(level.width(), level.height(), tell, work, [&](int y) {
        const std::int64_t rows = coveredTexels(y, l, base.height());
        for (int x = 0; x < level.width(); ++x) {
            const std::int64_t count = rows * coveredTexels(x, l, base.width());
            level(x, y) = static_cast<float>(sums(x, y) / static_cast<double>(count));
        }
    });
    return level;
}

// The same sum as summedLevel() for one texel of level l, added in the same order.
double sumAt(const FloatImage& base, int l, int x, int y) {
    if (l == 0) return static_cast<double>(base(x, y));
    const auto size = [l](int whole) { return static_cast<int>(((std::int64_t{whole} - 1) >> (l - 1)) + 1); };
    double sum = 0;
    for (int j = 2 * y; j < std::min(2 * y + 2, size(base.height())); ++j) {
        const bool pair = 2 * x + 1 < size(base.width());
        sum += pair ? sumAt(base, l - 1, 2 * x, j) + sumAt(base, l - 1, 2 * x + 1, j) : sumAt(base, l - 1, 2 * x, j);
    }
    return sum;
}

// Value of texel (x, y) of level l, computed from the level below or, for means, from level 0.
float valueAt(PyramidKind kind, const FloatImage& base, const FloatImage& below, int l, int x, int y) {
    if (kind == PyramidKind::Mean) {
        const std::int64_t count = coveredTexels(x, l, base.width()) * coveredTexels(y, l, base.height());
        return static_cast<float>(sumAt(base, l, x, y) / static_cast<double>(count));
    }
    const int right = std::min(2 * x + 1, below.width() - 1), lower = std::min(2 * y + 1, below.height() - 1);
    const auto choose = [kind](float a, float b) {
        const bool second = kind == PyramidKind::Max ? a < b : b < a;
        return second ? b : a;
    };
    return choose(choose(below(2 * x, 2 * y), below(right, 2 * y)), choose(below(2 * x, lower), below(right, lower)));
}

bool sameBits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

}  // namespace

int Pyramid::levelCount(int width, int height) {
    assert(width >= 1 && height >= 1);
    int count = 1;
    for (std::int64_t size = std::max(width, height); size > 1; size = (size + 1) / 2) ++count;
    return count;
}

Pyramid::Pyramid(PyramidKind kind, std::shared_ptr<const FloatImage> shared, Work& work) : kind_(kind) {
    const FloatImage& base = *shared;
    assert(base.width() >= 1 && base.height() >= 1);
    const int count = levelCount(base.width(), base.height());
    const bool tell = base.size() >= kProgressTexels;
    if (tell) {
        const int passes = kind == PyramidKind::Mean ? 2 : 1;
        std::int64_t rows = 0;
        for (std::int64_t l = 1, h = base.height(); l < count; ++l) rows += h = (h + 1) / 2;
        work.progress().begin("pyramid", rows * passes);
    }
    levels_.reserve(static_cast<std::size_t>(count));
    levels_.push_back(std::move(shared));
    Image<double> sums;
    for (int l = 1; l < count; ++l) {
        work.throwIfStopped();
        const FloatImage& below = *levels_.back();
        const auto keep = [&](FloatImage level) {
            levels_.push_back(std::make_shared<const FloatImage>(std::move(level)));
        };
        if (kind == PyramidKind::Mean) {
            sums = l == 1 ? summedLevel(base, tell, work) : summedLevel(sums, tell, work);
            keep(meansOf(sums, l, base, tell, work));
        } else if (kind == PyramidKind::Max) {
            keep(chosenLevel(below, tell, work, [](float a, float b) { return a < b ? b : a; }));
        } else {
            keep(chosenLevel(below, tell, work, [](float a, float b) { return b < a ? b : a; }));
        }
    }
}

Pyramid Pyramid::edited(const Pyramid& before, FloatImage base) {
    Pyramid pyramid = edited(before, std::make_shared<const FloatImage>(std::move(base)));
    pyramid.ownsBase_ = true;
    return pyramid;
}

Pyramid Pyramid::edited(const Pyramid& before, std::shared_ptr<const FloatImage> base) {
    const FloatImage &now = *base, &old = before.level(0);
    assert(now.width() == old.width() && now.height() == old.height());
    std::set<std::pair<int, int>> texels;  // of level l, that may have changed
    for (int y = 0; y < now.height(); ++y) {
        for (int x = 0; x < now.width(); ++x) {
            if (!sameBits(now(x, y), old(x, y))) texels.emplace(x, y);
        }
    }
    Pyramid pyramid;
    pyramid.kind_ = before.kind_;
    pyramid.levels_ = before.levels_;
    pyramid.levels_.front() = std::move(base);
    for (int l = 1; l < before.levels() && !texels.empty(); ++l) {
        std::set<std::pair<int, int>> above, changed;
        for (const auto& [x, y] : texels) above.emplace(x / 2, y / 2);
        FloatImage level = before.level(l);
        for (const auto& [x, y] : above) {
            const float value = valueAt(before.kind_, now, pyramid.level(l - 1), l, x, y);
            if (sameBits(value, level(x, y))) continue;
            level(x, y) = value;
            changed.emplace(x, y);
        }
        if (!changed.empty()) {
            pyramid.levels_[static_cast<std::size_t>(l)] = std::make_shared<const FloatImage>(std::move(level));
        }
        // Means are not computed from the means below: a mean may change even if the one below it is rounded to the
        // same value.
        texels = before.kind_ == PyramidKind::Mean ? above : changed;
    }
    return pyramid;
}

std::size_t Pyramid::bytes() const {
    std::size_t sum = 0;
    for (std::size_t l = ownsBase_ ? 0 : 1; l < levels_.size(); ++l) sum += levels_[l]->bytes();
    return sum;
}

}  // namespace relief
