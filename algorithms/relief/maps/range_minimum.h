// The minimum over a range of a line in constant time: a sparse table over all rows (or columns) of a picture.
#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "relief/image.h"

namespace relief {

// Lines are the rows of the given picture. wraps: a range may continue from the end of a line at its beginning.
class RangeMinimum {
  public:
    RangeMinimum(const FloatImage& lines, bool wraps) {
        levels_.push_back(lines);
        for (int length = 2; length <= lines.width(); length *= 2) {
            const FloatImage& half = levels_.back();
            FloatImage next(lines.width(), lines.height());
            for (int y = 0; y < lines.height(); ++y) {
                for (int x = 0; x < lines.width(); ++x) {
                    const int other = x + length / 2;
                    const int end = wraps ? other % lines.width() : std::min(other, lines.width() - 1);
                    next(x, y) = std::min(half(x, y), half(end, y));
                }
            }
            levels_.push_back(std::move(next));
        }
    }

    // The minimum over the indices first .. last of a line, first in [0, width), last >= first.
    float least(int line, int first, int last) const {
        const int width = levels_.front().width();
        const int count = std::min(last - first + 1, width);
        const int level = static_cast<int>(std::bit_width(static_cast<unsigned>(count))) - 1;
        const FloatImage& table = levels_[static_cast<std::size_t>(level)];
        const int second = (first + count - (1 << level)) % width;
        return std::min(table(first, line), table(second, line));
    }

  private:
    std::vector<FloatImage> levels_;
};

}  // namespace relief
