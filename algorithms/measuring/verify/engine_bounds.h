// Compares the cones of an engine's picture with the surface, independently of the builder of surface_cones.h.
#pragma once

#include <cstdint>
#include <optional>

#include "relief/height_field.h"
#include "relief/maps/engine_codes.h"
#include "relief/ray.h"
#include "relief/work.h"

namespace relief {

// A cell of cell_grid.h (in log names) in which the widest cone that a shader can fetch is not proven safe, because of
// another cell.
struct OpenBound {
    int x = 0;
    int y = 0;
    double slope = 0;   // the least slope that can be fetched there, heights per texel
    double needed = 0;  // the slope that would be proven safe
    int otherX = 0;
    int otherY = 0;
};

struct EngineBoundCheck {
    std::uint64_t cells = 0;
    std::uint64_t open = 0;  // cells without proof
    std::optional<OpenBound> first;
};

// Proves, cell by cell, that the loop of engine_march.h never passes the surface, however the four cones around a point
// are interpolated. Every point of a cell has a surface of at least the cell's lowest corner and a cone of at least the
// steepest of four texels' least slope; no other point of the surface may stand above that cone: neither by the highest
// corner and the distance of its cell, nor, if that does not suffice, by the steepest gradient in the square between.
// field: bilinear. Runs in parallel and reports progress; throws Cancelled.
EngineBoundCheck checkEngineCones(const HeightField& field, const FloatImage& codes, const ConeCoding& coding,
                                  Work& work);

// Texels whose own cone, in texels an ellipse where lengths are texture coordinates, holds another texel, and the rays
// that show it: each enters the slab above the texel and descends to just below the other's top, which the first step
// passes.
struct EngineViolations {
    std::uint64_t texels = 0;
    RayBlock rays;  // at most one per row of texels: that of the largest violation
};
EngineViolations violationsOfTexels(const HeightField& field, const FloatImage& codes, const ConeCoding& coding,
                                    double longestRun, Work& work);

// Values of a pyramid of maxima that are lower than a height below them.
struct LowMaxima {
    std::uint64_t values = 0;
    std::uint64_t low = 0;
    int level = 0, x = 0, y = 0;  // the first of them
    double stored = 0, height = 0;
};
// levels: heights as the engine decodes them; level 0 has the size of `heights`.
LowMaxima checkEngineMaxima(const FloatImage& heights, const std::vector<FloatImage>& levels, Work& work);

}  // namespace relief
