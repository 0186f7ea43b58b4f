// The tiles of a frame that an edit of a few texels can change; all other tiles keep the pixels of the last frame.
//
// Why that gives the bits of a new frame: the hit of an exact method is the first one along the ray, and a cell decides
// it by its own corners, so a ray that passes only over unchanged texels has its old hit. The same holds for a shadow
// ray. For each tile the texels are bounded that its view rays pass over from the top of the slab to its bottom, that
// light on its way to them passes over, and that its filter reads; a tile is kept if none of these has changed. Frame
// and units: pixel_view.h.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "rendering/frame.h"
#include "rendering/mesh_raster.h"

namespace relief {

// Texels [low, high] along an axis, not reduced to a period.
struct TexelRange {
    double low = 0, high = 0;
};

// Which texels of two height maps of one size differ.
class ChangedTexels {
  public:
    // Returns std::nullopt if the sizes differ or more than a quarter of the texels does.
    static std::optional<ChangedTexels> between(const FloatImage& before, const FloatImage& after);

    // Returns true if a changed texel may lie in this rectangle.
    bool within(TexelRange s, TexelRange t, Address address) const;

  private:
    int width_ = 0, height_ = 0;
    int shift_ = 0;  // texels are counted by squares with sides of 2^shift_
    int across_ = 0;
    std::vector<std::int32_t> sums_;  // of changed texels in all squares above and to the left, (across_ + 1) a row
};

// Which stages of which tiles are made again; the others are copied from the last frame.
struct KeptTiles {
    std::shared_ptr<const Frame> last;
    std::vector<std::uint32_t> stale;  // bits of Stage, one per tile, rows top-down

    std::size_t kept() const;
};

// Returns the stages to make again after a change of the heights alone; std::nullopt if any tile may depend on any
// texel, as with methods that are not exact. last: the frame of lastField. frame: describes the new one; its rays are
// the last frame's. stale: the stages that depend on heights.
std::optional<KeptTiles> keptTiles(const FrameRequest& request, const HeightField& lastField,
                                   std::shared_ptr<const Frame> last, const Frame& frame,
                                   const VisiblePolygons& visible, std::uint32_t stale);

}  // namespace relief
