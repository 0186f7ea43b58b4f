// Answers that lie at equal layers of the slab.
#pragma once

#include "measuring/diagnose/answered_rays.h"

namespace relief {

// The error of lambda by sums in float, per layer that was passed.
inline constexpr double kFloatError = 2e-6;

// Largest number of layers that is looked for.
inline constexpr int kMostLayers = 512;

// The number of equal layers at which the answers lie, and by how much they lie behind them, lambda: the answers of a
// search without refinement. layers: 0 if they lie at none.
struct Lattice {
    int layers = 0;
    double phase = 0;
};

// Returns the smallest number of layers, up to kMostLayers, at which nearly all answers lie.
Lattice latticeOf(const AnsweredRays& given);

}  // namespace relief
