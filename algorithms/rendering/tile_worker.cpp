#include "rendering/tile_worker.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "relief/look_up_point.h"

namespace relief {

namespace {

// How far before the hit a shadow ray starts: texels along the view ray, and never more in heights. Above the rounding
// of coordinates up to 10^6 texels, below what can be seen.
constexpr double kShadowStart = 1e-6;

// Indices of the tile's pixels that see a polygon.
std::vector<std::size_t> coveredPixels(const PixelArea& tile, const Frame& frame) {
    std::vector<std::size_t> pixels;
    pixels.reserve(static_cast<std::size_t>(kTileWidth) * kTileHeight);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const std::size_t i = frame.index(x, y);
            if (frame.rays->polygon[i] != kNoPolygon) pixels.push_back(i);
        }
    }
    return pixels;
}

RayBlock raysOf(const std::vector<std::size_t>& pixels, const RayStage& rays) {
    RayBlock block(pixels.size());
    for (std::size_t n = 0; n < pixels.size(); ++n) block.set(n, rays.rays[pixels[n]]);
    return block;
}

}  // namespace

void TileWorker::makeRays(const PixelArea& tile) const {
    RayStage& out = *buffers_.rays;
    std::int64_t covered = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (const VisiblePolygon& polygon : tools_.visible.polygons) {
            const PixelSpan span = polygon.span(y, frame_.width);
            const int first = static_cast<int>(std::max<std::int64_t>(span.begin, tile.x0));
            const int last = static_cast<int>(std::min<std::int64_t>(span.end, tile.x1));
            for (int x = first; x < last; ++x) {
                const std::size_t i = frame_.index(x, y);
                const VisiblePolygon::Entry entry = polygon.entry(x, y);
                if (entry.inverseDepth <= out.inverseDepth[i]) continue;
                covered += out.polygon[i] == kNoPolygon ? 1 : 0;
                out.inverseDepth[i] = entry.inverseDepth;
                out.polygon[i] = polygon.number;
                out.rays.set(i, entry.ray);
            }
        }
    }
    totals_.covered += covered;
}

void TileWorker::traceRays(const PixelArea& tile, Work& work) const {
    HitBlock& out = buffers_.hits->hits;
    const std::vector<std::size_t> pixels = coveredPixels(tile, frame_);
    const RayBlock block = raysOf(pixels, *frame_.rays);
    HitBlock hits;
    NullSink sink;
    tools_.tracer.trace(block, hits, sink, work);
    for (std::size_t n = 0; n < pixels.size(); ++n) out.set(pixels[n], hits[n]);
    countOutcomes(tile);
    totals_.traced += static_cast<std::int64_t>(pixels.size());
}

void TileWorker::drawMesh(const PixelArea& tile) const {
    HitBlock& out = buffers_.hits->hits;
    totals_.triangles += tools_.mesh->draw(tile, *frame_.rays, out);
    std::int64_t covered = 0;
    overPixels(tile, [&](int, int, std::size_t i) { covered += out.steps[i]; });
    totals_.steps += covered;
    countOutcomes(tile);
}

void TileWorker::countOutcomes(const PixelArea& tile) const {
    std::array<std::int64_t, 4> outcomes{};
    overPixels(tile,
               [&](int, int, std::size_t i) { ++outcomes[static_cast<std::size_t>(buffers_.hits->hits.outcome[i])]; });
    totals_.hits += outcomes[static_cast<std::size_t>(Outcome::Hit)];
    totals_.misses += outcomes[static_cast<std::size_t>(Outcome::Miss)];
    totals_.limits += outcomes[static_cast<std::size_t>(Outcome::Limit)];
}

// A tile's hits in one block: neighbours have like footprints.
void TileWorker::filterBlock(const PixelArea& tile, const TextureFilter& filter, FootprintCounts& counts,
                             Work& work) const {
    const HitBlock& hits = frame_.hits->hits;
    std::vector<std::size_t> pixels;
    pixels.reserve(static_cast<std::size_t>(kTileWidth) * kTileHeight);
    overPixels(tile, [&](int, int, std::size_t i) {
        if (hits.outcome[i] == Outcome::Hit) pixels.push_back(i);
    });
    FilterBlock block;
    block.resize(pixels.size());
    const auto width = static_cast<std::size_t>(frame_.width);
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        const auto x = static_cast<int>(pixels[n] % width), y = static_cast<int>(pixels[n] / width);
        block.set(n, *filterQuery(frame_, request_, tools_.visible, x, y));
    }
    std::vector<Color> colors(pixels.size());
    filter.colors(block, colors, counts, work);
    for (std::size_t n = 0; n < pixels.size(); ++n) buffers_.color->color.pixels()[pixels[n]] = colors[n];
}

