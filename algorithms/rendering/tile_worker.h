// The work on one tile of a frame, stage by stage. Internal to the renderer.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "relief/block_work.h"
#include "relief/methods/slope_scene.h"
#include "relief/visibility/any_hit.h"
#include "relief/visibility/horizon_bounds.h"
#include "rendering/edited_tiles.h"
#include "rendering/flat_ground.h"
#include "rendering/frame_buffers.h"
#include "rendering/mesh_raster.h"
#include "rendering/visible_polygons.h"

namespace relief {

// Counts of work done and skipped, summed over all tiles.
struct FrameTotals {
    using Count = std::atomic<std::int64_t>;
    std::array<Count, kStages> nanoseconds{};
    Count covered{0}, traced{0}, steps{0}, reads{0}, startHighest{0}, hits{0}, misses{0}, limits{0}, triangles{0};
    Count footprints{0}, smallFootprints{0}, texels{0}, texelsTested{0}, texelsHidden{0}, texelsSkipped{0};
    Count clearFootprints{0}, hiddenFootprints{0};
    Count shadowRays{0}, shadowBlocked{0}, shadowAway{0}, shadowTop{0}, shadowSteps{0}, shadowLimits{0};
    Count shadowHits{0}, shadowBounds{0}, shadowBoundsBlocked{0}, flatRays{0}, parallaxRays{0}, tinyFootprints{0};
    std::atomic<double> mappingOff{0};  // maximum, texels
};

// The tools that a frame is made with. mesh: null if rays are traced; query: null if shadows are off or not stale.
struct FrameTools {
    const VisiblePolygons& visible;
    const Tracer& tracer;
    const MeshRaster* mesh;
    const AnyHitQuery* query;
    const FlatGround* ground = nullptr;        // null: every ray is traced
    const PackedConeHits* coneHits = nullptr;  // null: the tracer itself traces
    // By polygon number; null: all its shadow rays are traced.
    std::span<const std::shared_ptr<const HorizonBounds>> horizons{};
    const KeptTiles* kept = nullptr;  // null: all stale stages of all tiles are made
};

// Keeps references to its arguments. One worker serves all tiles and may be called from any thread.
class TileWorker {
  public:
    TileWorker(const FrameRequest& request, const Frame& frame, const FrameTools& tools, const FrameBuffers& buffers,
               std::uint32_t stale, FrameTotals& totals);

    // Returns true if the hits of all stored rows are made before any colour, so that the filter can use the hits of
    // neighbouring tiles instead of tracing those rays again.
    static bool hitsFirst(const Frame& frame, const FrameRequest& request, std::uint32_t stale) {
        return has(stale, Stage::Color) && frame.filter && frame.filter->readsNeighbours() && frame.exactHits &&
               !(request.bounded > 0);
    }
    bool hitsFirst() const { return hitsFirst(frame_, request_, stale_); }
    void findHits(const PixelArea& tile, Work& work) const {
        if (tools_.kept != nullptr) keep(tile);
        clear(tile);
        timed(Stage::Rays, tile, [&] { makeRays(tile); });
        clearUncovered(tile);
        markBlank(tile);
        timed(Stage::Hits, tile, [&] {
            if (tools_.mesh != nullptr) return drawMesh(tile);
            overRayBlocks(tile, [&](const PixelArea& part) { traceRays(part, work); });
        });
    }
    void shade(const PixelArea& tile, Work& work) const;

  private:
    // Returns the stages to make in this tile.
    std::uint32_t staleOf(const PixelArea& tile) const {
        return tools_.kept == nullptr ? stale_ : tools_.kept->stale[number(tile)];
    }
    template <class Body>
    void timed(Stage stage, const PixelArea& tile, const Body& body) const {
        if (!has(staleOf(tile), stage)) return;
        const auto begin = std::chrono::steady_clock::now();
        body();
        totals_.nanoseconds[static_cast<std::size_t>(stage)] += (std::chrono::steady_clock::now() - begin).count();
    }

