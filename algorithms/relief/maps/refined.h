// Builders of the refined distance maps: only rays that reach a voxel from above without having hit anything count.
// [DIST17] figs. 5 to 8, [TEX].
#pragma once

#include <vector>

#include "relief/maps/distance_map.h"

namespace relief {

// Largest and smallest height of the surface within each cell.
struct CellHeights {
    FloatImage highest;
    FloatImage lowest;

    CellHeights(const HeightField& field, Work& work);
};

// The same for nx x ny boxes of footprint x footprint cells, the last of a row clipped.
struct BoxHeights {
    FloatImage highest;
    FloatImage lowest;

    BoxHeights(const CellHeights& cells, int footprint, int nx, int ny, Work& work);
    // The mark of a box (StoredValues), or 0 if it is free.
    float mark(int bx, int by, int layer, int layers) const;
};

// The method of the papers: from each voxel's centre, `directions` rays distributed uniformly over the lower hemisphere
// (steeper than the flattest ray). Rays that are blocked before they reach the centre do not count. The result is the
// smallest distance to the surface along the others, so never below the Euclidean distance. Not safe: a ray visits
// points other than the centre, and directions in between may have nearer hits.
void refinedSampled(const DistanceMap& map, int nx, int ny, const HeightField& field, const ExactHits& exactHits,
                    UnfilledVector<float>& values, Work& work);
// A hit above a point by at most this lambda is the point itself on the surface.
inline constexpr double kReached = 1e-9;

// A direction of rays, and its length per unit of lambda in the map's metric.
struct SampledDirection {
    double a;
    double b;
    double length;
};
// Directions distributed uniformly over the lower hemisphere of the metric, from the flattest ray served downwards: a
// golden spiral.
std::vector<SampledDirection> sampledDirections(int count, double slabTexels, double maxRun);

// A bound for every point of a box and every admissible ray through it.
// Backward, for each of K azimuth sectors: the gates (grid lines behind the box) over which a ray from above must have
// passed. The smallest height g over the range in which it can have crossed the gate, within the horizontal distance
// tau, gives its smallest slope m_k = max((g - z1) / tau, m_min).
// Forward: D = min over cells q, and over the sectors k in which q is visible from the box, of sqrt(t^2 + max(z0 - H_q,
// t m_k, 0)^2), where t is the shortest distance from box to cell in that sector.
void refinedConservative(DistanceMap& map, int nx, int ny, const HeightField& field, const CellHeights& cells,
                         UnfilledVector<float>& values, Work& work);

}  // namespace relief
