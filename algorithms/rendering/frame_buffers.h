// The buffers of a frame's stages, kept from frame to frame: inside the renderer, not for others.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rendering/frame.h"

namespace relief {

inline constexpr int kTileWidth = 64;
inline constexpr int kTileHeight = 32;

constexpr int tilesAcross(int width) {
    return (width + kTileWidth - 1) / kTileWidth;
}
constexpr int tilesDown(int height) {
    return (height + kTileHeight - 1) / kTileHeight;
}

constexpr bool has(std::uint32_t stages, Stage stage) {
    return (stages & bit(stage)) != 0;
}

// A stage's buffer, and which of its tiles are blank: no pixel of theirs saw a polygon when it was used last, and all
// is there as TileWorker clears it. So what a picture shows of the sky is not written frame after frame.
template <class T>
struct Kept : T {
    int width = 0, height = 0;        // of the picture
    std::vector<std::uint8_t> blank;  // one a tile, rows top-down
};

// The buffers of one frame in the making: those of stale stages are new, the others are the last frame's.
struct FrameBuffers {
    std::shared_ptr<Kept<RayStage>> rays;
    std::shared_ptr<Kept<HitStage>> hits;
    std::shared_ptr<Kept<ColorStage>> color;
    std::shared_ptr<ShadowStage> shadows;
    std::shared_ptr<LightStage> light;
};

// Bytes a pixel of all stages but light; and of steps and reads.
inline constexpr std::size_t kStageBytes = 4 * sizeof(double) + sizeof(std::uint8_t) + sizeof(float) +  // rays
                                           3 * sizeof(double) + sizeof(Outcome) + sizeof(HitBy) +       // hits
                                           sizeof(Color) + sizeof(std::uint8_t);                        // and shadows
inline constexpr std::size_t kCountBytes = 2 * sizeof(std::uint32_t);

// Buffers for all stages but light of so many rows of the frame's picture, no tile blank: those given, made to fit.
void fitBand(FrameBuffers& band, const Frame& frame, int rows, const FrameRequest& request, bool counts);
// Forgets this many rows at the top and moves the others up.
void shiftBand(FrameBuffers& band, const Frame& frame, int rows);

// The light stage as a buffer for the frame's picture: this one if nobody else holds it, or a new one.
std::shared_ptr<LightStage> fitLight(std::shared_ptr<LightStage>& light, const Frame& frame);

// Buffers for stale stages, to be cleared by the tiles; the frame points to what its later stages read. spare: of an
// older frame, taken where nobody else holds them. last: null where all stages are stale. Throws MemoryError.
FrameBuffers allocateBuffers(Frame& frame, const Frame* last, FrameBuffers& spare, const FrameRequest& request,
                             bool mesh, std::uint32_t stale);

}  // namespace relief
