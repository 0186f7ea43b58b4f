// What the builders of cone maps have in common. Each fills slopes layer by layer, row by row.
#pragma once

#include <vector>

#include "relief/maps/cone_map.h"

namespace relief {

// How much steeper a conservative cone may be stored than it must be, as a share: the search stops at bounds this near
// to the steepest cell found. Rays of 10 degrees and more take 0.1 to 0.6% more steps for it (256 x 256 and 1024 x
// 1024).
inline constexpr double kConeSlack = 0.01;
// kappa of every cell, all sectors; at least what is needed, at most 1 + slack times that. apex: A of each cell.
// Near cells are all looked at, in lanes (cone_strip.h). Beyond, branch and bound over the max pyramid, for blocks of
// cells first: a node is opened only if its maximum at the least gap, and its plane (cone_planes.h), could steepen a
// slope. After Valasek & Ban 2022; the near cells, planes and blocks are additions.
void conservativeCones(const HeightField& field, int sectors, double slack, std::vector<float>& apex,
                       std::vector<float>& slopes, Work& work);
// The same between texel centres, without a guard: (h_q - h_p) / |q - p|.
void dummerCones(const HeightField& field, std::vector<float>& slopes, Work& work);
// Policarpo & Oliveira: along sampled azimuths, for each texel seen from above the apex, where the ray through it
// comes out of the surface again; the least ratio of way to height.
void relaxedCones(const HeightField& field, int directions, int radius, std::vector<float>& slopes, Work& work);

}  // namespace relief
