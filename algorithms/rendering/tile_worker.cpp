#include "rendering/tile_worker.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "relief/maps/max_pyramid_map.h"
#include "relief/maps/tile_prefetch.h"
#include "relief/methods/look_up_point.h"
#include "relief/simd/packed_cone_hits.h"
#include "rendering/query_lanes.h"
#include "rendering/tile_work.h"

namespace relief {

namespace {

// Coordinates of pixels without a hit.
constexpr double kNoPosition = std::numeric_limits<double>::quiet_NaN();

// Side, in pixels, of the squares that are tested together for rays that need no search.
constexpr int kSkipSide = 16;

}  // namespace

TileWorker::TileWorker(const FrameRequest& request, const Frame& frame, const FrameTools& tools,
                       const FrameBuffers& buffers, std::uint32_t stale, FrameTotals& totals)
    : request_(request),
      frame_(frame),
      tools_(tools),
      buffers_(buffers),
      stale_(stale),
      totals_(totals),
      toLight_(lightDirection(request.light)),
      picture_{frame.width,
               frame.stored.end - frame.stored.begin,
               frame.rays->polygon.data(),
               &frame.rays->rays,
               &frame.hits->hits,
               frame.stored.begin} {
    for (const TexturedQuad& quad : frame.polygons) {
        axes_.emplace_back(quad);
        faces_.push_back(glm::dot(quad.normal, toLight_) > 0 ? 1 : 0);
    }
    polygons_.resize(frame.polygons.size(), nullptr);
    for (const VisiblePolygon& polygon : tools.visible.polygons) polygons_[polygon.number] = &polygon;
    scene_ = tools.coneHits != nullptr ? SlopeScene(request.field, tools.coneHits->cones()) : SlopeScene(request.field);
    sloped_ = frame.shadedByRelief(request) && request.field.surface() == Surface::Bilinear;
}

// Copies the tile's stages that are not made again from the last frame.
void TileWorker::keep(const PixelArea& tile) const {
    const std::uint32_t kept = stale_ & ~staleOf(tile);
    const Frame& last = *tools_.kept->last;
    const auto copy = [&](const auto& from, auto&& to) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            const auto first = static_cast<std::ptrdiff_t>(frame_.index(tile.x0, y));
            std::copy_n(from.begin() + first, tile.x1 - tile.x0, to.begin() + first);
        }
    };
    // Buffers of the frame before the last hold the same pixels where the last edit changed none.
    const auto differs = [&](const auto& from, const auto& to) {
        const std::size_t n = number(tile);
        if (to->madeFor[n] != 0 && to->madeFor[n] == from->madeFor[n]) return false;
        to->madeFor[n] = from->madeFor[n];
        return true;
    };
    if (has(kept, Stage::Hits) && differs(tools_.kept->buffers->hits, buffers_.hits)) {
        const HitBlock& from = last.hits->hits;
        HitBlock& to = buffers_.hits->hits;
        copy(from.outcome, to.outcome), copy(last.hits->by, buffers_.hits->by);
        copy(from.lambda, to.lambda), copy(from.s, to.s), copy(from.t, to.t);
    }
    if (has(kept, Stage::Color) && differs(tools_.kept->buffers->color, buffers_.color)) {
        copy(last.color->color.pixels(), buffers_.color->color.pixels());
    }
    if (has(kept, Stage::Shadows) && request_.shadows) copy(last.shadows->shadowed, buffers_.shadows->shadowed);
    if (has(kept, Stage::Light)) copy(last.light->color.pixels(), buffers_.light->color.pixels());
}

// Clears data of an earlier frame from the buffers; the light stage is not cleared, since every pixel of it is set.
void TileWorker::clear(const PixelArea& tile) const {
    const std::uint32_t stale = staleOf(tile);
    const auto rows = [&](auto&& data, const auto& value) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            const auto first = data.begin() + static_cast<std::ptrdiff_t>(frame_.index(tile.x0, y));
            std::fill(first, first + (tile.x1 - tile.x0), value);
        }
    };
    if (has(stale, Stage::Rays) && needsClearing(buffers_.rays, tile)) {
        rows(buffers_.rays->polygon, kNoPolygon);
        rows(buffers_.rays->inverseDepth, 0.0F);
    }
    if (has(stale, Stage::Hits) && needsClearing(buffers_.hits, tile)) {
        HitBlock& hits = buffers_.hits->hits;
        rows(hits.outcome, Outcome::Unset);
        rows(buffers_.hits->by, HitBy::Traced);
        // A mesh sets only the pixels that it covers.
        if (tools_.mesh != nullptr) {
            for (auto* column : {&hits.lambda, &hits.s, &hits.t}) rows(*column, kNoPosition);
        }
    }
    if (has(stale, Stage::Color) && needsClearing(buffers_.color, tile)) {
        rows(buffers_.color->color.pixels(), Color(0));
    }
    if (has(stale, Stage::Shadows) && !buffers_.shadows->shadowed.empty()) {
        rows(buffers_.shadows->shadowed, std::uint8_t{0});
    }
}

