#include "filtering/elliptical_grid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "filtering/grid_tile.h"
#include "relief/block_work.h"
#include "relief/look_up_point.h"

namespace relief {

namespace {

// Second difference of the hits over the first, on a plane; and the same in texels of the picture, which is not seen.
constexpr double kMostBend = 0.1;
constexpr double kUnseenBend = 0.05;
// Hits at one height, but for rounding: level ground, which keeps the pixel's own bits.
constexpr double kLevel = 1e-9;
// Least 1 + r . g of a point's tangent plane: as in elliptical_rays.cpp.
constexpr double kLeastFacing = 1;
// Pixels of a tile along each side, powers of two: as a frame asks them.
constexpr int kTileAcross = 6, kTileDown = 4;

double square(glm::dvec2 v) {
    return v.x * v.x + v.y * v.y;
}

// Derivatives of s and t along the picture, as jacobianAt, with what all points share made once.
struct ViewDerivatives {
    double uxY, ux1, vxY, vx1, uyX, uy1, vyX, vy1;

    explicit ViewDerivatives(const Homography& m)
        : uxY(m.sx * m.qy - m.sy * m.qx),
          ux1(m.sx * m.q1 - m.s1 * m.qx),
          vxY(m.tx * m.qy - m.ty * m.qx),
          vx1(m.tx * m.q1 - m.t1 * m.qx),
          uyX(m.sy * m.qx - m.sx * m.qy),
          uy1(m.sy * m.q1 - m.s1 * m.qy),
          vyX(m.ty * m.qx - m.tx * m.qy),
          vy1(m.ty * m.q1 - m.t1 * m.qy) {}
    // times factor / q^2.
    Jacobian at(double x, double y, double factor) const {
        return {factor * (uxY * y + ux1), factor * (vxY * y + vx1), factor * (uyX * x + uy1), factor * (vyX * x + vy1)};
    }
};

Jacobian onSlope(const Jacobian& j, double a, double b, double slopeS, double slopeT) {
    const double facing = std::max(kLeastFacing, 1 + a * slopeS + b * slopeT);
    const double alongX = (slopeS * j.ux + slopeT * j.vx) / facing;
    const double alongY = (slopeS * j.uy + slopeT * j.vy) / facing;
    return {j.ux - a * alongX, j.vx - b * alongX, j.uy - a * alongY, j.vy - b * alongY};
}

// Through any place of the picture, the polygon going on beyond its edges; for pixels' centres the picture's own ray,
// which never lies outside by more than rounding.
ViewRay rayThrough(const PixelView& view, double x, double y) {
    constexpr double kRounding = 1e-6;  // texels
    const TexelPoint at = view.texelFromScreen.at(x, y);
    const auto off = [](double v, double size) { return std::abs(v - std::clamp(v, 0.0, size)) > kRounding; };
    return off(at.s, view.width) || off(at.t, view.height) ? view.rayAt(at.s, at.t) : view.ray(at);
}

// At least as long as asked for; what was there stays.
template <class T>
void reserve(std::vector<T>& column, std::size_t count) {
    if (column.size() < count) column.resize(count);
}

}  // namespace

GridKernel::GridKernel(EllipticalKernel plain, PointReader reader, RaysKernel alone,
                       std::shared_ptr<const Tracer> tracer, std::shared_ptr<const ConeTwin> twin, int points)
    : plain_(std::move(plain)),
      reader_(std::move(reader)),
      alone_(std::move(alone)),
      tracer_(std::move(tracer)),
      twin_(std::move(twin)),
      lattice_(PointLattice::of(points)) {}

bool GridKernel::serves(const FilterQuery& query) const {
    if (query.view == nullptr || !query.exact) return false;
    const Homography& map = query.view->texelFromScreen;
    const double q = map.denominator(query.x + 0.5, query.y + 0.5);
    // All points that the pixel and its neighbours ask for lie before the horizon.
    constexpr double kLeastOfQ = 0.25;
    if (!(q - (kLatticeHalo + 1) * (std::abs(map.qx) + std::abs(map.qy)) > kLeastOfQ * q)) return false;
    const Jacobian& j = query.jacobian;
    const double largest = 4.0 * std::max(tracer_->field().width(), tracer_->field().height());
    return std::abs(j.ux) + std::abs(j.uy) + std::abs(j.vx) + std::abs(j.vy) < largest;
}

void GridKernel::lay(const FilterBlock& block, Tile& tile) const {
    int x0 = block.x[tile.pixels[0]], x1 = x0, y0 = block.y[tile.pixels[0]], y1 = y0;
    for (const std::size_t i : tile.pixels) {
        x0 = std::min(x0, block.x[i]), x1 = std::max(x1, block.x[i]);
        y0 = std::min(y0, block.y[i]), y1 = std::max(y1, block.y[i]);
    }
    tile.x0 = x0 - kLatticeHalo, tile.y0 = y0 - kLatticeHalo;
    tile.width = x1 - x0 + 1 + 2 * kLatticeHalo, tile.height = y1 - y0 + 1 + 2 * kLatticeHalo;
    const auto cells = static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height);
    tile.centre.assign(cells, kUnknown);
    reserve(tile.place, cells);
    reserve(tile.lambda, cells);
    reserve(tile.ray, cells);
    reserve(tile.color, cells * lattice_.places.size());
    for (const std::size_t i : tile.pixels) {
        const std::size_t cell = tile.cell(block.x[i], block.y[i]);
        tile.centre[cell] = kHit;
        tile.place[cell] = {block.s[i], block.t[i]};
        tile.lambda[cell] = block.lambda[i];
        tile.ray[cell] = block.rays[i];
    }
    for (const std::size_t i : tile.pixels) {
        const std::size_t cell = tile.cell(block.x[i], block.y[i]);
        const auto row = static_cast<std::size_t>(tile.width);
        for (const std::size_t from : {cell - row - 1, cell - 1, cell + row - 1}) {
            for (std::size_t n = from; n < from + 3; ++n) {
                if (tile.centre[n] == kUnknown) tile.centre[n] = kWanted;
            }
        }
    }
}

