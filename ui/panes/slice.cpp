#include "panes/slice.h"

#include <cmath>

#include "panes/ray_geometry.h"

namespace reliefui {

namespace {

using relief::GridRay;
using relief::PyramidNode;
using relief::PyramidWalk;

// Collects the points of a line, at most four per pixel column.
class Thinner {
  public:
    Thinner(const SliceRange& range, bool thin) : range_(range), thin_(thin) {}

    void add(double lambda, double height) {
        const Point p{lambda, height};
        if (!thin_) {
            points_.push_back(p);
            return;
        }
        const double place = (lambda - range_.from) / (range_.to - range_.from) * range_.columns;
        const double column = std::floor(place);
        if (column != column_) {
            close();
            column_ = column;
            first_ = low_ = high_ = last_ = p;
            return;
        }
        if (p.y < low_.y) low_ = p;
        if (p.y > high_.y) high_ = p;
        last_ = p;
    }

    std::vector<Point> take() {
        if (thin_) close();
        return std::move(points_);
    }

  private:
    void close() {
        if (column_ < 0) return;
        const bool lowFirst = low_.x <= high_.x;
        for (const Point& p : {first_, lowFirst ? low_ : high_, lowFirst ? high_ : low_, last_}) {
            if (points_.empty() || !(points_.back() == p)) points_.push_back(p);
        }
    }

    const SliceRange& range_;
    bool thin_;
    std::vector<Point> points_;
    double column_ = -1;
    Point first_, low_, high_, last_;
};

double cellsIn(const relief::ViewRay& ray, const SliceRange& range) {
    return (std::abs(ray.a) + std::abs(ray.b)) * (range.to - range.from);
}

// The node of `level` that contains the ray at and immediately after lambda.
PyramidNode nodeAt(const PyramidWalk& walk, const GridRay& ray, int level, double lambda) {
    PyramidNode node = walk.topNode(ray, lambda);
    for (int l = walk.top(); l > level; --l) node = walk.child(ray, l, node, lambda);
    return node;
}

// Lambda at which the ray entered the node along one axis.
double enterAt(const relief::GridAxis& axis, const relief::RayAxis& ray, int level, relief::AxisCell node) {
    const int low = node.index << level;
    return ray.enter(axis, low, std::min(low + (1 << level), axis.cells), node.base);
}

class Line {
  public:
    Line(const PyramidWalk& walk, const relief::ViewRay& ray, const SliceRange& range, bool thin)
        : walk_(walk), path_(walk.field(), ray), range_(range), out_(range, thin) {}

    double height(double lambda) const {
        const Point at = path_.at(lambda);
        return walk_.field().at(at.x, at.y);
    }
    void point(double lambda) { out_.add(lambda, height(lambda)); }
    // Adds one cell: a constant, or the parabola through three of its heights.
    void cell(const PyramidNode& node, double in, double out) {
        if (walk_.field().surface() == relief::Surface::Columns) {
            const auto top = static_cast<double>(walk_.maximum(0, node));
            out_.add(in, top);
            out_.add(out, top);
            return;
        }
        const double start = height(in);
        const double middle = height((in + out) / 2);
        const double end = height(out);
        // With n chords per cell, the error is the sagitta / n^2.
        constexpr double kOff = 0.25;  // in pixels
        constexpr double kMostPieces = 32;
        const double sagitta = std::abs(middle - (start + end) / 2) * range_.rows;
        const double wide = (out - in) / (range_.to - range_.from) * range_.columns;
        const double pieces =
            std::clamp(std::ceil(std::sqrt(sagitta / kOff)), 1.0, std::clamp(std::ceil(wide), 1.0, kMostPieces));
        out_.add(in, start);
        for (double n = 1; n < pieces; ++n) {
            const double w = n / pieces;
            const double bend = 4 * w * (1 - w) * (middle - (start + end) / 2);
            out_.add(in + w * (out - in), start + w * (end - start) + bend);
        }
        out_.add(out, end);
    }
    std::vector<Point> take() { return out_.take(); }

