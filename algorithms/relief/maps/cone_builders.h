// Interface of the builders of cone maps. Each fills slopes layer by layer, row by row.
#pragma once

#include <vector>

#include "relief/maps/cone_map.h"

namespace relief {

// Fraction by which a conservative cone may be stored steeper than necessary: the search stops at bounds this close to
// the steepest cell found. Rays of 10 degrees and more take 0.1 to 0.6% more steps for it (256 x 256 and 1024 x 1024).
inline constexpr double kConeSlack = 0.01;
// Sets kappa of every cell in all sectors, at least the necessary value and at most 1 + slack times that. apex: A of
// each cell. All near cells are examined, by SIMD (cone_strip.h). Beyond them branch and bound over the max pyramid is
// used, first for blocks of cells: a node is opened only if its maximum at the smallest gap, and its plane
// (cone_planes.h), could steepen a slope. After Valasek & Ban 2022; near cells, planes and blocks are additions.
void conservativeCones(const HeightField& field, int sectors, double slack, UnfilledVector<float>& apex,
                       UnfilledVector<float>& slopes, Work& work);
// Dummer's cones between texel centres, without a safety margin: kappa is the maximum of (h_q - h_p) / |q - p|.
void dummerCones(const HeightField& field, UnfilledVector<float>& slopes, Work& work);
// Relaxed cones of Policarpo & Oliveira: along sampled azimuths, for each texel visible from above the apex, the place
// where the ray through it leaves the surface again; the smallest ratio of distance to height. By SIMD
// (relaxed_cone_lanes.h); the values are those of relaxedSlope(), rounded to float.
void relaxedCones(const HeightField& field, int directions, int radius, UnfilledVector<float>& slopes, Work& work);
// Returns the memory, in bytes, of the strips of heights that relaxedCones() holds with this number of threads.
std::uint64_t relaxedStripBytes(const HeightField& field, int radius, std::size_t threads);
// Reference: kappa of the texel (x, y), from all samples up to `reach` texels away. reach: the smaller of radius and
// the longer side of the map.
double relaxedSlope(const HeightField& field, int directions, int reach, int x, int y);

}  // namespace relief
