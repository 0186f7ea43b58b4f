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

// Returns the ray from just before the hit of pixel i, on its free side (the viewer always sees the front of a wall),
// to the top plane.
AnyRay TileWorker::shadowRay(std::size_t i) const {
    const TexturedQuad& quad = frame_.polygons[frame_.rays->polygon[i]];
    const ViewRay view = frame_.rays->rays[i];
    const double lambda = frame_.hits->hits.lambda[i];
    const double back = kShadowStart / std::max(1.0, std::hypot(view.a, view.b));
    const double from = std::max(0.0, lambda - back);
    AnyRay ray;
    ray.s = view.s0 + from * view.a;
    ray.t = view.t0 + from * view.b;
    ray.z = 1 - from;
    // A hit that is not exact may lie below the surface, which would then shadow itself.
    const bool exact = frame_.exactHits && frame_.hits->by[i] != HitBy::LittleParallax;
    if (!exact) ray.z = std::max(ray.z, request_.field.at(ray.s, ray.t));
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

// Sets the answers of the bounds of the horizon for the tile's pixels in row y. Undecided: without bounds, or where
// facing is not positive.
void TileWorker::boundRow(const PixelArea& tile, int y, std::span<const double> facing,
                          std::span<Horizon> answers) const {
    std::fill(answers.begin(), answers.end(), Horizon::Undecided);
    if (tools_.horizons.empty()) return;
    const HitBlock& hits = frame_.hits->hits;
    const std::size_t row = frame_.index(tile.x0, y);
    overPolygons(tile, y, [&](std::uint8_t polygon, std::size_t begin, std::size_t end) {
        const HorizonBounds* const horizon = tools_.horizons[polygon].get();
        if (horizon == nullptr) return;
        const auto part = [&](const std::vector<double>& column) {
            return std::span(column).subspan(row + begin, end - begin);
        };
        horizon->decide(scene_, part(hits.s), part(hits.t), part(hits.lambda), facing.subspan(begin, end - begin),
                        answers.subspan(begin, end - begin));
    });
}

void TileWorker::castShadows(const PixelArea& tile, const double* facing, Work& work) const {
    if (tools_.query == nullptr) return;
    const HitBlock& hits = frame_.hits->hits;
    std::vector<std::uint8_t>& shadowed = buffers_.shadows->shadowed;
    Borrowed<ShadowWork> kept;
    auto& [pixels, rays] = *kept;
    pixels.clear();
    rays.resize(static_cast<std::size_t>(kTileWidth) * kTileHeight);
    std::int64_t hit = 0, away = 0, top = 0, decided = 0, decidedBlocked = 0;
    std::array<Horizon, kTileWidth> answers;
    std::span<const double> row;  // of `facing`
    overPixels(tile, [&](int x, int y, std::size_t i) {
        if (x == tile.x0) {
            row = {facing + static_cast<std::size_t>(y - tile.y0) * kTileWidth, kTileWidth};
            boundRow(tile, y, row, answers);
        }
        if (hits.outcome[i] != Outcome::Hit) return;
        ++hit;
        const std::uint8_t polygon = frame_.rays->polygon[i];
        if (faces_[polygon] == 0) {
            // The light is behind the whole polygon.
            shadowed[i] = 1;
            ++away;
            return;
        }
        const auto column = static_cast<std::size_t>(x - tile.x0);
        const bool turned = row[column] <= 0;
        away += turned ? 1 : 0;
        // The surface is turned away from the light, so the shadow ray cannot change its colour; without skipping it is
        // traced all the same.
        if (turned && request_.skip) return;
        // A hit that stands for those around it may lie below the surface.
        if (answers[column] != Horizon::Undecided && frame_.hits->by[i] != HitBy::LittleParallax) {
            shadowed[i] = answers[column] == Horizon::Blocked ? 1 : 0;
            ++decided;
            decidedBlocked += shadowed[i];
            return;
        }
        const AnyRay ray = shadowRay(i);
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
    totals_.shadowBounds += decided;
    totals_.shadowBoundsBlocked += decidedBlocked;
    totals_.shadowSteps += static_cast<std::int64_t>(counts.steps);
}

// Writes the cosine between the surface normal and the light for the tile's pixels in row y; values of pixels without a
// hit are unspecified.
void TileWorker::faceLight(const PixelArea& tile, int y, std::span<double> facing) const {
    const HitBlock& hits = frame_.hits->hits;
    if (!sloped_) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            facing[static_cast<std::size_t>(x - tile.x0)] =
                glm::dot(glm::dvec3(frame_.normal(x, y, request_)), toLight_);
        }
        return;
    }
    const std::size_t row = frame_.index(tile.x0, y);
    overPolygons(tile, y, [&](std::uint8_t polygon, std::size_t begin, std::size_t end) {
        facingLight(scene_, axes_[polygon], frame_.slabTexels, toLight_,
                    std::span(hits.s).subspan(row + begin, end - begin),
                    std::span(hits.t).subspan(row + begin, end - begin), facing.subspan(begin, end - begin));
    });
}

// Fills the tile's light stage with the sky's colour.
void TileWorker::fillSky(const PixelArea& tile) const {
    for (int y = tile.y0; y < tile.y1; ++y) {
        std::fill_n(buffers_.light->color.row(y - frame_.lit.begin).begin() + tile.x0, tile.x1 - tile.x0, request_.sky);
    }
}

void TileWorker::shade(const PixelArea& tile, Work& work) const {
    const PixelArea lit{tile.x0, std::max(tile.y0, frame_.lit.begin), tile.x1, std::min(tile.y1, frame_.lit.end)};
    if (!covered(tile)) return timed(Stage::Light, tile, [&] { fillSky(lit); });
    timed(Stage::Color, tile, [&] { colorHits(tile, work); });
    // Shadows and light read the same cosines; whenever shadows are stale, so is the light.
    Borrowed<FacingWork> kept;
    const std::span<double> facing(kept->facing);
    const auto rowOf = [&](int y) {
        return facing.subspan(static_cast<std::size_t>(y - tile.y0) * kTileWidth, kTileWidth);
    };
    timed(Stage::Light, tile, [&] {
        for (int y = tile.y0; y < tile.y1; ++y) faceLight(tile, y, rowOf(y));
    });
    timed(Stage::Shadows, tile,
          [&] { overRayBlocks(tile, [&](const PixelArea& part) { castShadows(part, rowOf(part.y0).data(), work); }); });
    if (lit.y0 < lit.y1) timed(Stage::Light, tile, [&] { lightHits(lit, rowOf(lit.y0).data()); });
}

// facing: rows of kTileWidth, the first for tile.y0.
void TileWorker::lightHits(const PixelArea& tile, const double* facing) const {
    const HitBlock& hits = frame_.hits->hits;
    const auto colors = frame_.color->color.pixels();
    const std::vector<std::uint8_t>& shadowed = frame_.shadows->shadowed;
    std::span<Color> out;  // a row of the picture
    std::array<float, kTileWidth> amount;
    const auto width = static_cast<std::size_t>(tile.x1 - tile.x0);
    overPixels(tile, [&](int x, int y, std::size_t i) {
        if (x == tile.x0) {
            out = buffers_.light->color.row(y - frame_.lit.begin);
            const double* const row = facing + static_cast<std::size_t>(y - tile.y0) * kTileWidth;
            for (std::size_t n = 0; n < width; ++n) amount[n] = litAmount(row[n], request_.light);
            if (!shadowed.empty()) {
                const float dark = litAmount(0, request_.light);
                for (std::size_t n = 0; n < width; ++n) {
                    if (shadowed[i + n] != 0) amount[n] = dark;
                }
            }
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