void TileWorker::colorHits(const PixelArea& tile, Work& work) const {
    const HitBlock& hits = frame_.hits->hits;
    const TextureFilter* filter = frame_.filter.get();
    // Others need no more than the place.
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

// From just before the hit, on the free side (the viewer's side of a wall is always its front), to the top plane.
AnyRay TileWorker::shadowRay(const TexturedQuad& quad, const ViewRay& view, double lambda) const {
    const double back = kShadowStart / std::max(1.0, std::hypot(view.a, view.b));
    const double from = std::max(0.0, lambda - back);
    AnyRay ray;
    ray.s = view.s0 + from * view.a;
    ray.t = view.t0 + from * view.b;
    ray.z = 1 - from;
    // What is not found exactly may lie under the surface, and would shade itself.
    if (tools_.tracer.guarantee() != Guarantee::Exact) ray.z = std::max(ray.z, request_.field.at(ray.s, ray.t));
    const glm::dvec3& perS = quad.plane.perS;
    const glm::dvec3& perT = quad.plane.perT;
    const double texel = glm::length(perS);
    // World units towards the light until the top plane is reached.
    const double length = (1 - ray.z) * frame_.slabTexels * texel / glm::dot(toLight_, quad.normal);
    ray.ds = length * glm::dot(toLight_, perS) / glm::dot(perS, perS);
    ray.dt = length * glm::dot(toLight_, perT) / glm::dot(perT, perT);
    ray.dz = 1 - ray.z;
    return ray;
}

void TileWorker::castShadows(const PixelArea& tile, Work& work) const {
    if (tools_.query == nullptr) return;
    const HitBlock& hits = frame_.hits->hits;
    std::vector<std::uint8_t>& shadowed = buffers_.shadows->shadowed;
    std::vector<std::size_t> pixels;
    AnyRayBlock rays;
    std::int64_t away = 0;
    std::int64_t top = 0;
    overPixels(tile, [&](int x, int y, std::size_t i) {
        if (hits.outcome[i] != Outcome::Hit) return;
        const TexturedQuad& quad = frame_.polygons[frame_.rays->polygon[i]];
        if (glm::dot(quad.normal, toLight_) <= 0) {
            // The light is behind the whole polygon.
            shadowed[i] = 1;
            ++away;
        } else if (glm::dot(glm::dvec3(frame_.normal(x, y, request_)), toLight_) <= 0) {
            ++away;
        } else {
            const AnyRay ray = shadowRay(quad, frame_.rays->rays[i], hits.lambda[i]);
            if (ray.dz <= 0) {
                ++top;
            } else {
                rays.push(ray);
                pixels.push_back(i);
            }
        }
    });
    SightBlock sights;
    BlockCounts counts;
    if (request_.counts) {
        tools_.query->look(rays, sights, counts, work);
    } else {
        NullSink sink;
        tools_.query->look(rays, sights, sink, work);
    }
    std::int64_t blocked = 0;
    std::int64_t limits = 0;
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        shadowed[pixels[n]] = sights.sight[n] == Sight::Blocked ? 1 : 0;
        blocked += sights.sight[n] == Sight::Blocked ? 1 : 0;
        limits += sights.sight[n] == Sight::Limit ? 1 : 0;
    }
    totals_.shadowRays += static_cast<std::int64_t>(pixels.size());
    totals_.shadowBlocked += blocked;
    totals_.shadowLimits += limits;
    totals_.shadowAway += away;
    totals_.shadowTop += top;
    totals_.shadowSteps += static_cast<std::int64_t>(counts.steps);
}

void TileWorker::lightHits(const PixelArea& tile) const {
    const HitBlock& hits = frame_.hits->hits;
    const auto colors = frame_.color->color.pixels();
    const std::vector<std::uint8_t>& shadowed = frame_.shadows->shadowed;
    const auto out = buffers_.light->color.pixels();
    overPixels(tile, [&](int x, int y, std::size_t i) {
        switch (hits.outcome[i]) {
            case Outcome::Hit:
                out[i] = lambert(colors[i], frame_.normal(x, y, request_), toLight_, request_.light,
                                 !shadowed.empty() && shadowed[i] != 0);
                break;
            case Outcome::Limit:
                out[i] = Color(0);
                break;
            default:
                out[i] = request_.sky;
        }
    });
}

void countTile(const PixelArea& tile, const Tracer& tracer, const Frame& frame, HitStage& hits, FrameTotals& totals,
               Work& work) {
    const std::vector<std::size_t> pixels = coveredPixels(tile, frame);
    const RayBlock block = raysOf(pixels, *frame.rays);
    HitBlock again;
    BlockCounts counts;
    tracer.trace(block, again, counts, work);
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        hits.hits.steps[pixels[n]] = again.steps[n];
        hits.hits.reads[pixels[n]] = again.reads[n];
    }
    totals.steps += static_cast<std::int64_t>(counts.steps);
    totals.reads += static_cast<std::int64_t>(counts.reads);
    totals.startHighest += static_cast<std::int64_t>(counts.startHighest);
}

}  // namespace relief
