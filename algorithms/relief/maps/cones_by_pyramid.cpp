// The builders that search the max pyramid: conservative and Dummer's cones.
#include <algorithm>
#include <array>
#include <cmath>

#include <oneapi/tbb/parallel_for.h>

#include "relief/maps/azimuth_sectors.h"
#include "relief/maps/cone_builders.h"
#include "relief/maps/max_pyramid_map.h"

namespace relief {

namespace {

// Searches the nodes of a pyramid around one cell. Cells count from 0 in one period; others are shifted copies.
class ConeSearch {
  public:
    // centres: distances of centres instead of gaps. reach: farther cells are the guard's.
    // unbounded: the outermost cells have no outer edge (clamp).
    ConeSearch(const Pyramid& pyramid, bool wraps, bool unbounded, bool centres, double reach, int sectors)
        : pyramid_(pyramid),
          wraps_(wraps),
          unbounded_(unbounded),
          centres_(centres),
          reach_(reach),
          sectors_(sectors),
          width_(pyramid.level(0).width()),
          height_(pyramid.level(0).height()) {}

    // The cell that decided a sector, in any period.
    struct Seed {
        int x = 0;
        int y = 0;
        bool known = false;
    };
    using Seeds = std::array<Seed, kMaxSectors>;

    // kappa: one a sector, at least what it holds already. seeds: what decided a cell nearby is likely to decide this
    // one, and prunes the rest; then what decides this one.
    void search(int x, int y, float apex, double* kappa, Seeds& seeds) const {
        const int around = wraps_ ? 1 : 0;
        const Seeds before = seeds;
        for (std::size_t k = 0; k < static_cast<std::size_t>(sectors_.count()); ++k) {
            if (!before[k].known) continue;
            const int i = ((before[k].x % width_) + width_) % width_;
            const int j = ((before[k].y % height_) + height_) % height_;
            visit(x, y, apex, 0, i, j, before[k].x - i, before[k].y - j, kappa, seeds);
        }
        // The own period first: what it finds prunes the others.
        visit(x, y, apex, pyramid_.levels() - 1, 0, 0, 0, 0, kappa, seeds);
        for (int py = -around; py <= around; ++py) {
            for (int px = -around; px <= around; ++px) {
                if (px == 0 && py == 0) continue;
                visit(x, y, apex, pyramid_.levels() - 1, 0, 0, px * width_, py * height_, kappa, seeds);
            }
        }
    }

  private:
    struct Box {
        int x0, x1, y0, y1;  // relative to the cell: cells [x0, x1) x [y0, y1)
    };

    static int gap(int low, int high) { return std::max({0, low - 1, -high}); }

    // The least distance of the box's cells; 0 if it touches the 3 x 3 cells around (or the cell itself).
    double distance(const Box& box) const {
        if (centres_) {
            const int dx = std::max({0, box.x0, 1 - box.x1});
            const int dy = std::max({0, box.y0, 1 - box.y1});
            return std::sqrt(static_cast<double>(dx) * dx + static_cast<double>(dy) * dy);
        }
        const double dx = gap(box.x0, box.x1);
        const double dy = gap(box.y0, box.y1);
        return std::sqrt(dx * dx + dy * dy);
    }

    // Directions from the cell (x, y) to the box; under clamp the outermost cells reach to infinity.
    SectorSet sectorsOf(int x, int y, const Box& box) const {
        if (sectors_.count() == 1) return 1U;
        double x0 = box.x0 - 1;
        double x1 = box.x1;
        double y0 = box.y0 - 1;
        double y1 = box.y1;
        if (unbounded_) {
            constexpr double kFar = 1e9;
            if (x == width_ - 1 || box.x0 + x == 0) x0 = -kFar;
            if (x == 0 || box.x1 + x == width_) x1 = kFar;
            if (y == height_ - 1 || box.y0 + y == 0) y0 = -kFar;
            if (y == 0 || box.y1 + y == height_) y1 = kFar;
        }
        return sectors_.meeting(x0, x1, y0, y1);
    }

    void visit(int x, int y, float apex, int level, int i, int j, int shiftX, int shiftY, double* kappa,
               Seeds& seeds) const {
        const float highest = pyramid_.level(level)(i, j);
        if (highest <= apex) return;
        const Box box{(i << level) + shiftX - x, std::min((i + 1) << level, width_) + shiftX - x,
                      (j << level) + shiftY - y, std::min((j + 1) << level, height_) + shiftY - y};
        const double away = distance(box);
        if (away >= reach_) return;
        const SectorSet set = sectorsOf(x, y, box);
        const double rise = static_cast<double>(highest) - static_cast<double>(apex);
        bool matters = false;
        for (int k = 0; k < sectors_.count() && !matters; ++k) {
            matters = (set >> k & 1U) != 0 && rise > kappa[k] * away;
        }
        if (!matters) return;
        if (level == 0) {
            if (away == 0) return;  // the 3 x 3 cells, below the apex by its choice
            for (int k = 0; k < sectors_.count(); ++k) {
                if ((set >> k & 1U) == 0 || !(rise / away > kappa[k])) continue;
                kappa[k] = rise / away;
                seeds[static_cast<std::size_t>(k)] = {box.x0 + x, box.y0 + y, true};
            }
            return;
        }
        const FloatImage& below = pyramid_.level(level - 1);
        // The nearer children first.
        const int nearX = 2 * box.x0 + (box.x1 - box.x0) > 0 ? 0 : 1;
        const int nearY = 2 * box.y0 + (box.y1 - box.y0) > 0 ? 0 : 1;
        for (int n = 0; n < 4; ++n) {
            const int ci = 2 * i + (nearX ^ (n & 1));
            const int cj = 2 * j + (nearY ^ (n >> 1));
            if (ci < below.width() && cj < below.height()) {
                visit(x, y, apex, level - 1, ci, cj, shiftX, shiftY, kappa, seeds);
            }
        }
    }

    const Pyramid& pyramid_;
    bool wraps_;
    bool unbounded_;
    bool centres_;
    double reach_;
    AzimuthSectors sectors_;
    int width_;
    int height_;
};

template <class Body>
void overRows(const char* what, int rows, Work& work, const Body& body) {
    work.progress().begin(what, rows);
    work.arena().execute([&] {
        tbb::parallel_for(0, rows, [&](int y) {
            if (work.stopped()) return;
            body(y);
            work.progress().advance();
        });
    });
    work.throwIfStopped();
}

}  // namespace

void dummerCones(const HeightField& field, std::vector<float>& slopes, Work& work) {
    const Pyramid pyramid(PyramidKind::Max, field.heights(), work);
    const bool wraps = field.address() == Address::Repeat;
    const double reach = std::hypot(field.width(), field.height());
    const ConeSearch search(pyramid, wraps, false, true, reach, 1);
    overRows("map cone-dummer", field.height(), work, [&](int y) {
        ConeSearch::Seeds seeds;
        for (int x = 0; x < field.width(); ++x) {
            double kappa = 0;
            search.search(x, y, field.heights()(x, y), &kappa, seeds);
            slopes[static_cast<std::size_t>(y) * static_cast<std::size_t>(field.width()) +
                   static_cast<std::size_t>(x)] = static_cast<float>(kappa);
        }
    });
}

}  // namespace relief
