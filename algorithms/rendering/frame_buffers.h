// The buffers of a frame's stages, kept from frame to frame. Internal to the renderer.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rendering/frame.h"

namespace relief {

inline constexpr int kTileWidth = 64;
inline constexpr int kTileHeight = 32;

// Returns the number of tiles that cover the width (pixels) or height of a picture.
constexpr int tilesAcross(int width) {
    return (width + kTileWidth - 1) / kTileWidth;
}
constexpr int tilesDown(int height) {
    return (height + kTileHeight - 1) / kTileHeight;
}

// Returns true if the stage is in the set, given as bits of Stage.
constexpr bool has(std::uint32_t stages, Stage stage) {
    return (stages & bit(stage)) != 0;
}

// A stage's buffer, and which of its tiles are blank: none of their pixels saw a polygon in the last frame that used
// the buffer, and they still hold the values that TileWorker::clear() sets. Sky tiles are therefore not cleared again
// in every frame.
template <class T>
struct Kept : T {
    int width = 0, height = 0;        // of the picture
    std::vector<std::uint8_t> blank;  // one per tile, rows top-down
    // For each tile the number of the frame that it was made for: buffers with the same number hold the same pixels. 0:
    // unknown. Empty in bands.
    std::vector<std::uint64_t> madeFor;
};

// The buffers of a frame that is being made: new ones for stale stages, the last frame's for all others.
struct FrameBuffers {
    std::shared_ptr<Kept<RayStage>> rays;
    std::shared_ptr<Kept<HitStage>> hits;
    std::shared_ptr<Kept<ColorStage>> color;
    std::shared_ptr<ShadowStage> shadows;
    std::shared_ptr<LightStage> light;
    std::uint64_t frames = 0;  // number of frames made with these buffers, the current one included
};

// Bytes per pixel of all stages but light; and of steps and reads.
inline constexpr std::size_t kStageBytes = 4 * sizeof(double) + sizeof(std::uint8_t) + sizeof(float) +  // rays
                                           3 * sizeof(double) + sizeof(Outcome) + sizeof(HitBy) +       // hits
                                           sizeof(Color) + sizeof(std::uint8_t);                        // and shadows
inline constexpr std::size_t kCountBytes = 2 * sizeof(std::uint32_t);

// Makes `band` hold all stages but light for this many rows of the frame's picture, reusing its buffers; no tile is
// marked blank.
void fitBand(FrameBuffers& band, const Frame& frame, int rows, const FrameRequest& request, bool counts);
// Discards this many rows at the top and moves the others up.
void shiftBand(FrameBuffers& band, const Frame& frame, int rows);

// Returns a light stage of the size of frame.lit: the given one if no other owner holds it, or else a new one.
std::shared_ptr<LightStage> fitLight(std::shared_ptr<LightStage>& light, const Frame& frame);

// Returns buffers for stale stages, which the tiles must clear; the frame points to those that its later stages read.
// spare: buffers of an older frame, reused where no other owner holds them. last: null if all stages are stale. Throws
// MemoryError.
FrameBuffers allocateBuffers(Frame& frame, const Frame* last, FrameBuffers& spare, const FrameRequest& request,
                             bool mesh, std::uint32_t stale);

}  // namespace relief
