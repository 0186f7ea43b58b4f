// Compares every value of a conservative map with a bound that is computed here by other means than in the builders:
// max-pyramid searches for distances (which are built from envelopes and sorted offsets), plain scans for horizons, and
// atan2 for sectors. A value that keeps its bound is proven safe: it leads no ray that the map serves past the surface.
// A value that does not is unproven, and usually wrong.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "relief/maps/cone_map.h"
#include "relief/maps/distance_map.h"

namespace relief {

// A value that does not keep its bound.
struct BrokenBound {
    // Free: a voxel is free of surface according to the map but must be marked. Distance: larger than the bound. Apex:
    // lower than the highest of the 3 x 3 cells. Slope: a cell stands out of the cone. NotANumber: the value is NaN, or
    // negative in a cone map.
    enum class What : std::uint8_t { Free, Distance, Apex, Slope, NotANumber };
    What what = What::Distance;
    int i = 0;  // voxel (i, j, k), or cell (i, j) of cell_grid.h, counted from 0
    int j = 0;
    int k = 0;
    int sector = 0;
    double stored = 0;
    double bound = 0;  // distances: upper bound; apex and slopes: lower bound
    int cellX = 0;     // the cell that sets the bound; under repeat possibly in another period
    int cellY = 0;

    bool operator==(const BrokenBound&) const = default;
};

struct BoundCheck {
    std::uint64_t values = 0;  // number of values checked, which is all of them; marks are safe by themselves
    std::uint64_t broken = 0;
    std::vector<BrokenBound> first;  // in the order of rows, at most kBrokenKept
};
inline constexpr std::size_t kBrokenKept = 64;

// Checks a euclidean-conservative or refined map of this field (asserted), whatever values it holds. The bound of
// refined maps is the one that DistanceMap's voxel form guarantees, for the map's own flattest ray and horizon sectors.
// Runs in parallel and reports progress; throws Cancelled.
BoundCheck checkDistanceBounds(const DistanceMap& map, const HeightField& field, Work& work);
// Checks a conservative cone map; otherwise as checkDistanceBounds().
BoundCheck checkConeBounds(const ConeMap& map, const HeightField& field, Work& work);

// Describes a broken bound, such as "voxel (3, 4, 5), azimuth sector 0: distance 3.25, at most 3.125 by cell (2, 7)".
// Cells and voxels have the indices that logs use.
std::string brokenBoundText(const BrokenBound& broken, const HeightField& field);

}  // namespace relief
