// Scratch buffers of a tile's stages, reused for the next tile. Internal to tile_worker.cpp.
#pragma once

#include <array>
#include <vector>

#include "base/borrowed.h"
#include "relief/visibility/any_ray.h"
#include "rendering/block_order.h"
#include "rendering/frame_buffers.h"

namespace relief {

struct RayWork {
    std::vector<std::size_t> pixels;
    RayBlock rays;
    HitBlock hits;
};
struct FilterWork {
    std::vector<std::size_t> pixels;
    FilterBlock block;
    std::vector<Color> colors;
};
struct ShadowWork {
    std::vector<std::size_t> pixels;
    AnyRayBlock rays;
};
// The cosine between normal and light of a tile's pixels, rows of kTileWidth; unspecified without a hit.
struct FacingWork {
    std::array<double, static_cast<std::size_t>(kTileWidth) * kTileHeight> facing;
};

// Collects the indices of the tile's pixels that see a polygon.
inline void coveredPixels(const PixelArea& tile, const Frame& frame, std::vector<std::size_t>& pixels) {
    pixels.clear();
    inBlockOrder(tile, [&](int x, int y) {
        const std::size_t i = frame.index(x, y);
        if (frame.rays->polygon[i] != kNoPolygon) pixels.push_back(i);
    });
}

// Copies the rays of these pixels into `block`, and returns it.
inline RayBlock& raysOf(const std::vector<std::size_t>& pixels, const RayStage& rays, RayBlock& block) {
    block.resize(pixels.size());
    for (std::size_t n = 0; n < pixels.size(); ++n) block.set(n, rays.rays[pixels[n]]);
    return block;
}

}  // namespace relief
