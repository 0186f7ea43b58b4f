// Bounds of the horizon towards a directional light, which decide most shadow queries without a ray.
//
// Frame: columns of cells (cell_grid.h) lie across the axis along which the light runs faster, and are numbered in the
// direction of the light; line l is the edge before column l. Strips, one cell wide, run along the light, so that a
// shadow ray stays in its strip. For each line and strip the map stores two heights: from `upper` on, no ray in the
// strip is blocked beyond the line by a part of the surface that rises faster than the light; below `lower` every ray
// is blocked there.
//
// Why that decides: let w be the height of the surface minus the height that the light gains up to there, along one
// ray. The ray is blocked if w is larger ahead than at its start. In a cell whose surface nowhere rises faster than the
// light, w falls, so such a cell blocks no ray that enters it at or above its surface. All other cells, and steps up
// between columns, are in `upper`; the cross-sections of the strip with the surface are in `lower`.
// Cost: 4 bytes and a few nanoseconds per cell and light direction. Exact: what is close is left undecided.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "base/large_memory.h"
#include "relief/cell_grid.h"
#include "relief/methods/slope_scene.h"
#include "relief/visibility/any_ray.h"
#include "relief/work.h"

namespace relief {

// Margins of the bounds; margins.md derives them.
// Distance in texels from a border between strips or cells within which a start is not decided: a shadow ray starts up
// to 1e-6 texels from the hit.
inline constexpr double kHorizonNear = 4e-6;
// Heights: the rounding of a sweep step in float, times the light's rise per cell where that is above 1; and the
// rounding of a cell's steepest rise.
inline constexpr float kHorizonStep = 0x1p-22F;
inline constexpr float kHorizonSteepest = 0x1p-20F;
// Heights: the start's distance from the hit, 1e-6; kVisibilityClearance; and the rounding of stored heights, 1e-7.
inline constexpr double kHorizonStart = 2e-6;

enum class Horizon : std::uint8_t { Undecided, Clear, Blocked };

// Immutable; may be shared by threads.
class HorizonBounds {
  public:
    // Returns true if bounds can be made: of a map in memory of at most kMaxPackedTexels, for light that is neither
    // straight above nor so low that the start of a ray decides by its rounding. run: texels (s, t) that the light
    // passes over while it rises by the whole slab.
    static bool suits(const HeightField& field, glm::dvec2 run);
    // Requires suits(). Throws Cancelled.
    HorizonBounds(const HeightField& field, glm::dvec2 run, Work& work);

    // Decides for rays that start at most 1e-6 texels and 1e-6 heights before the hit (s[n], t[n]) at height
    // 1 - lambda[n], not below the surface, where wanted[n] > 0; others, and starts that are NaN, are undecided. Clear
    // and Blocked are the answers of every AnyHitQuery. scene: the same heights. SIMD.
    void decide(const SlopeScene& scene, std::span<const double> s, std::span<const double> t,
                std::span<const double> lambda, std::span<const double> wanted, std::span<Horizon> answers) const;
    const HeightField& field() const { return field_; }
    glm::dvec2 run() const { return run_; }

    // How the map lies in the texture: x along the faster axis, y across, both in cells, mirrored where the light runs
    // backwards, so that it runs to +x and by `slope` in [0, 1] to +y.
    struct Frame {
        bool swapped = false;  // x is t
        bool backX = false, backY = false;
        bool wraps = false, columns = false;
        int nx = 0, ny = 0;        // cells
        int sizeX = 0, sizeY = 0;  // texels
        double shiftX = 0, shiftY = 0;
        double slope = 0;  // cells in y per cell in x
        double rise = 0;   // heights that the light rises per cell in x
        std::size_t stride = 0;
        // By how many whole cells strips are shifted on line l.
        int shift(int l) const { return static_cast<int>(std::floor(slope * l)); }
        // Entry of the strip that crosses line l between c + f and c + f + 1, with f the fraction of slope * l.
        std::size_t entry(int l, int c) const {
            return static_cast<std::size_t>(l) * stride + static_cast<std::size_t>(wraps ? c : c + 1);
        }
        // The texel of node or column l along x, or c across; any integers.
        int texelX(std::int64_t l) const { return texel(l, nx, sizeX, backX); }
        int texelY(std::int64_t c) const { return texel(c, ny, sizeY, backY); }

      private:
        int texel(std::int64_t at, int cells, int size, bool back) const;
    };
    const Frame& frame() const { return frame_; }
    double lowest() const { return lowest_; }
    double unit() const { return unit_; }
    // Upper bound in the high half, lower bound in the low half, in units above `lowest`; a lower bound of 0 is none.
    const std::uint32_t* entries() const { return entries_.data(); }

  private:
    struct Strips;
    void sweep(int first, int last);
    void store(int l, int place, std::span<const std::uint32_t> row);

    HeightField field_;
    glm::dvec2 run_;
    Frame frame_;
    double lowest_ = 0, unit_ = 0;
    float outside_ = 0;  // the highest that a ray may meet beyond the map
    int leadIn_ = 0;     // lines before the last one from which the sweep begins
    UnfilledVector<std::uint32_t> entries_;
};

// One line of the sweep over a run of strips; rows are read up to 3 values and a vector beyond `count`. Internal to
// horizon_bounds.cpp.
struct HorizonLine {
    const float* near;    // nodes on the line, or heights of the column after it
    const float* beside;  // nodes on the next line, or heights of the column before it
    float* steep[3];      // scratch
    float* upper;
    float* lower;
    std::uint32_t* out;
    std::size_t count;
    float fraction, slope;
    float rise, riseLess, riseMore;  // riseLess, riseMore: by the rounding of a step
    bool columns, second, third;     // whether a strip overlaps the next cell of the column, and the one after it
    float lowest, perUnit;
};
void sweepHorizonLine(const HorizonLine& line);

}  // namespace relief
