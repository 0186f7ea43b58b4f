// Every value of a conservative map held against a bound that is computed here anew, by other means than the builders:
// max-pyramid searches for distances (which are built by envelopes and sorted offsets), plain scans for horizons,
// angles by atan2 for sectors. A value that keeps its bound is proven: no ray that the map serves is led past the
// surface by it. One that does not is unproven, and mostly wrong.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "relief/maps/cone_map.h"
#include "relief/maps/distance_map.h"

namespace relief {

// A value that does not keep its bound.
struct BrokenBound {
    // Free: a voxel that must be marked is walked as free. Distance: larger than the bound. Apex: lower than the
    // 3 x 3 cells. Slope: a cell stands out of the cone. NotANumber.
    enum class What : std::uint8_t { Free, Distance, Apex, Slope, NotANumber };
    What what = What::Distance;
    int i = 0;  // voxel (i, j, k), or cell (i, j) of cell_grid.h, from 0
    int j = 0;
    int k = 0;
    int sector = 0;
    double stored = 0;
    double bound = 0;  // distances: at most; apex and slopes: at least
    int cellX = 0;     // the cell that sets the bound, beside (i, j): under repeat perhaps in another period
    int cellY = 0;

    bool operator==(const BrokenBound&) const = default;
};

struct BoundCheck {
    std::uint64_t values = 0;  // looked at: all there are; marks are safe by themselves
    std::uint64_t broken = 0;
    std::vector<BrokenBound> first;  // in the order of rows; no more than kBrokenKept
};
inline constexpr std::size_t kBrokenKept = 64;

// map: euclidean-conservative or refined, of this field (asserted); whatever values it holds. The bound of refined maps
// is the one that DistanceMap's voxel form promises, from their own flattest ray and horizon sectors. In parallel, with
// progress; throws Cancelled.
BoundCheck checkDistanceBounds(const DistanceMap& map, const HeightField& field, Work& work);
// map: the conservative kind.
BoundCheck checkConeBounds(const ConeMap& map, const HeightField& field, Work& work);

// "voxel (3, 4, 5), azimuth sector 0: distance 3.25, at most 3.125 by cell (2, 7)". Cells and voxels as logs name them.
std::string brokenBoundText(const BrokenBound& broken, const HeightField& field);

}  // namespace relief
