// The SIMD version of EllipticalKernel::filterScalar (elliptical.h): one pixel per lane, 16, 8 or 4 of them, by Google
// Highway, the instruction set chosen at run time.
//
// Unlike the reference: levels hold 16 bits a channel, the footprint's ellipse is made in float, and the
// Gaussian's exponential is a polynomial (relative error 2.6e-6). Each pixel's sum runs over its own texels in the
// reference's order, with operations that round alike everywhere: equal bits on every instruction set, in any
// company.
//
// Left to the reference: footprints that are not finite, larger than the picture, or at the
// narrow last texel of a level that is not a power of two; weights and levels without a closed form (serves()).
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "filtering/filter_block.h"
#include "filtering/lane_job.h"

namespace relief {

class EllipticalLanes {
  public:
    // settings: served.
    EllipticalLanes(std::shared_ptr<const LaneLevels> levels, const EllipticalSettings& settings);

    // Weights by a closed form, a level chosen by the footprint.
    static bool serves(const EllipticalSettings& settings);

    const std::shared_ptr<const LaneLevels>& levels() const { return levels_; }

    // scale: texels of the picture per texel of the queries'. colors, left: of the block's length. A pixel with
    // left 1 was left out: its colour is not written. log: null but for a block of one pixel; takes its texels.
    void filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, std::span<std::uint8_t> left,
                FootprintCounts& counts, FootprintLog* log = nullptr) const;

  private:
    LaneJob job_;
    std::shared_ptr<const LaneLevels> levels_;
};

}  // namespace relief