// tile.hits of the tile.traced of tile.rays; a thread's share at once.
void GridKernel::trace(Tile& tile, Work& work) const {
    for (std::size_t begin = 0; begin < tile.traced.size(); begin += kRayGrain) {
        const std::size_t count = std::min(kRayGrain, tile.traced.size() - begin);
        tile.block.resize(count);
        for (std::size_t n = 0; n < count; ++n) tile.block.set(n, tile.rays[tile.traced[begin + n]]);
        if (twin_) {
            twin_->trace(tile.block, tile.found, *tracer_, work);
        } else {
            NullSink sink;
            tracer_->trace(tile.block, tile.found, sink, work);
        }
        for (std::size_t n = 0; n < count; ++n) tile.hits[tile.traced[begin + n]] = tile.found[n];
    }
}

// Neighbours that are not in the block.
void GridKernel::traceCentres(Tile& tile, Work& work) const {
    tile.traced.clear();
    tile.slots.clear();
    tile.rays.clear();
    tile.overCells([&](std::size_t cell, int x, int y) {
        if (tile.centre[cell] != kWanted) return;
        tile.ray[cell] = rayThrough(*tile.view, x + 0.5, y + 0.5);
        tile.traced.push_back(static_cast<std::uint32_t>(tile.rays.size()));
        tile.slots.push_back(static_cast<std::uint32_t>(cell));
        tile.rays.push_back(tile.ray[cell]);
    });
    reserve(tile.hits, tile.rays.size());
    trace(tile, work);
    for (std::size_t n = 0; n < tile.slots.size(); ++n) {
        const std::size_t cell = tile.slots[n];
        const Hit& hit = tile.hits[n];
        tile.centre[cell] = hit.outcome == Outcome::Hit ? kHit : kMissed;
        if (hit.outcome != Outcome::Hit) continue;
        tile.lambda[cell] = hit.lambda;
        tile.place[cell] = lookUpPoint(tracer_->field(), tile.ray[cell], hit);
    }
}