// Clears the rays and hits of pixels that see no polygon; all other pixels are set by the stages.
void TileWorker::clearUncovered(const PixelArea& tile) const {
    const std::uint32_t stale = staleOf(tile);
    const bool rays = has(stale, Stage::Rays) && needsClearing(buffers_.rays, tile);
    const bool met = has(stale, Stage::Hits) && needsClearing(buffers_.hits, tile);
    if (!rays && !met) return;
    const std::uint8_t* polygon = frame_.rays->polygon.data();
    const auto width = static_cast<std::size_t>(tile.x1 - tile.x0);
    for (int y = tile.y0; y < tile.y1; ++y) {
        const std::size_t first = frame_.index(tile.x0, y);
        // Most rows are completely covered.
        if (std::memchr(polygon + first, kNoPolygon, width) == nullptr) continue;
        for (std::size_t i = first, end = i; i < first + width; i = end + 1) {
            for (end = i; end < first + width && polygon[end] == kNoPolygon;) ++end;
            const auto fill = [&](std::vector<double>& column, double value) {
                std::fill_n(column.begin() + static_cast<std::ptrdiff_t>(i), end - i, value);
            };
            if (rays) {
                RayBlock& block = buffers_.rays->rays;
                for (auto* column : {&block.s0, &block.t0, &block.a, &block.b}) fill(*column, 0);
            }
            if (met) {
                HitBlock& hits = buffers_.hits->hits;
                for (auto* column : {&hits.lambda, &hits.s, &hits.t}) fill(*column, kNoPosition);
            }
        }
    }
}

bool TileWorker::covered(const PixelArea& tile) const {
    for (int y = tile.y0; y < tile.y1; ++y) {
        const auto row = frame_.rays->polygon.begin() + static_cast<std::ptrdiff_t>(frame_.index(tile.x0, y));
        if (std::any_of(row, row + (tile.x1 - tile.x0), [](std::uint8_t p) { return p != kNoPolygon; })) return true;
    }
    return false;
}

void TileWorker::markBlank(const PixelArea& tile) const {
    // A mesh may draw in any tile.
    const auto blank = static_cast<std::uint8_t>(tools_.mesh == nullptr && !covered(tile) ? 1 : 0);
    const std::uint32_t stale = staleOf(tile);
    const auto mark = [&](Stage stage, const auto& buffer) {
        if (!buffer) return;
        buffer->blank[number(tile)] = blank;
        if (has(stale, stage) && !buffer->madeFor.empty()) buffer->madeFor[number(tile)] = buffers_.frames;
    };
    mark(Stage::Rays, buffers_.rays), mark(Stage::Hits, buffers_.hits), mark(Stage::Color, buffers_.color);
}

void TileWorker::makeRays(const PixelArea& tile) const {
    RayStage& out = *buffers_.rays;
    std::int64_t covered = 0;
    double off = 0;
    thread_local std::vector<VisiblePolygon::Entry> row;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (const VisiblePolygon& polygon : tools_.visible.polygons) {
            const PixelSpan span = polygon.span(y, frame_.width);
            const int first = static_cast<int>(std::max<std::int64_t>(span.begin, tile.x0));
            const int last = static_cast<int>(std::min<std::int64_t>(span.end, tile.x1));
            if (first >= last) continue;
            row.resize(static_cast<std::size_t>(last - first));
            off = std::max(off, polygon.entries(y, span, first, last, row.data()));
            for (int x = first; x < last; ++x) {
                const std::size_t i = frame_.index(x, y);
                const VisiblePolygon::Entry& entry = row[static_cast<std::size_t>(x - first)];
                if (entry.inverseDepth <= out.inverseDepth[i]) continue;
                covered += out.polygon[i] == kNoPolygon ? 1 : 0;
                out.inverseDepth[i] = entry.inverseDepth;
                out.polygon[i] = polygon.number;
                out.rays.set(i, entry.ray);
            }
        }
    }
    totals_.covered += covered;
    for (double most = totals_.mappingOff; most < off && !totals_.mappingOff.compare_exchange_weak(most, off);) {
    }
}

