#include "panes/trace/visible_region.h"

#include <cmath>
#include <map>

namespace reliefui {

namespace {

// The grid is surrounded by a border of negative values, so that every polygon is closed.
class Marching {
  public:
    Marching(int columns, int rows, const std::function<double(double, double)>& value)
        : columns_(columns + 3),
          rows_(rows + 3),
          exact_(value),
          value_(static_cast<std::size_t>(columns_ * rows_), -1) {
        for (int j = 0; j <= rows; ++j) {
            for (int i = 0; i <= columns; ++i) {
                const double v = value(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
                value_[index(i + 1, j + 1)] = std::isnan(v) ? -1 : v;
            }
        }
        for (int j = 0; j + 1 < rows_; ++j) {
            for (int i = 0; i + 1 < columns_; ++i) addCell(i, j);
        }
    }

    std::vector<std::vector<Point>> polygons() {
        std::vector<std::vector<Point>> all;
        while (!next_.empty()) {
            std::vector<Point> polygon;
            for (auto piece = next_.begin(); piece != next_.end();) {
                polygon.push_back(crossing(piece->first));
                const int to = piece->second;
                next_.erase(piece);
                piece = next_.find(to);
            }
            if (polygon.size() > 2) all.push_back(std::move(polygon));
        }
        return all;
    }

  private:
    std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * columns_ + i); }
    double at(int i, int j) const { return value_[index(i, j)]; }
    // Numbers of the edges from (i, j) to the right and downwards.
    int rightEdge(int i, int j) const { return 2 * (j * columns_ + i); }
    int downEdge(int i, int j) const { return 2 * (j * columns_ + i) + 1; }

    // Adds the pieces of the region's border in a cell. A piece begins where a walk around the cell's corners leaves
    // the region; the walk around the neighbour enters it there, so each crossing begins one piece and ends another.
    void addCell(int i, int j) {
        const bool in[4] = {at(i, j) > 0, at(i + 1, j) > 0, at(i + 1, j + 1) > 0, at(i, j + 1) > 0};
        const int edge[4] = {rightEdge(i, j), downEdge(i + 1, j), rightEdge(i, j + 1), downEdge(i, j)};
        // Two opposite corners may be positive; they are joined if the middle is.
        const bool joined = at(i, j) + at(i + 1, j) + at(i + 1, j + 1) + at(i, j + 1) > 0;
        for (int k = 0; k < 4; ++k) {
            if (!in[k] || in[(k + 1) % 4]) continue;
            // Once around the outer corners if joined, otherwise around the inner ones, to the next crossing.
            int to = k;
            do {
                to = joined ? (to + 1) % 4 : (to + 3) % 4;
            } while (in[to] == in[(to + 1) % 4]);
            next_[edge[k]] = edge[to];
        }
    }

    Point crossing(int edge) const {
        const int node = edge / 2;
        const int i = node % columns_, j = node / columns_;
        const bool right = edge % 2 == 0;
        const int i1 = i + (right ? 1 : 0), j1 = j + (right ? 0 : 1);
        const auto outside = [&](int a, int b) { return a == 0 || b == 0 || a == columns_ - 1 || b == rows_ - 1; };
        const auto place = [&](double f) {
            return Point{(i + f * (i1 - i) - 1) / (columns_ - 3), (j + f * (j1 - j) - 1) / (rows_ - 3)};
        };
        if (outside(i, j)) return place(1);
        if (outside(i1, j1)) return place(0);
        // By halving, since the values may jump: at the border of what something else hides.
        constexpr int kHalvings = 8;
        const bool first = at(i, j) > 0;
        double low = 0, high = 1;
        for (int n = 0; n < kHalvings; ++n) {
            const double middle = (low + high) / 2;
            const Point p = place(middle);
            ((exact_(p.x, p.y) > 0) == first ? low : high) = middle;
        }
        return place((low + high) / 2);
    }

    int columns_, rows_;  // of nodes, with the border
    const std::function<double(double, double)>& exact_;
    std::vector<double> value_;
    std::map<int, int> next_;  // from the edge where a piece begins to where it ends
};

}  // namespace

std::vector<std::vector<Point>> positiveRegion(int columns, int rows,
                                               const std::function<double(double, double)>& value) {
    return Marching(columns, rows, value).polygons();
}

}  // namespace reliefui
