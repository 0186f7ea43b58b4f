// The last stages of a tile: shadow rays and light.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "rendering/light_lanes.h"
#include "rendering/tile_work.h"
#include "rendering/tile_worker.h"

namespace relief {

namespace {

// Distance before the hit at which a shadow ray starts: texels along the view ray, and at most this much in height.
// Above the rounding error of coordinates up to 10^6 texels, and too small to be visible.
constexpr double kShadowStart = 1e-6;

}  // namespace

// Returns the ray from just before the hit, on its free side (the viewer always sees the front of a wall), to the top
// plane.
AnyRay TileWorker::shadowRay(const TexturedQuad& quad, const ViewRay& view, double lambda) const {
    const double back = kShadowStart / std::max(1.0, std::hypot(view.a, view.b));
    const double from = std::max(0.0, lambda - back);
    AnyRay ray;
    ray.s = view.s0 + from * view.a;
    ray.t = view.t0 + from * view.b;
    ray.z = 1 - from;
    // A hit that is not exact may lie below the surface, which would then shadow itself.
    if (tools_.tracer.guarantee() != Guarantee::Exact) ray.z = std::max(ray.z, request_.field.at(ray.s, ray.t));
    const glm::dvec3& perS = quad.plane.perS;
    const glm::dvec3& perT = quad.plane.perT;
    const double texel = glm::length(perS);
    // World units towards the light up to the top plane.
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
    Borrowed<ShadowWork> kept;
    auto& [pixels, rays] = *kept;
    pixels.clear();
    rays.resize(static_cast<std::size_t>(kTileWidth) * kTileHeight);
    std::int64_t hit = 0;
    std::int64_t away = 0;
    std::int64_t top = 0;
    std::array<double, kTileWidth> facing;
    overPixels(tile, [&](int x, int y, std::size_t i) {
        if (x == tile.x0) faceLight(tile, y, facing);
        if (hits.outcome[i] != Outcome::Hit) return;
        ++hit;
        const TexturedQuad& quad = frame_.polygons[frame_.rays->polygon[i]];
        if (glm::dot(quad.normal, toLight_) <= 0) {
            // The light is behind the whole polygon.
            shadowed[i] = 1;
            ++away;
            return;
        }
        const bool turned = facing[static_cast<std::size_t>(x - tile.x0)] <= 0;
        away += turned ? 1 : 0;
        // The surface is turned away from the light, so the shadow ray cannot change its colour; without skipping it is
        // traced all the same.
        if (turned && request_.skip) return;
        const AnyRay ray = shadowRay(quad, frame_.rays->rays[i], hits.lambda[i]);
        if (ray.dz > 0) {
            rays.set(pixels.size(), ray);
            pixels.push_back(i);
        } else {
            top += turned ? 0 : 1;
        }
    });
    rays.resize(pixels.size());
    VisibilityBlock results;
    BlockCounts counts;
    if (request_.counts) {
        tools_.query->query(rays, results, counts, work);
    } else {
        NullSink sink;
        tools_.query->query(rays, results, sink, work);
    }
    std::int64_t blocked = 0;
    std::int64_t limits = 0;
    for (std::size_t n = 0; n < pixels.size(); ++n) {
        shadowed[pixels[n]] = results.visibility[n] == Visibility::Blocked ? 1 : 0;
        blocked += results.visibility[n] == Visibility::Blocked ? 1 : 0;
        limits += results.visibility[n] == Visibility::Limit ? 1 : 0;
    }
    totals_.shadowRays += static_cast<std::int64_t>(pixels.size());
    totals_.shadowBlocked += blocked;
    totals_.shadowLimits += limits;
    totals_.shadowHits += hit;
    totals_.shadowAway += request_.skip ? away : 0;
    totals_.shadowTop += top;
    totals_.shadowSteps += static_cast<std::int64_t>(counts.steps);
}

// Writes the cosine between the surface normal and the light for the tile's pixels in row y; values of pixels without a
// hit are unspecified.
void TileWorker::faceLight(const PixelArea& tile, int y, std::span<double> facing) const {
    const HitBlock& hits = frame_.hits->hits;
    const std::vector<std::uint8_t>& polygon = frame_.rays->polygon;
    if (!slopes_) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            facing[static_cast<std::size_t>(x - tile.x0)] =
                glm::dot(glm::dvec3(frame_.normal(x, y, request_)), toLight_);
        }
        return;
    }
    const std::size_t row = frame_.index(tile.x0, y);
    const auto width = static_cast<std::size_t>(tile.x1 - tile.x0);
    for (std::size_t begin = 0, end = 0; begin < width; begin = end) {
        while (end < width && polygon[row + end] == polygon[row + begin]) ++end;
        if (polygon[row + begin] == kNoPolygon) continue;
        facingLight(*slopes_, axes_[polygon[row + begin]], frame_.slabTexels, toLight_,
                    std::span(hits.s).subspan(row + begin, end - begin),
                    std::span(hits.t).subspan(row + begin, end - begin), facing.subspan(begin, end - begin));
    }
}

// Fills the tile's light stage with the sky's colour.
void TileWorker::fillSky(const PixelArea& tile) const {
    for (int y = tile.y0; y < tile.y1; ++y) {
        std::fill_n(buffers_.light->color.row(y - frame_.lit.begin).begin() + tile.x0, tile.x1 - tile.x0, request_.sky);
    }
}

void TileWorker::lightHits(const PixelArea& tile) const {
    const HitBlock& hits = frame_.hits->hits;
    const auto colors = frame_.color->color.pixels();
    const std::vector<std::uint8_t>& shadowed = frame_.shadows->shadowed;
    std::span<Color> out;  // a row of the picture
    std::array<double, kTileWidth> facing{};
    std::array<float, kTileWidth> amount;
    overPixels(tile, [&](int x, int y, std::size_t i) {
        if (x == tile.x0) {
            out = buffers_.light->color.row(y - frame_.lit.begin);
            faceLight(tile, y, facing);
            if (!shadowed.empty()) {
                for (int n = 0; n < tile.x1 - x; ++n) {
                    if (shadowed[i + static_cast<std::size_t>(n)] != 0) facing[static_cast<std::size_t>(n)] = 0;
                }
            }
            for (std::size_t n = 0; n < kTileWidth; ++n) amount[n] = litAmount(facing[n], request_.light);
        }
        switch (hits.outcome[i]) {
            case Outcome::Hit:
                out[static_cast<std::size_t>(x)] = colors[i] * amount[static_cast<std::size_t>(x - tile.x0)];
                break;
            case Outcome::Limit:
                out[static_cast<std::size_t>(x)] = Color(0);
                break;
            default:
                out[static_cast<std::size_t>(x)] = request_.sky;
        }
    });
}

}  // namespace relief