void TileWorker::traceRays(const PixelArea& tile, Work& work) const {
    HitBlock& out = buffers_.hits->hits;
    if (tools_.ground != nullptr) skipRays(tile);
    Borrowed<RayWork> kept;
    auto& [pixels, block, hits] = *kept;
    coveredPixels(tile, frame_, pixels);
    const std::vector<HitBy>& by = buffers_.hits->by;
    std::erase_if(pixels, [&](std::size_t i) { return by[i] != HitBy::Traced; });
    raysOf(pixels, *frame_.rays, block);
    if (request_.field.tiles() != nullptr) {
        const auto pyramid = tools_.tracer.pyramid();
        prefetchAlong(request_.field, pyramid ? pyramid->tiled.get() : nullptr, block);
    }
    NullSink sink;
    if (tools_.coneHits != nullptr) {
        tools_.coneHits->trace(block, hits, tools_.tracer, work);
    } else {
        hits.resize(0);
        tools_.tracer.trace(block, hits, sink, work);
    }
    for (std::size_t n = 0; n < pixels.size(); ++n) out.set(pixels[n], hits[n]);
    countOutcomes(tile);
    totals_.traced += static_cast<std::int64_t>(pixels.size());
}

// Tries whole squares of pixels, and the quarters of squares that need a search.
void TileWorker::skipRays(const PixelArea& tile) const {
    const auto parts = [](const PixelArea& area, int side, const auto& body) {
        for (int y = area.y0; y < area.y1; y += side) {
            for (int x = area.x0; x < area.x1; x += side) {
                body(PixelArea{x, y, std::min(x + side, area.x1), std::min(y + side, area.y1)});
            }
        }
    };
    parts(tile, kSkipSide, [&](const PixelArea& square) {
        if (!skipBlock(square)) parts(square, kSkipSide / 2, [&](const PixelArea& quarter) { skipBlock(quarter); });
    });
}

// Returns true if nothing is left to trace in the block.
bool TileWorker::skipBlock(const PixelArea& block) const {
    // The reach of all rays contains that of the middle one, so a middle ray that needs a search decides for the block
    // at little cost.
    const std::array<std::size_t, 1> middle{frame_.index((block.x0 + block.x1) / 2, (block.y0 + block.y1) / 2)};
    if (frame_.rays->polygon[middle[0]] != kNoPolygon) {
        const auto reached = tools_.ground->reach(frame_.rays->rays, middle);
        if (!reached || tools_.ground->ground(frame_.rays->rays, middle, *reached) == Ground::Search) return false;
    }
    Borrowed<RayWork> kept;
    auto& pixels = kept->pixels;
    coveredPixels(block, frame_, pixels);
    if (pixels.empty()) return true;
    const RayBlock& rays = frame_.rays->rays;
    const auto reached = tools_.ground->reach(rays, pixels);
    if (!reached) return false;
    const Ground ground = tools_.ground->ground(rays, pixels, *reached);
    if (ground == Ground::Search) return false;
    HitStage& out = *buffers_.hits;
    for (const std::size_t i : pixels) {
        const bool flat = ground == Ground::Flat;
        out.by[i] = flat ? HitBy::FlatGround : HitBy::LittleParallax;
        out.hits.set(i,
                     flat ? tools_.ground->flatHit(rays[i], reached->high) : FlatGround::middleHit(rays[i], *reached));
    }
    (ground == Ground::Flat ? totals_.flatRays : totals_.parallaxRays) += static_cast<std::int64_t>(pixels.size());
    return true;
}

void TileWorker::drawMesh(const PixelArea& tile) const {
    HitBlock& out = buffers_.hits->hits;
    totals_.triangles += tools_.mesh->draw(tile, *frame_.rays, out, frame_.stored.begin);
    std::int64_t covered = 0;
    overPixels(tile, [&](int, int, std::size_t i) { covered += out.steps[i]; });
    totals_.steps += covered;
    countOutcomes(tile);
}

void TileWorker::countOutcomes(const PixelArea& tile) const {
    std::array<int, 3> found{};
    constexpr std::array<Outcome, 3> kOutcomes{Outcome::Hit, Outcome::Miss, Outcome::Limit};
    const int width = tile.x1 - tile.x0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        const Outcome* row = buffers_.hits->hits.outcome.data() + frame_.index(tile.x0, y);
        // The outcomes are counted in sequence, because most rows consist of hits only.
        for (int n = 0, counted = 0; n < 3 && counted < width; ++n) {
            int here = 0;
            for (int x = 0; x < width; ++x) here += row[x] == kOutcomes[static_cast<std::size_t>(n)] ? 1 : 0;
            found[static_cast<std::size_t>(n)] += here;
            counted += here;
        }
    }
    totals_.hits += found[0];
    totals_.misses += found[1];
    totals_.limits += found[2];
}

// Colours footprints that are small enough for the plain filter, and removes them from the block.
void TileWorker::filterTiny(std::vector<std::size_t>& pixels, FilterBlock& block, Work& work) const {
    std::size_t kept = 0;
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        const FilterQuery query = block[n];
        if (tinyFootprint(query, frame_, request_)) {
            FootprintCounts plain;
            buffers_.color->color.pixels()[pixels[n]] = frame_.plainFilter->color(query, plain, work);
            continue;
        }
        block.set(kept, query);
        pixels[kept++] = pixels[n];
    }
    totals_.tinyFootprints += static_cast<std::int64_t>(pixels.size() - kept);
    pixels.resize(kept);
}

