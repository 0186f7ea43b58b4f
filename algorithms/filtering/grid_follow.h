// Points whose hits follow from centres', in lanes, inside elliptical_grid.cpp, not for others: their places and
// footprints out of the differences of the centres round them, row after row of a tile's cells, without a ray, a slope
// or a division. Same bits on every instruction set.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "filtering/point_lattice.h"
#include "filtering/point_reader.h"

namespace relief {

// Cells, rows one after the other; kCellSlack more at the columns' ends.
struct FollowJob {
    const double *s = nullptr, *t = nullptr;  // of centres
    std::size_t row = 0, first = 0, last = 0;
    const std::uint16_t *asked = nullptr, *follows = nullptr;  // points' bits
    std::size_t point = 0, points = 0;                         // of the lattice
    std::size_t square = 0;                                    // PointLattice::squareOf
    std::array<double, 4> shares{};
    PointBlur blur;
    glm::dvec2 scale{1};
};

// Behind `out` the cells' points that are asked for and follow, with their slots: cell * points + point. Centres have
// the differences of their neighbours, the others the means and differences of the four centres round them.
void followPoints(const FollowJob& job, PointBlock& out, std::vector<std::uint32_t>& slots);

}  // namespace relief
