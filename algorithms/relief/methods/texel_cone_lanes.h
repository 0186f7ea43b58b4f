// SIMD versions of the walks over one cone per texel, in double, one ray per lane; finished lanes are refilled.
// References: ConeTracer with layout=texel (from cell to cell; one kernel with its leaf in double) and ConeMarch (cones
// interpolated between texels: cone-dummer, relaxed-cone). They perform the operations of the references in the same
// order, so the results are the same bits for any target and vector width.
#pragma once

#include <cstddef>
#include <vector>

#include "relief/cell_grid.h"
#include "relief/maps/cone_map.h"
#include "relief/ray.h"

namespace relief {

struct ConeCellSearch {
    const HeightField& field;
    const CellGrid& grid;
    const ConeMap& map;
};
struct ConeMarchSearch {
    const HeightField& field;
    const ConeMap& map;
    int iterations;
    int bisections;
};

// Set hits for the rays first to last - 1; with segments, one per ray of the block, those of traceSegment(). Return the
// indices of rays that the reference has to trace: those flatter than the domain of exactness (cells), and those so
// distant that one product cannot subtract their period exactly (march). Require fitsLanes() of the map's slopes.
std::vector<std::size_t> coneCellsSimd(const ConeCellSearch& search, const RayBlock& rays, std::size_t first,
                                       std::size_t last, HitBlock& hits, const Segment* segments = nullptr);
std::vector<std::size_t> coneMarchSimd(const ConeMarchSearch& search, const RayBlock& rays, std::size_t first,
                                       std::size_t last, HitBlock& hits, const Segment* segments = nullptr);

}  // namespace relief
