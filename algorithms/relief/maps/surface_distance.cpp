#include "relief/maps/surface_distance.h"

#include <cmath>
#include <limits>

#include "relief/leaf.h"

namespace relief {

namespace {

double squared(double x) {
    return x * x;
}

struct Side {
    double low;
    double high;
};

double gap(double x, Side side) {
    return std::max({side.low - x, x - side.high, 0.0});
}

// The squared distance of (a, b, z) to the patch h00 + hu u + hv v + huv u v over its sides, as a function of v: the
// minimum over u in closed form, since it is a parabola in u.
struct PatchDistance {
    double a, b;
    double e, eu, ev, euv;  // D (h - z) = e + eu u + ev v + euv u v
    Side u;

    double bestU(double v) const {
        const double slope = eu + euv * v;
        return std::clamp((a - slope * (e + ev * v)) / (1 + slope * slope), u.low, u.high);
    }
    double at(double v) const {
        const double best = bestU(v);
        return squared(best - a) + squared(v - b) + squared(e + ev * v + (eu + euv * v) * best);
    }
};

// The v at which the distance to the patch is smallest. Sampled first, because the function has several local minima
// where the patch is twisted.
double leastV(const PatchDistance& patch, Side v) {
    constexpr int kSamples = 5;
    constexpr int kNarrowings = 22;  // golden-section steps: to 1e-5 of the side
    const double middle = std::clamp(patch.b, v.low, v.high);
    // An unbounded side belongs to a rim on which the height is constant.
    if (!std::isfinite(v.low) || !std::isfinite(v.high)) return middle;
    double best = patch.at(middle);
    const double spacing = (v.high - v.low) / (kSamples - 1);
    double at = middle;
    for (int n = 0; n < kSamples; ++n) {
        const double sample = v.low + n * spacing;
        const double value = patch.at(sample);
        if (value < best) best = value, at = sample;
    }
    constexpr double kGolden = 0.6180339887498949;
    double low = std::max(at - spacing, v.low);
    double high = std::min(at + spacing, v.high);
    double left = high - kGolden * (high - low);
    double right = low + kGolden * (high - low);
    double atLeft = patch.at(left);
    double atRight = patch.at(right);
    for (int n = 0; n < kNarrowings; ++n) {
        if (atLeft < atRight) {
            high = right, right = left, atRight = atLeft;
            left = high - kGolden * (high - low);
            atLeft = patch.at(left);
        } else {
            low = left, left = right, atLeft = atRight;
            right = low + kGolden * (high - low);
            atRight = patch.at(right);
        }
    }
    if (best <= std::min(atLeft, atRight)) return at;
    return atLeft < atRight ? left : right;
}

}  // namespace

SurfaceDistance::SurfaceDistance(HeightField field, std::shared_ptr<const MaxPyramidMap> maxima)
    : field_(std::move(field)), maxima_(std::move(maxima)), grid_(field_), slab_(field_.slabTexels()) {}

double SurfaceDistance::lowerBound(const Node& node, const Point& p) const {
    const auto side = [&](const GridAxis& axis, int index, std::int64_t base) {
        const int first = index << node.level;
        return Side{axis.edge(first, base), axis.edge(std::min(first + (1 << node.level), axis.cells), base)};
    };
    const auto highest = static_cast<double>(maxima_->pyramid.level(node.level)(node.i, node.j));
    return squared(gap(p.x, side(grid_.x, node.i, node.baseX))) + squared(gap(p.y, side(grid_.y, node.j, node.baseY))) +
           squared(std::max(p.z - highest, 0.0) * slab_);
}

SurfaceDistance::Best SurfaceDistance::patch(const Node& cell, const Point& p) const {
    const auto [h00, h10, h01, h11] = cellCorners(field_.heights(), grid_, cell.i, cell.j);
    const auto x = static_cast<double>(cell.baseX + cell.i);
    const auto y = static_cast<double>(cell.baseY + cell.j);
    const PatchDistance patch{p.x - x,
                              p.y - y,
                              slab_ * (h00 - p.z),
                              slab_ * (h10 - h00),
                              slab_ * (h01 - h00),
                              slab_ * ((h11 - h10) - (h01 - h00)),
                              {grid_.x.edge(cell.i, cell.baseX) - x, grid_.x.edge(cell.i + 1, cell.baseX) - x}};
    const double v = leastV(patch, {grid_.y.edge(cell.j, cell.baseY) - y, grid_.y.edge(cell.j + 1, cell.baseY) - y});
    return {patch.at(v), x + patch.bestU(v), y + v};
}

// For a column the lower bound is its distance.
SurfaceDistance::Best SurfaceDistance::column(const Node& cell, const Point& p) const {
    const double x = std::clamp(p.x, grid_.x.edge(cell.i, cell.baseX), grid_.x.edge(cell.i + 1, cell.baseX));
    const double y = std::clamp(p.y, grid_.y.edge(cell.j, cell.baseY), grid_.y.edge(cell.j + 1, cell.baseY));
    return {lowerBound(cell, p), x, y};
}

void SurfaceDistance::visit(const Node& node, const Point& p, Best& best) const {
    if (!(lowerBound(node, p) < best.squared)) return;
    if (node.level == 0) {
        const Best found = field_.surface() == Surface::Columns ? column(node, p) : patch(node, p);
        if (found.squared < best.squared) best = found;
        return;
    }
    const FloatImage& children = maxima_->pyramid.level(node.level - 1);
    // Nearest child first.
    const int half = 1 << (node.level - 1);
    const bool right = p.x >= static_cast<double>(node.baseX + (std::int64_t{node.i} << node.level) + half);
    const bool below = p.y >= static_cast<double>(node.baseY + (std::int64_t{node.j} << node.level) + half);
    for (int n = 0; n < 4; ++n) {
        const int i = 2 * node.i + ((n & 1) != 0 ? !right : right);
        const int j = 2 * node.j + ((n & 2) != 0 ? !below : below);
        if (i < children.width() && j < children.height()) {
            visit({node.level - 1, i, j, node.baseX, node.baseY}, p, best);
        }
    }
}

SurfaceDistance::Nearest SurfaceDistance::nearest(double s, double t, double z, double known) const {
    const double drop = (z - field_.at(s, t)) * slab_;
    if (drop <= 0) return {0, s, t, z};
    const double start = std::min(drop, known);
    const Point p{s + grid_.x.shift, t + grid_.y.shift, z};
    Best best{squared(start), p.x, p.y};
    const int top = maxima_->top();
    const auto periods = [&](const GridAxis& axis, double x) {
        if (!axis.wraps) return std::pair<std::int64_t, std::int64_t>(0, 0);
        return std::pair(static_cast<std::int64_t>(std::floor((x - start) / axis.cells)),
                         static_cast<std::int64_t>(std::floor((x + start) / axis.cells)));
    };
    const auto [firstX, lastX] = periods(grid_.x, p.x);
    const auto [firstY, lastY] = periods(grid_.y, p.y);
    for (std::int64_t m = firstY; m <= lastY; ++m) {
        for (std::int64_t n = firstX; n <= lastX; ++n) {
            visit({top, 0, 0, n * grid_.x.cells, m * grid_.y.cells}, p, best);
        }
    }
    // The nearest point of a column is on its top, or on its wall at the height of the point.
    const double rise = std::sqrt(std::max(best.squared - squared(best.x - p.x) - squared(best.y - p.y), 0.0));
    return {std::sqrt(best.squared), best.x - grid_.x.shift, best.y - grid_.y.shift, slab_ > 0 ? z - rise / slab_ : z};
}

}  // namespace relief