// Texels of the picture.
bool GridKernel::planeThrough(const FilterQuery& query, const Tile& tile, Jacobian& found) const {
    const std::size_t own = tile.cell(query.x, query.y);
    const auto row = static_cast<std::size_t>(tile.width);
    const std::array<std::size_t, 4> ways{1, row, row + 1, row - 1};
    std::array<glm::dvec2, 4> step;
    bool level = true;
    const glm::dvec2 twice = 2.0 * tile.place[own];
    for (std::size_t n = 0; n < ways.size(); ++n) {
        const std::size_t a = own + ways[n], b = own - ways[n];
        if (tile.centre[a] != kHit || tile.centre[b] != kHit) return false;
        level = level && std::abs(tile.lambda[a] - query.lambda) <= kLevel &&
                std::abs(tile.lambda[b] - query.lambda) <= kLevel;
        step[n] = 0.5 * (tile.place[a] - tile.place[b]) * tile.scale;
        const double bend = 0.25 * square((tile.place[a] + tile.place[b] - twice) * tile.scale);
        if (!(bend <= kMostBend * kMostBend * square(step[n]) + kUnseenBend * kUnseenBend)) return false;
    }
    if (level) {
        found = scaled(query.jacobian, tile.scale);
    } else {
        found = {step[0].x, step[0].y, step[1].x, step[1].y};
    }
    return true;
}

// Points of the pixels that are no plane.
void GridKernel::wantPoints(const FilterBlock& block, Tile& tile) const {
    const std::size_t points = lattice_.places.size();
    tile.state.assign(static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height) * points, kUnknown);
    for (const std::size_t i : tile.edges) {
        for (const PointLattice::Term& term : lattice_.terms) {
            const std::size_t cell = tile.cell(block.x[i] + term.dx, block.y[i] + term.dy);
            tile.state[cell * points + static_cast<std::size_t>(term.point)] = kWanted;
        }
    }
}

void GridKernel::tracePoints(Tile& tile, Work& work) const {
    const std::size_t points = lattice_.places.size();
    tile.traced.clear();
    tile.slots.clear();
    tile.rays.clear();
    tile.at.clear();
    tile.hits.clear();
    tile.overCells([&](std::size_t cell, int x, int y) {
        for (std::size_t k = 0; k < points; ++k) {
            const std::size_t slot = cell * points + k;
            if (tile.state[slot] != kWanted) continue;
            const glm::dvec2 at{x + 0.5 + lattice_.places[k].x, y + 0.5 + lattice_.places[k].y};
            const bool known = k == 0 && tile.centre[cell] != kUnknown;
            if (!known) tile.traced.push_back(static_cast<std::uint32_t>(tile.slots.size()));
            tile.slots.push_back(static_cast<std::uint32_t>(slot));
            tile.at.push_back(at);
            if (known) {
                tile.rays.push_back(tile.ray[cell]);
                const glm::dvec2 place = tile.place[cell];
                tile.hits.push_back(tile.centre[cell] == kHit ? Hit{Outcome::Hit, tile.lambda[cell], place.x, place.y}
                                                              : Hit::none(Outcome::Miss));
            } else {
                tile.rays.push_back(rayThrough(*tile.view, at.x, at.y));
                tile.hits.push_back({});
            }
        }
    });
    trace(tile, work);
}

void GridKernel::colorPoints(Tile& tile, FootprintCounts& counts) const {
    const HeightField& field = tracer_->field();
    const bool bilinear = field.surface() == Surface::Bilinear;
    const Homography& map = tile.view->texelFromScreen;
    const ViewDerivatives derivatives(map);
    tile.points.resize(tile.slots.size());
    tile.colorOf.clear();
    for (std::size_t n = 0; n < tile.slots.size(); ++n) {
        const Hit& hit = tile.hits[n];
        std::uint8_t& state = tile.state[tile.slots[n]];
        state = hit.outcome == Outcome::Hit ? kHit : kMissed;
        if (state != kHit) continue;
        const double x = tile.at[n].x, y = tile.at[n].y, q = map.denominator(x, y);
        Jacobian j = derivatives.at(x, y, lattice_.blur * (1 + hit.lambda * tile.view->runPerTexel) / (q * q));
        glm::dvec2 place{hit.s, hit.t};
        if (bilinear) {
            const auto [slopeS, slopeT] = field.slope(place.x, place.y);
            j = onSlope(j, tile.rays[n].a, tile.rays[n].b, slopeS, slopeT);
        } else {
            place = lookUpPoint(field, tile.rays[n], hit);
        }
        tile.points.set(tile.colorOf.size(), place * tile.scale, scaled(j, tile.scale));
        tile.colorOf.push_back(tile.slots[n]);
    }
    tile.points.resize(tile.colorOf.size());
    reserve(tile.colors, tile.colorOf.size());
    reader_.read(tile.points, {tile.colors.data(), tile.colorOf.size()}, counts);
    for (std::size_t n = 0; n < tile.colorOf.size(); ++n) tile.color[tile.colorOf[n]] = tile.colors[n];
}

