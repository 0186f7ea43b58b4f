// Sample points that the pixels of a picture share: a lattice that is the same in every pixel and contains its centre.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace relief {

// Distance, in cells, from a pixel to the farthest cells with points that it sums.
inline constexpr int kLatticeHalo = 1;
inline constexpr int kMostPoints = 16;

// The blur of each point's footprint: its covariance is the square of this symmetric matrix, in pixels.
struct PointBlur {
    double xx = 0, xy = 0, yy = 0;
};

// The points of a lattice in a pixel, and the points of the surrounding cells that a pixel sums. Variances in pixels^2.
struct PointLattice {
    struct Term {
        int dx, dy;  // cells
        int point;
        float weight;
    };
    std::vector<glm::dvec2> places;  // offset from the cell's centre, each in (-1/2, 1/2]; the first is 0
    std::vector<Term> terms;
    std::vector<float> weights;  // Term::weight of each term
    PointBlur blur;
    // For each point, the interpolation weights of the four cell centres around it, row by row.
    std::vector<std::array<double, 4>> shares;

    // Offset, in cells, from the upper left of the four cells whose centres enclose the point to the point's own cell.
    // row: cells per row.
    std::ptrdiff_t squareOf(std::size_t point, std::ptrdiff_t row) const {
        return (places[point].x < 0 ? 1 : 0) + (places[point].y < 0 ? row : 0);
    }
    // Returns the lattice of `points` points per pixel (2 to kMostPoints) whose nearest points are farthest apart.
    static PointLattice of(int points);
};

}  // namespace relief
