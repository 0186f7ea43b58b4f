// MIP pyramids of any size: mean (weighted by area), maximum, minimum. [MIP18], figs. 2 and 3.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "relief/image.h"
#include "relief/work.h"

namespace relief {

enum class PyramidKind : std::uint8_t { Mean, Max, Min };

// Level 0 is the picture itself; each further level halves the size, rounded up, down to 1 x 1. A texel of level l
// covers the 2^l x 2^l texels of level 0 below it, clipped at the last row and column. Means are weighted by the number
// of texels covered, so the 1 x 1 level is the mean of the picture.
class Pyramid {
  public:
    Pyramid() = default;
    // Builds the pyramid in parallel over rows. The result has the same bits for any number of threads. Throws
    // Cancelled.
    Pyramid(PyramidKind kind, FloatImage base, Work& work)
        : Pyramid(kind, std::make_shared<const FloatImage>(std::move(base)), work) {
        ownsBase_ = true;
    }
    // As above, but shares level 0 with its other owners.
    Pyramid(PyramidKind kind, std::shared_ptr<const FloatImage> base, Work& work);

    // Returns the pyramid of a picture that differs from `before`'s level 0 in some texels. Recomputes only the texels
    // above the changed ones, and shares levels in which nothing changes. The result has the same bits as a newly built
    // one. Meant for few changed texels: each mean reads all the texels that it covers.
    static Pyramid edited(const Pyramid& before, std::shared_ptr<const FloatImage> base);
    static Pyramid edited(const Pyramid& before, FloatImage base);

    PyramidKind kind() const { return kind_; }
    int levels() const { return static_cast<int>(levels_.size()); }
    const FloatImage& level(int l) const { return *levels_[static_cast<std::size_t>(l)]; }
    // Memory of the levels in bytes. Level 0 counts unless it is shared.
    std::size_t bytes() const;

    // Number of levels of a w x h picture: 1 for 1 x 1. w, h >= 1.
    static int levelCount(int width, int height);

  private:
    PyramidKind kind_ = PyramidKind::Max;
    std::vector<std::shared_ptr<const FloatImage>> levels_;
    bool ownsBase_ = false;
};

// Number of texels of level 0, `size` along one axis, below texel i of level l.
inline std::int64_t coveredTexels(std::int64_t i, int l, std::int64_t size) {
    return std::min(size, (i + 1) << l) - (i << l);
}

}  // namespace relief
