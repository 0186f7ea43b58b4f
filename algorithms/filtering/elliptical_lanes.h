// The SIMD version of EllipticalKernel::filterScalar (elliptical.h): one pixel per lane, 16, 8 or 4 at once, by Google
// Highway, with the instruction set chosen at run time.
//
// Differences from the reference: levels have 16 bits per channel, the footprint's ellipse is computed in float, and
// the Gaussian's exponential is a polynomial (relative error 2.6e-6). Each pixel's sum runs over its own texels in the
// order of the reference, with operations that round identically everywhere. So the bits are the same on every
// instruction set and do not depend on the other pixels of the block.
//
// Pixels that fall back to the reference: footprints that are not finite, larger than the picture, or at the narrow
// last texel of a level whose size is not a multiple of 2^level. Weights and level choices without a closed form are
// not supported at all (serves()).
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "filtering/filter_block.h"
#include "filtering/lane_job.h"

namespace relief {

class EllipticalLanes {
  public:
    // Precondition: serves(settings).
    EllipticalLanes(std::shared_ptr<const LaneLevels> levels, const EllipticalSettings& settings);

    // Returns true if the weights have a closed form and the level is chosen by the footprint.
    static bool serves(const EllipticalSettings& settings);

    const std::shared_ptr<const LaneLevels>& levels() const { return levels_; }

    // Filters colors.size() pixels. scale: texels of the picture per texel of the queries' places. fallback: one flag
    // per colour, set to 1 where the pixel is not filtered and its colour not written. log: null unless the block has
    // one pixel, whose texels it receives.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, std::span<std::uint8_t> fallback,
                FootprintCounts& counts, FootprintLog* log = nullptr) const;

  private:
    LaneJob job_;
    std::shared_ptr<const LaneLevels> levels_;
};

}  // namespace relief