// Filters all hits of a tile in one block, because neighbouring pixels have similar footprints.
void TileWorker::filterBlock(const PixelArea& tile, const TextureFilter& filter, FootprintCounts& counts,
                             Work& work) const {
    const HitBlock& hits = frame_.hits->hits;
    Borrowed<FilterWork> kept;
    auto& [pixels, block, colors] = *kept;
    pixels.clear();
    block.picture = hitsFirst() ? &picture_ : nullptr;
    block.resize(static_cast<std::size_t>(kTileWidth) * kTileHeight);
    const std::vector<std::uint8_t>& polygon = frame_.rays->polygon;
    for (int y = tile.y0; y < tile.y1; ++y) {
        const std::size_t row = frame_.index(0, y), end = row + static_cast<std::size_t>(tile.x1);
        for (std::size_t i = row + static_cast<std::size_t>(tile.x0), last = i; i < end; i = std::max(last, i + 1)) {
            last = i;
            while (last < end && hits.outcome[last] == Outcome::Hit && polygon[last] == polygon[i]) ++last;
            if (last == i) continue;
            const std::size_t first = pixels.size(), more = last - i;
            setQueries({*polygons_[polygon[i]], frame_.rays->rays, hits, i, static_cast<int>(i - row), y, more},
                       request_.field, block, first);
            pixels.resize(first + more);
            for (std::size_t n = 0; n < more; ++n) {
                const bool exact = frame_.exactHits && frame_.hits->by[i + n] != HitBy::LittleParallax;
                block.exact[first + n] = exact ? 1 : 0;
                pixels[first + n] = i + n;
            }
        }
    }
    if (frame_.plainFilter) filterTiny(pixels, block, work);
    block.resize(pixels.size());
    colors.resize(pixels.size());
    filter.colors(block, colors, counts, work);
    for (std::size_t n = 0; n < pixels.size(); ++n) buffers_.color->color.pixels()[pixels[n]] = colors[n];
}

void TileWorker::colorHits(const PixelArea& tile, Work& work) const {
    const HitBlock& hits = frame_.hits->hits;
    const TextureFilter* filter = frame_.filter.get();
    // Filters without a footprint need only the position.
    const bool footprints = filter != nullptr && filter->description().footprint;
    FootprintCounts counts;
    if (footprints) {
        filterBlock(tile, *filter, counts, work);
    } else {
        overPixels(tile, [&](int, int, std::size_t i) {
            if (hits.outcome[i] != Outcome::Hit || work.stopped()) return;
            const glm::dvec2 place = lookUpPoint(request_.field, frame_.rays->rays[i], hits[i]);
            buffers_.color->color.pixels()[i] = filter == nullptr
                                                    ? heightGrey(request_.field.at(place.x, place.y))
                                                    : filter->color({place, {}, {}, hits.lambda[i]}, counts, work);
        });
    }
    totals_.footprints += counts.footprints;
    totals_.smallFootprints += counts.bilinear;
    totals_.texels += counts.texels;
    totals_.texelsTested += counts.tested;
    totals_.texelsHidden += counts.hidden;
    totals_.texelsSkipped += counts.skipped;
    totals_.clearFootprints += counts.flat;
    totals_.hiddenFootprints += counts.allHidden;
}

void countTile(const PixelArea& tile, const Tracer& tracer, const Frame& frame, HitStage& hits, FrameTotals& totals,
               Work& work) {
    std::vector<std::size_t> pixels;
    coveredPixels(tile, frame, pixels);
    const auto others =
        std::stable_partition(pixels.begin(), pixels.end(), [&](std::size_t i) { return hits.by[i] == HitBy::Traced; });
    const std::vector<std::size_t> untraced(others, pixels.end());
    pixels.erase(others, pixels.end());
    RayBlock block;
    HitBlock again;
    totals.traced += static_cast<std::int64_t>(pixels.size());
    const std::array<const std::vector<std::size_t>*, 2> parts{&pixels, &untraced};
    for (const auto* part : parts) {
        BlockCounts counts;
        tracer.trace(raysOf(*part, *frame.rays, block), again, counts, work);
        for (std::size_t n = 0; n < part->size(); ++n) {
            hits.hits.steps[(*part)[n]] = again.steps[n];
            hits.hits.reads[(*part)[n]] = again.reads[n];
        }
        totals.steps += static_cast<std::int64_t>(counts.steps);
        totals.reads += static_cast<std::int64_t>(counts.reads);
        // Rays that were skipped are counted as skipped only.
        if (part == &pixels) totals.startHighest += static_cast<std::int64_t>(counts.startHighest);
    }
}

}  // namespace relief
