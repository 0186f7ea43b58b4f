// Builders of the refined distance maps: only rays that reach a voxel from above without having hit anything count.
// [DIST17] figs. 5 to 8, [TEX].
#pragma once

#include <vector>

#include "relief/maps/distance_map.h"

namespace relief {

// Largest and smallest height that the surface reaches within each cell.
struct CellHeights {
    FloatImage highest;
    FloatImage lowest;

    explicit CellHeights(const HeightField& field);
};

// The same of nx x ny boxes of footprint x footprint cells, the last of a row clipped.
struct BoxHeights {
    FloatImage highest;
    FloatImage lowest;

    BoxHeights(const CellHeights& cells, int footprint, int nx, int ny);
    // The mark of a box, or 0 if it is free.
    float mark(int bx, int by, int layer, int layers) const;
};

// The papers' idea as it stands: from each voxel's centre, `directions` rays spread evenly over the half sphere below
// (steeper than the flattest); those that were blocked before they came there do not count. What is left is the least
// distance to the surface along them, so nowhere less than the Euclidean one. Not safe: a ray visits points beside the
// centre, and directions in between meet nearer hits.
void refinedSampled(const DistanceMap& map, int nx, int ny, const HeightField& field, const ExactHits& exactHits,
                    std::vector<float>& values, Work& work);
// A hit this little before a point's own height is the point's own place on the surface.
inline constexpr double kReached = 1e-9;

// A direction of rays, and the length of a unit of lambda along it in the map's metric.
struct SampledDirection {
    double a;
    double b;
    double length;
};
// Evenly over the half sphere below the horizontal of the metric, down from the flattest ray served: a golden spiral.
std::vector<SampledDirection> sampledDirections(int count, double slabTexels, double maxRun);

// A bound for every point of a box and every admissible ray through it.
// Backward, for each of K azimuth sectors: the gates (grid lines behind the box) that a ray from above must have
// passed over, the least height g over the stretch where it can have crossed, within the horizontal way tau, give its
// least slope m_k = max((g - z1) / tau, m_min).
// Forward: D = min over cells q, and over the sectors k in which q can be seen from the box, of
// sqrt(t^2 + max(z0 - H_q, t m_k, 0)^2), t the least way from box to cell in that sector.
void refinedConservative(DistanceMap& map, int nx, int ny, const HeightField& field, const CellHeights& cells,
                         std::vector<float>& values, Work& work);

}  // namespace relief