  private:
    const PyramidWalk& walk_;
    RayPath path_;
    const SliceRange& range_;
    Thinner out_;
};

}  // namespace

double surfaceAt(const relief::HeightField& field, const relief::ViewRay& ray, double lambda) {
    const Point at = RayPath(field, ray).at(lambda);
    return field.at(at.x, at.y);
}

double lambdaInside(const PyramidWalk& walk, const relief::ViewRay& viewRay) {
    if (!walk.grid().bounded) return 1;
    const GridRay ray(walk.grid(), viewRay);
    if (ray.entersOutside(walk.grid())) return 0;
    return std::clamp(walk.exit(ray, walk.top(), walk.topNode(ray, 0)).first(), 0.0, 1.0);
}

SurfaceLine surfaceAlong(const PyramidWalk& walk, const relief::ViewRay& viewRay, const SliceRange& range) {
    SurfaceLine line;
    SliceRange seen = range;
    seen.to = std::min(range.to, lambdaInside(walk, viewRay));
    if (!(seen.from < seen.to)) return line;
    const GridRay ray(walk.grid(), viewRay);
    constexpr double kDense = 3;  // cells per pixel
    const double cells = cellsIn(viewRay, seen);
    line.thinned = cells > kDense * range.columns;
    Line points(walk, viewRay, range, line.thinned);
    if (!ray.inDomain() || cells > kSliceCells) {
        const double count = std::max(1.0, kSliceCells / 2);
        for (double n = 0; n <= count; ++n) points.point(seen.from + (seen.to - seen.from) * n / count);
        line.points = points.take();
        return line;
    }
    PyramidNode node = nodeAt(walk, ray, 0, seen.from);
    double in = seen.from;
    for (;;) {
        const PyramidWalk::Exit exit = walk.exit(ray, 0, node);
        const double out = std::min(exit.first(), seen.to);
        if (out > in) {
            points.cell(node, in, out);
            in = out;
        }
        if (!(exit.first() < seen.to) || !walk.moveOn(ray, 0, exit, node)) break;
    }
    line.points = points.take();
    return line;
}

std::vector<Plateau> plateausAlong(const PyramidWalk& walk, const relief::ViewRay& viewRay, int level,
                                   const SliceRange& range) {
    std::vector<Plateau> plateaus;
    const GridRay ray(walk.grid(), viewRay);
    const double to = std::min(range.to, lambdaInside(walk, viewRay));
    const double texels = std::ldexp(cellsIn(viewRay, {range.from, to, 1, 1}), -level);
    if (!(range.from < to) || !ray.inDomain() || texels > kSliceCells) return plateaus;
    // Narrower ones could not be distinguished.
    constexpr double kPixels = 2;
    const double pixel = kPixels * (range.to - range.from) / range.columns;
    PyramidNode node = nodeAt(walk, ray, level, range.from);
    double in =
        std::max({0.0, enterAt(walk.grid().x, ray.x, level, node.x), enterAt(walk.grid().y, ray.y, level, node.y)});
    for (;;) {
        const PyramidWalk::Exit exit = walk.exit(ray, level, node);
        const double out = std::min(exit.first(), 1.0);
        if (out > in) {
            const double value = static_cast<double>(walk.maximum(level, node));
            const bool join =
                !plateaus.empty() && plateaus.back().texel.lambdaOut - plateaus.back().texel.lambdaIn < pixel;
            if (join) {
                Plateau& last = plateaus.back();
                last.joined = true;
                last.texel.lambdaOut = out;
                last.texel.value = std::max(last.texel.value, value);
            } else {
                plateaus.push_back({walk.record(relief::Decision::Start, level, node, in, out, value, out), false});
            }
            in = out;
        }
        if (!(exit.first() < to) || !walk.moveOn(ray, level, exit, node)) break;
    }
    return plateaus;
}

}  // namespace reliefui
