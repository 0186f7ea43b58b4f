// Points that the pixels of a picture share: a lattice, the same in every pixel, its centre among them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace relief {

// Cells round a pixel within which its points lie.
inline constexpr int kLatticeHalo = 1;
inline constexpr int kMostPoints = 16;

// Of each point's footprint: its covariance is the square of this symmetric matrix, pixels.
struct PointBlur {
    double xx = 0, xy = 0, yy = 0;
};

// Points of a lattice in a pixel, and those that a pixel sums, of the cells around. Variances in pixels^2.
struct PointLattice {
    struct Term {
        int dx, dy;  // cells
        int point;
        float weight;
    };
    std::vector<glm::dvec2> places;  // from the cell's centre, (-1/2, 1/2] both; the first is the centre
    std::vector<Term> terms;
    std::vector<float> weights;  // the terms' own
    PointBlur blur;
    // Of the four centres round each point, row after row: what they count between them.
    std::vector<std::array<double, 4>> shares;

    // How many cells before a point's own, rows of so many, is the upper left of the four whose centres lie round it.
    std::ptrdiff_t squareOf(std::size_t point, std::ptrdiff_t row) const {
        return (places[point].x < 0 ? 1 : 0) + (places[point].y < 0 ? row : 0);
    }
    // points: 2 to kMostPoints. The lattice of so many points a pixel whose nearest points are farthest apart.
    static PointLattice of(int points);
};

}  // namespace relief
