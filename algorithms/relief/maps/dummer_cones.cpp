// Dummer's cones, by branch and bound over the max pyramid of the texels.
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "images/pyramid.h"
#include "relief/maps/cone_builders.h"

namespace relief {

namespace {

// Searches the nodes of a pyramid around one texel. Texels count from 0 in one period; those of other periods are
// shifted copies.
class DummerSearch {
  public:
    DummerSearch(const Pyramid& pyramid, bool wraps)
        : pyramid_(pyramid),
          wraps_(wraps),
          width_(pyramid.level(0).width()),
          height_(pyramid.level(0).height()),
          reach_(std::hypot(width_, height_)) {}

    // The texel that determines a slope, in any period.
    struct Seed {
        int x = 0;
        int y = 0;
        bool known = false;
    };

    // kappa of the texel (x, y). seed: the texel that determined a neighbour, which probably determines this one and
    // prunes the search; receives the one that determines this texel.
    double slope(int x, int y, Seed& seed) const {
        const int around = wraps_ ? 1 : 0;
        const float apex = pyramid_.level(0)(x, y);
        double kappa = 0;
        if (const Seed before = seed; before.known) {
            const int i = ((before.x % width_) + width_) % width_;
            const int j = ((before.y % height_) + height_) % height_;
            visit(x, y, apex, 0, i, j, before.x - i, before.y - j, kappa, seed);
        }
        // The own period first: its results prune the others.
        visit(x, y, apex, pyramid_.levels() - 1, 0, 0, 0, 0, kappa, seed);
        for (int py = -around; py <= around; ++py) {
            for (int px = -around; px <= around; ++px) {
                if (px == 0 && py == 0) continue;
                visit(x, y, apex, pyramid_.levels() - 1, 0, 0, px * width_, py * height_, kappa, seed);
            }
        }
        return kappa;
    }

  private:
    void visit(int x, int y, float apex, int level, int i, int j, int shiftX, int shiftY, double& kappa,
               Seed& seed) const {
        const float highest = pyramid_.level(level)(i, j);
        if (highest <= apex) return;
        // Relative to the texel: [x0, x1) x [y0, y1).
        const int x0 = (i << level) + shiftX - x;
        const int x1 = std::min((i + 1) << level, width_) + shiftX - x;
        const int y0 = (j << level) + shiftY - y;
        const int y1 = std::min((j + 1) << level, height_) + shiftY - y;
        const double dx = std::max({0, x0, 1 - x1});
        const double dy = std::max({0, y0, 1 - y1});
        const double away = std::sqrt(dx * dx + dy * dy);
        const double rise = static_cast<double>(highest) - static_cast<double>(apex);
        if (away >= reach_ || rise <= kappa * away) return;
        if (level == 0) {
            if (away == 0) return;
            kappa = rise / away;
            seed = {x0 + x, y0 + y, true};
            return;
        }
        const FloatImage& below = pyramid_.level(level - 1);
        // Nearer children first.
        const int nearX = x0 + x1 > 0 ? 0 : 1;
        const int nearY = y0 + y1 > 0 ? 0 : 1;
        for (int n = 0; n < 4; ++n) {
            const int ci = 2 * i + (nearX ^ (n & 1));
            const int cj = 2 * j + (nearY ^ (n >> 1));
            if (ci < below.width() && cj < below.height()) {
                visit(x, y, apex, level - 1, ci, cj, shiftX, shiftY, kappa, seed);
            }
        }
    }

    const Pyramid& pyramid_;
    bool wraps_;
    int width_;
    int height_;
    double reach_;
};

}  // namespace

void dummerCones(const HeightField& field, UnfilledVector<float>& slopes, Work& work) {
    const Pyramid pyramid(PyramidKind::Max, field.heights(), work);
    const DummerSearch search(pyramid, field.address() == Address::Repeat);
    work.progress().begin("map cone-dummer", field.height());
    parallelFor(work, field.height(), [&](int y) {
        DummerSearch::Seed seed;
        for (int x = 0; x < field.width(); ++x) {
            slopes[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.width()) +
                   static_cast<std::size_t>(x)] = static_cast<float>(search.slope(x, y, seed));
        }
        work.progress().advance();
    });
}

}  // namespace relief
