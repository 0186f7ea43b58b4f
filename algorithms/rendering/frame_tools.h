// The tools that a frame is made with, and loops over its tiles. Internal to the renderer.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "relief/simd/packed_cone_hits.h"
#include "rendering/tile_worker.h"

namespace relief {

inline constexpr std::uint32_t kAllStages = (1U << kStages) - 1;

// The frame before any pixel is made, and the tools for its stale stages. The tools keep references to each other.
struct FrameSetup {
    std::shared_ptr<Frame> frame;
    VisiblePolygons visible;
    std::shared_ptr<const Tracer> tracer{};
    std::unique_ptr<const MeshRaster> mesh{};
    std::unique_ptr<const AnyHitQuery> query{};
    std::unique_ptr<const FlatGround> ground{};
    std::unique_ptr<const PackedConeHits> coneHits{};
    std::vector<std::shared_ptr<const HorizonBounds>> horizons{};
    std::optional<KeptTiles> kept{};
    std::chrono::steady_clock::duration horizonTime{};  // of making them, times the number of threads

    FrameTools tools() const {
        return {visible,      *tracer,        mesh.get(), query.get(),
                ground.get(), coneHits.get(), horizons,   kept ? &*kept : nullptr};
    }
};

// Throws InputError if the request's sizes or its filter are out of range.
void checkRequest(const FrameRequest& request);

// Returns "--size WxH" as the subject of messages.
std::string sizeSubject(const FrameRequest& request);

// Returns the tiles of these rows, from the top; the first row must be the first row of a tile.
inline std::vector<PixelArea> tilesOf(int width, RowRange rows) {
    std::vector<PixelArea> tiles;
    for (int y = rows.begin; y < rows.end; y += kTileHeight) {
        for (int x = 0; x < width; x += kTileWidth) {
            tiles.push_back({x, y, std::min(x + kTileWidth, width), std::min(y + kTileHeight, rows.end)});
        }
    }
    return tiles;
}

// Calls body(tile) for all tiles, in parallel. Throws Cancelled.
template <class Body>
void overTiles(const std::vector<PixelArea>& tiles, bool reportProgress, Work& work, const Body& body) {
    parallelFor(work, tiles.size(), [&](std::size_t n) {
        body(tiles[n]);
        if (reportProgress) work.progress().advance();
    });
}

}  // namespace relief