Color GridKernel::summed(const FilterQuery& query, const Tile& tile, FootprintCounts& counts) const {
    const std::size_t points = lattice_.places.size();
    Color sum(0);
    float total = 0;
    for (const PointLattice::Term& term : lattice_.terms) {
        const std::size_t slot =
            tile.cell(query.x + term.dx, query.y + term.dy) * points + static_cast<std::size_t>(term.point);
        if (tile.state[slot] != kHit) continue;
        sum += term.weight * tile.color[slot];
        total += term.weight;
    }
    if (total > 0) return sum / total;
    // The pixel's own ray met something all the same.
    ++counts.allHidden;
    return reader_.levels().bilinear(0, query.place * tile.scale, reader_.address());
}

void GridKernel::filterTile(const FilterBlock& block, Tile& tile, std::span<Color> colors, FootprintCounts& counts,
                            Work& work, FootprintLog* log) const {
    lay(block, tile);
    traceCentres(tile, work);
    counts.tested += static_cast<std::int64_t>(tile.traced.size());
    tile.edges.clear();
    tile.plainOf.clear();
    tile.plain.resize(tile.pixels.size());
    for (const std::size_t i : tile.pixels) {
        const FilterQuery query = block[i];
        Jacobian j;
        if (planeThrough(query, tile, j)) {
            tile.plain.place(tile.plainOf.size(), query.place * tile.scale, j);
            tile.plainOf.push_back(i);
        } else {
            tile.edges.push_back(i);
        }
    }
    tile.plain.resize(tile.plainOf.size());
    reserve(tile.colors, tile.plainOf.size());
    const FootprintCounts before = counts;
    if (log != nullptr && !tile.plainOf.empty()) {
        const FilterQuery one = tile.plain[0];
        tile.colors[0] = plain_.filter(one.jacobian, one.place, counts, log);
        log->skipped = true;
    } else {
        plain_.filter(tile.plain, {1, 1}, {tile.colors.data(), tile.plainOf.size()}, counts);
    }
    counts.skipped += counts.texels - before.texels;
    counts.flat += counts.footprints - before.footprints;
    for (std::size_t n = 0; n < tile.plainOf.size(); ++n) colors[tile.plainOf[n]] = tile.colors[n];
    if (tile.edges.empty()) return;
    wantPoints(block, tile);
    tracePoints(tile, work);
    counts.tested += static_cast<std::int64_t>(tile.traced.size());
    colorPoints(tile, counts);
    counts.footprints += static_cast<std::int64_t>(tile.edges.size());
    for (const std::size_t i : tile.edges) colors[i] = summed(block[i], tile, counts);
    if (log == nullptr) return;
    log->footprint = plain_.footprint(scaled(block[0].jacobian, tile.scale), block[0].place * tile.scale);
    log->color = colors[0];
    logPoints(block[0], tile, *log);
}

void GridKernel::filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                        Work& work, FootprintLog* log) const {
    static thread_local Tile tile;
    tile.scale = scale;
    FilterBlock alone;
    std::vector<std::size_t> aloneOf;
    for (std::size_t first = 0; first < block.size() && !work.stopped();) {
        tile.view = block.view[first];
        tile.pixels.clear();
        std::size_t i = first;
        const auto same = [&] {
            return block.view[i] == tile.view && block.x[i] >> kTileAcross == block.x[first] >> kTileAcross &&
                   block.y[i] >> kTileDown == block.y[first] >> kTileDown;
        };
        for (; i < block.size() && same(); ++i) {
            const FilterQuery query = block[i];
            if (serves(query)) {
                tile.pixels.push_back(i);
            } else {
                alone.push(query);
                aloneOf.push_back(i);
            }
        }
        if (!tile.pixels.empty()) filterTile(block, tile, colors, counts, work, log);
        first = i;
    }
    if (aloneOf.empty()) return;
    std::vector<Color> found(aloneOf.size());
    alone_.filter(alone, scale, found, counts, work, log);
    for (std::size_t n = 0; n < aloneOf.size(); ++n) colors[aloneOf[n]] = found[n];
}

}  // namespace relief
