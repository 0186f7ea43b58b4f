// The rays on which our tracers and others are compared: those of a perspective view in the order of a frame's tiles,
// or random ones.
#pragma once

#include <cstdint>
#include <numbers>

#include "measuring/bench/bench_tracers.h"
#include "rendering/block_order.h"
#include "rendering/pinhole.h"
#include "rendering/tile_worker.h"

namespace relief::peers {

struct PeerView {
    int width = 800;
    int height = 600;
    double distance = 1;   // from the camera to the middle of the floor, in texture widths
    double azimuth = 30;   // degrees
    double fov = 40;       // degrees, vertical
    double lowest = 10;    // lowest elevation of random rays, in degrees
    std::size_t rays = 0;  // 0: every pixel; otherwise tiles are omitted uniformly until about this many rays remain
    std::uint64_t seed = 1;
};

inline std::size_t pixelCount(const PeerView& view) {
    return static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
}

// Returns the rays of the pixels that see the floor, tile by tile as in a frame, each tile in block order.
inline RayBlock perspectiveRays(const HeightField& field, double elevation, const PeerView& view) {
    Camera camera;
    camera.elevation = elevation;
    camera.azimuth = view.azimuth;
    camera.distance = view.distance;
    camera.fov = view.fov;
    const VisiblePolygons visible =
        visiblePolygons(makeScene(SceneKind::Floor, field.width(), field.height()),
                        pinholeCamera(camera, view.width, view.height), view.width, view.height, field.reliefDepth());
    std::vector<RayBlock> tiles;
    std::size_t covered = 0;
    for (int y = 0; y < view.height; y += kTileHeight) {
        for (int x = 0; x < view.width; x += kTileWidth) {
            RayBlock rays;
            inBlockOrder({x, y, std::min(x + kTileWidth, view.width), std::min(y + kTileHeight, view.height)},
                         [&](int px, int py) {
                             if (const VisiblePolygon* polygon = visible.at(px, py, view.width)) {
                                 rays.push(polygon->entry(px, py).ray);
                             }
                         });
            if (rays.size() == 0) continue;
            covered += rays.size();
            tiles.push_back(std::move(rays));
        }
    }
    const double share =
        view.rays == 0 ? 1 : std::min(1.0, static_cast<double>(view.rays) / static_cast<double>(covered));
    RayBlock all;
    double due = 0;
    for (const RayBlock& tile : tiles) {
        due += share;
        if (due < 1) continue;
        due -= 1;
        for (std::size_t i = 0; i < tile.size(); ++i) all.push(tile[i]);
    }
    return all;
}

inline RayBlock peerRays(const HeightField& field, Elevation elevation, const PeerView& view) {
    const std::size_t count = view.rays == 0 ? pixelCount(view) : view.rays;
    return elevation ? perspectiveRays(field, *elevation, view)
                     : benchRays(field, elevation, count, view.seed, view.lowest);
}

}  // namespace relief::peers
