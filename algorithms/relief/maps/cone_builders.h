// What the builders of cone maps have in common. Each fills slopes layer by layer, row by row.
#pragma once

#include <vector>

#include "relief/maps/cone_map.h"

namespace relief {

// How much steeper a conservative cone may be stored than it must be, as a share.
inline constexpr double kConeSlack = 0.01;
// kappa of every cell, all sectors; at least what is needed, at most 1 + slack times that. apex: A of each cell.
void conservativeCones(const HeightField& field, int sectors, double slack, std::vector<float>& apex,
                       std::vector<float>& slopes, Work& work);
// The same between texel centres, without a guard: (h_q - h_p) / |q - p|.
void dummerCones(const HeightField& field, std::vector<float>& slopes, Work& work);
// Policarpo & Oliveira: along sampled azimuths, for each texel seen from above the apex, where the ray through it
// comes out of the surface again; the least ratio of way to height.
void relaxedCones(const HeightField& field, int directions, int radius, std::vector<float>& slopes, Work& work);

}  // namespace relief
