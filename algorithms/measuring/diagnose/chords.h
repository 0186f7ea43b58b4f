// The intervals in which a ray is below the surface.
#pragma once

#include <vector>

#include "relief/height_field.h"
#include "relief/ray.h"

namespace relief {

// lambda of the ray's way into the surface and out of it; depth: the largest height of the surface above the ray in
// between.
struct Chord {
    double in = 0;
    double out = 1;
    double depth = 0;
};

// Returns the intervals from `first`, the first hit, to the bottom of the slab. The first begins at `first`; further
// ones are found if they are longer than a sixteenth of a texel. Cost: sixteen heights per texel of the ray's run.
std::vector<Chord> solidChords(const HeightField& field, const ViewRay& ray, double first);

// Largest error of a right answer, texels, and what barely touching means: the ray is nowhere deeper in the surface,
// heights.
inline constexpr double kRightTexels = 1.0 / 32;
inline constexpr double kTouchDepth = 2e-4;

// Returns true if an answer differs from the first hit only because the ray barely touches the surface that it passed,
// or leaves it nearly parallel. chords: solidChords() of the ray; run: by which errors are measured, texels.
bool barelyTouches(const HeightField& field, const ViewRay& ray, const std::vector<Chord>& chords, const Hit& answer,
                   double run);

}  // namespace relief
