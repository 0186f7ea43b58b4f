// The apexes of some rows of cells, and the slopes that near cells require, all of which are examined by SIMD. The
// first part of the search for conservative cones.
#pragma once

#include <vector>

#include "relief/maps/cone_scene.h"
#include "relief/maps/conservative_cone_lanes.h"

namespace relief {

inline constexpr int kStripRows = 8;
// Cells that are examined on each side, along both axes.
inline constexpr int kNearCells = 24;

class ConeStrip {
  public:
    explicit ConeStrip(const ConeScene& scene);

    // Computes the rows y0 to y0 + kStripRows - 1, as far as they exist.
    void load(int y0);

    float apex(int x, int row) const { return apexes_[at(x, row)]; }
    // Largest slope that a near cell requires, in float: at most three units of 2^-24 too low.
    float slope(int sector, int x, int row) const { return slopes_[static_cast<std::size_t>(sector)][at(x, row)]; }

  private:
    std::size_t at(int x, int row) const {
        return static_cast<std::size_t>(row) * width_ + static_cast<std::size_t>(x);
    }

    const ConeScene& scene_;
    std::size_t width_;   // length of a row of apexes and slopes, in whole vectors
    std::size_t stride_;  // length of a row of cells
    std::vector<int> columns_;
    std::vector<float> cells_;  // -1: no cell
    std::vector<float> apexes_;
    std::vector<NearRings> rings_;  // of each sector
    std::vector<std::vector<float>> slopes_;
};

}  // namespace relief
