#include "filtering/point_lattice.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>

namespace relief {

namespace {

// Standard deviation of the pixel's weights at the points, and the distance at which they are cut off, in pixels. The
// latter is less than a cell and a half, as kLatticeHalo requires.
constexpr double kPointSigma = 0.545;
constexpr double kPointReach = 1.1;
// Size of a point's footprint over the points' spacing.
constexpr double kBlurPerSpacing = 0.295;
// Samples along each side of a pixel that determine the shape of the points' Voronoi cells.
constexpr int kShapeSide = 32;

double square(glm::dvec2 v) {
    return v.x * v.x + v.y * v.y;
}

// The square of the smallest distance between points of the lattice (k / points, k turn / points), modulo whole pixels.
double nearest(int points, int turn) {
    double least = 1;
    for (int k = 1; k < points; ++k) {
        const auto off = [&](int n) { return std::min(n % points, points - n % points) / static_cast<double>(points); };
        least = std::min(least, square({off(k), off(k * turn)}));
    }
    return least;
}

// Square root of a symmetric matrix with determinant 1.
PointBlur root(const PointBlur& m) {
    const double per = 1 / std::sqrt(m.xx + m.yy + 2);
    return {(m.xx + 1) * per, m.xy * per, (m.yy + 1) * per};
}

// Blur of determinant 1 whose elongation is the square root of that of a point's Voronoi cell.
PointBlur shapeOf(const std::vector<glm::dvec2>& points) {
    PointBlur second;
    for (int n = 0; n < kShapeSide * kShapeSide; ++n) {
        const glm::dvec2 place = (glm::dvec2(n % kShapeSide, n / kShapeSide) + 0.5) / double{kShapeSide};
        glm::dvec2 nearest(2);
        for (const glm::dvec2& point : points) {
            // The offset is taken modulo whole pixels.
            const glm::dvec2 off = place - point - glm::round(place - point);
            if (square(off) < square(nearest)) nearest = off;
        }
        second.xx += nearest.x * nearest.x, second.xy += nearest.x * nearest.y, second.yy += nearest.y * nearest.y;
    }
    const double per = 1 / std::sqrt(second.xx * second.yy - second.xy * second.xy);
    return root(root({second.xx * per, second.xy * per, second.yy * per}));
}

}  // namespace

PointLattice PointLattice::of(int points) {
    assert(points >= 2 && points <= kMostPoints);
    PointLattice lattice;
    int turn = 1;
    for (int n = 2; n < points; ++n) {
        if (nearest(points, n) > nearest(points, turn)) turn = n;
    }
    for (int k = 0; k < points; ++k) {
        const auto place = [&](int n) {
            const double at = n % points / static_cast<double>(points);
            return at > 0.5 ? at - 1 : at;
        };
        const glm::dvec2 at(place(k), place(k * turn));
        lattice.places.push_back(at);
        const double u = at.x < 0 ? at.x + 1 : at.x, v = at.y < 0 ? at.y + 1 : at.y;
        lattice.shares.push_back({(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v});
    }
    const PointBlur shape = shapeOf(lattice.places);
    const double blur = kBlurPerSpacing / std::sqrt(points);
    lattice.blur = {blur * shape.xx, blur * shape.xy, blur * shape.yy};
    for (int dy = -kLatticeHalo; dy <= kLatticeHalo; ++dy) {
        for (int dx = -kLatticeHalo; dx <= kLatticeHalo; ++dx) {
            for (int k = 0; k < points; ++k) {
                const double r2 = square(glm::dvec2(dx, dy) + lattice.places[static_cast<std::size_t>(k)]);
                if (r2 > kPointReach * kPointReach) continue;
                const double weight = std::exp(-r2 / (2 * kPointSigma * kPointSigma));
                lattice.terms.push_back({dx, dy, k, static_cast<float>(weight)});
                lattice.weights.push_back(lattice.terms.back().weight);
            }
        }
    }
    return lattice;
}

}  // namespace relief
