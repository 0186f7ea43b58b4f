#include "relief/maps/robust_cones.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "base/parallel.h"
#include "relief/maps/maxima_around.h"

namespace relief {

namespace {

// Bit of the quadrant that extends from a texel towards (sx, sy), each -1 or 1.
unsigned quadrant(int sx, int sy) {
    return 1U << ((sx > 0 ? 1 : 0) + (sy > 0 ? 2 : 0));
}

// The quadrants of a texel in which the surface falls away from it.
std::uint8_t fallsAt(const HeightField& field, int x, int y) {
    unsigned falls = 0;
    const float here = field.texel(x, y);
    for (const int sx : {-1, 1}) {
        for (const int sy : {-1, 1}) {
            const float across = field.texel(x + sx, y), down = field.texel(x, y + sy);
            const float opposite = field.texel(x + sx, y + sy);
            if (here > across || here > down || across > opposite || down > opposite) falls |= quadrant(sx, sy);
        }
    }
    return static_cast<std::uint8_t>(falls);
}

// Searches rings of texels around an apex, nearest first.
class FallingEdges {
  public:
    FallingEdges(const HeightField& field, Work& work) : field_(field), falls_(field.width(), field.height()) {
        for (const float h : field.heights().pixels()) highest_ = std::max(highest_, h);
        parallelFor(work, field.height(), [&](int y) {
            for (int x = 0; x < field.width(); ++x) falls_(x, y) = fallsAt(field, x, y);
        });
    }

    double slope(int x, int y, int radius) const {
        const auto apex = static_cast<double>(field_.texel(x, y));
        const double rise = static_cast<double>(highest_) - apex;
        double slope = 0;
        for (int r = 1; r <= radius && rise > slope * r; ++r) {
            for (int n = -r; n <= r; ++n) {
                raise(x, y, n, -r, apex, slope), raise(x, y, n, r, apex, slope);
                if (std::abs(n) < r) raise(x, y, -r, n, apex, slope), raise(x, y, r, n, apex, slope);
            }
        }
        return slope;
    }

  private:
    void raise(int x, int y, int dx, int dy, double apex, double& slope) const {
        const int i = addressIndex(x + dx, field_.width(), field_.address());
        const int j = addressIndex(y + dy, field_.height(), field_.address());
        const double rise = static_cast<double>(field_.heights()(i, j)) - apex;
        const double away = std::hypot(dx, dy);
        if (!(rise > slope * away)) return;
        unsigned behind = 0;
        for (const int sx : {-1, 1}) {
            for (const int sy : {-1, 1}) {
                if (sx * dx >= 0 && sy * dy >= 0) behind |= quadrant(sx, sy);
            }
        }
        if ((falls_(i, j) & behind) != 0) slope = rise / away;
    }

    const HeightField& field_;
    Image<std::uint8_t> falls_;
    float highest_ = 0;
};

}  // namespace

FloatImage robustRelaxedCones(const HeightField& field, int radius, Work& work) {
    const FallingEdges edges(field, work);
    const int reach = std::min(radius, std::max(field.width(), field.height()));
    FloatImage own(field.width(), field.height());
    work.progress().begin("map relaxed-cone-robust", field.height());
    parallelFor(work, field.height(), [&](int y) {
        for (int x = 0; x < field.width(); ++x) own(x, y) = static_cast<float>(edges.slope(x, y, reach));
        work.progress().advance();
    });
    return maximaAround(own, field.address(), work);
}

}  // namespace relief