    // Calls body for parts of a tile that have no more rays than one thread traces at once; a larger block would be
    // divided among threads again.
    template <class Body>
    void overRayBlocks(const PixelArea& tile, const Body& body) const {
        constexpr int kRows = static_cast<int>(kRayGrain) / kTileWidth;
        for (int y = tile.y0; y < tile.y1; y += kRows) body({tile.x0, y, tile.x1, std::min(y + kRows, tile.y1)});
    }

    template <class Body>
    void overPixels(const PixelArea& tile, const Body& body) const {
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) body(x, y, frame_.index(x, y));
        }
    }

    // Calls body(polygon, begin, end) for the runs of one polygon in row y, pixels from the tile's left edge.
    template <class Body>
    void overPolygons(const PixelArea& tile, int y, const Body& body) const {
        const std::uint8_t* const polygon = frame_.rays->polygon.data() + frame_.index(tile.x0, y);
        const auto width = static_cast<std::size_t>(tile.x1 - tile.x0);
        for (std::size_t begin = 0, end = 0; begin < width; begin = end) {
            while (end < width && polygon[end] == polygon[begin]) ++end;
            if (polygon[begin] != kNoPolygon) body(polygon[begin], begin, end);
        }
    }

    std::size_t number(const PixelArea& tile) const {
        const int across = tilesAcross(frame_.width);
        const int down = (tile.y0 - frame_.stored.begin) / kTileHeight;
        // Returns the tile's index in Kept::blank.
        return static_cast<std::size_t>(down * across + tile.x0 / kTileWidth);
    }
    // Returns true if the stage's buffer still holds this tile's data from an earlier frame.
    template <class T>
    bool needsClearing(const std::shared_ptr<Kept<T>>& stage, const PixelArea& tile) const {
        return stage && stage->blank[number(tile)] == 0;
    }
    // Returns true if any of the tile's pixels sees a polygon.
    bool covered(const PixelArea& tile) const;
    void keep(const PixelArea& tile) const;
    void clear(const PixelArea& tile) const;
    void clearUncovered(const PixelArea& tile) const;
    void markBlank(const PixelArea& tile) const;
    void fillSky(const PixelArea& tile) const;
    void makeRays(const PixelArea& tile) const;
    void traceRays(const PixelArea& tile, Work& work) const;
    void skipRays(const PixelArea& tile) const;
    bool skipBlock(const PixelArea& block) const;
    void drawMesh(const PixelArea& tile) const;
    void countOutcomes(const PixelArea& tile) const;
    void colorHits(const PixelArea& tile, Work& work) const;
    void filterTiny(std::vector<std::size_t>& pixels, FilterBlock& block, Work& work) const;
    void filterBlock(const PixelArea& tile, const TextureFilter& filter, FootprintCounts& counts, Work& work) const;
    // facing: the first row of the area.
    void castShadows(const PixelArea& tile, const double* facing, Work& work) const;
    AnyRay shadowRay(std::size_t i) const;
    void boundRow(const PixelArea& tile, int y, std::span<const double> facing, std::span<Horizon> answers) const;
    void faceLight(const PixelArea& tile, int y, std::span<double> facing) const;
    void lightHits(const PixelArea& tile, const double* facing) const;

    const FrameRequest& request_;
    const Frame& frame_;
    const FrameTools& tools_;
    const FrameBuffers& buffers_;
    std::uint32_t stale_;
    FrameTotals& totals_;
    glm::dvec3 toLight_;
    PictureHits picture_;
    std::vector<const VisiblePolygon*> polygons_;  // by polygon number; null: not visible
    std::vector<ReliefAxes> axes_;                 // by polygon number
    SlopeScene scene_;                             // the field, for slopes and for bounds of the horizon
    std::vector<std::uint8_t> faces_;              // by polygon number: whether its front faces the light
    bool sloped_ = false;                          // whether the relief is bilinear and shaded with its own normals
};

// Counts steps and reads of the tile's rays by tracing them again with the tracer that made the hits.
void countTile(const PixelArea& tile, const Tracer& tracer, const Frame& frame, HitStage& hits, FrameTotals& totals,
               Work& work);

}  // namespace relief
