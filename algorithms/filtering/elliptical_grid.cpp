#include "filtering/elliptical_grid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <numeric>

#include "filtering/grid_tile.h"
#include "relief/block_work.h"
#include "relief/methods/look_up_point.h"

namespace relief {

namespace {

// Pixels of a tile along each side, powers of two: as a frame asks them.
constexpr int kTileAcross = 6, kTileDown = 5;

// Whether all points that the pixels of a rectangle and their neighbours ask for lie before the horizon. Each side is
// monotone in x and in y, in floating point too: a rectangle is asked as its pixels would be.
bool beforeHorizon(const Homography& map, int x0, int y0, int x1, int y1) {
    constexpr double kPartOfQ = 0.75;
    const double least = (kTileHalo + 1) * (std::abs(map.qx) + std::abs(map.qy));
    const auto holds = [&](int x, int y) { return kPartOfQ * map.denominator(x + 0.5, y + 0.5) > least; };
    return holds(x0, y0) && holds(x1, y0) && holds(x0, y1) && holds(x1, y1);
}

// Of eight cells one after the other (0 or 1 each), whether none is wanted that is not known.
bool nothingNew(const std::uint8_t* wanted, const std::uint8_t* known) {
    std::uint64_t all, old;
    std::memcpy(&all, wanted, sizeof(all));
    std::memcpy(&old, known, sizeof(old));
    return (all & ~old) == 0;
}

}  // namespace

GridKernel::GridKernel(EllipticalKernel plain, PointReader reader, RaysKernel alone,
                       std::shared_ptr<const Tracer> tracer, std::shared_ptr<const PackedConeHits> coneHits, int points)
    : plain_(std::move(plain)),
      reader_(std::move(reader)),
      alone_(std::move(alone)),
      tracer_(std::move(tracer)),
      coneHits_(std::move(coneHits)),
      lattice_(PointLattice::of(points)),
      bounds_(boundsFor(points)) {
    const HeightField& field = tracer_->field();
    if (field.surface() != Surface::Bilinear) return;
    slopes_ = coneHits_ ? SlopeScene(field, coneHits_->cones()) : SlopeScene(field);
}

// All cells that the picture has, row after row.
void GridKernel::layPicture(Tile& tile) {
    const PictureHits& picture = *tile.picture;
    const HitBlock& hits = *picture.hits;
    const int from = std::max(tile.x0, 0), to = std::min(tile.x0 + tile.width, picture.width);
    const auto count = static_cast<std::size_t>(std::max(to - from, 0));
    tile.allKnown = true;
    for (int y = tile.y0; y < tile.y0 + tile.height; ++y) {
        const bool there = picture.hasRow(y) && count > 0;
        tile.allKnown = tile.allKnown && there && count == static_cast<std::size_t>(tile.width);
        if (!there) continue;
        const std::size_t i = picture.at(from, y), cell = tile.cell(from, y);
        const std::uint8_t* polygon = picture.polygon + i;
        const Outcome* outcome = hits.outcome.data() + i;
        int other = 0;
        for (std::size_t n = 0; n < count; ++n)
            other += polygon[n] != tile.view->number || outcome[n] != Outcome::Hit ? 1 : 0;
        if (other == 0) {
            tile.setRow(cell, count, hits.s.data() + i, hits.t.data() + i, hits.lambda.data() + i);
            continue;
        }
        for (std::size_t n = 0; n < count; ++n) {
            const bool known = polygon[n] == tile.view->number;
            tile.known[cell + n] = known ? 1 : 0;
            tile.allKnown = tile.allKnown && known;
            if (known && outcome[n] == Outcome::Hit)
                tile.set(cell + n, hits.s[i + n], hits.t[i + n], hits.lambda[i + n]);
        }
    }
}

// The cells around the tile's pixels, these known, and those that the picture has.
void GridKernel::lay(const FilterBlock& block, Tile& tile) const {
    const std::size_t cells = tile.cells();
    tile.s.assign(cells + kCellSlack, kNothing);
    tile.rough.s.assign(cells + kCellSlack, std::numeric_limits<float>::quiet_NaN());
    reserve(tile.rough.t, cells + kCellSlack);
    reserve(tile.rough.lambda, cells + kCellSlack);
    reserve(tile.t, cells + kCellSlack);
    reserve(tile.lambda, cells);
    reserve(tile.around, cells + kCellSlack);
    reserve(tile.color, (cells + kCellSlack) * lattice_.places.size());
    tile.known.assign(cells, 0);
    tile.wanted.assign(cells, 0);
    tile.allKnown = false;
    if (tile.picture != nullptr && tracer_->field().surface() == Surface::Bilinear) return layPicture(tile);
    for (const std::size_t i : tile.pixels) {
        const std::size_t cell = tile.cell(block.x[i], block.y[i]);
        tile.known[cell] = 1;
        tile.set(cell, block.s[i], block.t[i], block.lambda[i]);
    }
}

// Hits of tile.rays, a thread's share at once.
void GridKernel::trace(Tile& tile, Work& work) const {
    assert(tile.rays.size() <= kRayGrain);
    if (coneHits_) {
        coneHits_->trace(tile.rays, tile.hits, *tracer_, work);
    } else {
        NullSink sink;
        tracer_->trace(tile.rays, tile.hits, sink, work);
    }
}

// Marks the cells up to `reach` from these pixels.
void GridKernel::spread(const FilterBlock& block, std::span<const std::size_t> pixels, int reach, Tile& tile) {
    const auto row = static_cast<std::size_t>(tile.width), rows = static_cast<std::size_t>(tile.height);
    const auto far = static_cast<std::size_t>(reach);
    if (tile.full(pixels.size())) {
        // All within the halo are asked for, and their neighbours.
        const std::size_t rim = static_cast<std::size_t>(kTileHalo - reach);
        for (std::size_t y = rim; y < rows - rim; ++y)
            std::memset(tile.wanted.data() + y * row + rim, 1, row - 2 * rim);
        return;
    }
    tile.own.assign(tile.cells(), 0);
    tile.along.assign(tile.cells(), 0);
    for (const std::size_t i : pixels) tile.own[tile.cell(block.x[i], block.y[i])] = 1;
    // Along rows, then along columns; pixels keep kTileHalo cells from the rim.
    const auto join = [](std::uint8_t* to, const std::uint8_t* from, std::size_t count) {
        for (std::size_t c = 0; c < count; ++c) to[c] |= from[c];
    };
    const std::size_t inner = tile.cells() - 2 * far;
    for (std::size_t n = 0; n <= 2 * far; ++n) join(tile.along.data() + far, tile.own.data() + n, inner);
    for (std::size_t y = 0; y < rows; ++y) {
        const std::size_t last = std::min(y + far, rows - 1);
        for (std::size_t from = y < far ? 0 : y - far; from <= last; ++from) {
            join(tile.wanted.data() + y * row, tile.along.data() + from * row, row);
        }
    }
}

// Centres up to `reach` cells from these pixels: the picture's hits where it has them, or by rays of their own. False:
// all were known. counts.tested: rays.
bool GridKernel::wantCentres(const FilterBlock& block, std::span<const std::size_t> pixels, int reach, Tile& tile,
                             FootprintCounts& counts, Work& work) const {
    if (tile.allKnown) return false;
    spread(block, pixels, reach, tile);
    const HeightField& field = tracer_->field();
    const auto set = [&](std::size_t cell, const ViewRay& ray, const Hit& hit) {
        if (hit.outcome != Outcome::Hit) return;
        const glm::dvec2 place = lookUpPoint(field, ray, hit);
        tile.set(cell, place.x, place.y, hit.lambda);
    };
    bool any = false;
    tile.points.clear();
    const PictureHits* picture = tile.picture;
    std::size_t cell = 0;
    for (int y = tile.y0; y < tile.y0 + tile.height; ++y) {
        const bool rowThere = picture != nullptr && picture->hasRow(y);
        for (int x = tile.x0; x < tile.x0 + tile.width; ++x, ++cell) {
            // Most are known: eight at once.
            while (x + 8 <= tile.x0 + tile.width && nothingNew(&tile.wanted[cell], &tile.known[cell]))
                x += 8, cell += 8;
            if (x == tile.x0 + tile.width) break;
            if (tile.wanted[cell] == 0 || tile.known[cell] != 0) continue;
            tile.known[cell] = 1;
            any = true;
            if (rowThere && x >= 0 && x < picture->width) {
                const std::size_t i = picture->at(x, y);
                if (picture->polygon[i] == tile.view->number) {
                    set(cell, (*picture->rays)[i], (*picture->hits)[i]);
                    continue;
                }
            }
            tile.points.reserve(1);
            tile.points.push(static_cast<std::uint32_t>(cell), {x + 0.5, y + 0.5});
        }
    }
    const GridPoints& traced = tile.points;
    for (std::size_t begin = 0; begin < traced.count; begin += kRayGrain) {
        const std::size_t count = std::min(kRayGrain, traced.count - begin);
        tile.rays.resize(count);
        raysThrough(*tile.view, part(traced.x, begin, count), part(traced.y, begin, count), tile.rays, 0);
        trace(tile, work);
        for (std::size_t n = 0; n < count; ++n) set(traced.slots[begin + n], tile.rays[n], tile.hits[n]);
    }
    counts.tested += static_cast<std::int64_t>(traced.count);
    return any;
}

void GridKernel::findAround(Tile& tile) const {
    findSurroundings({tile.width, tile.height, tile.rough.s.data(), tile.rough.t.data(), tile.rough.lambda.data()},
                     bounds_, tile.around.data());
}

// The pixels that lie on planes, with the planes' Jacobians; the others are edges.
void GridKernel::parted(const FilterBlock& block, Tile& tile) const {
    const auto row = static_cast<std::size_t>(tile.width);
    tile.edges.clear();
    tile.plainOf.clear();
    if (tile.plain.size() < tile.pixels.size()) tile.plain.resize(tile.pixels.size());
    for (const std::size_t i : tile.pixels) {
        const std::size_t own = tile.cell(block.x[i], block.y[i]);
        if ((tile.around[own] & kOnPlane) == 0) {
            tile.edges.push_back(i);
            continue;
        }
        Jacobian j{block.ux[i], block.vx[i], block.uy[i], block.vy[i]};
        if ((tile.around[own] & kOnLevel) == 0) {
            const auto half = [&](const std::vector<double>& column, std::size_t way) {
                return 0.5 * (column[own + way] - column[own - way]);
            };
            j = {half(tile.s, 1), half(tile.t, 1), half(tile.s, row), half(tile.t, row)};
        }
        tile.plain.place(tile.plainOf.size(), glm::dvec2(block.s[i], block.t[i]) * tile.scale, scaled(j, tile.scale));
        tile.plainOf.push_back(i);
    }
}

void GridKernel::filterPlain(Tile& tile, std::span<Color> colors, FootprintCounts& counts, FootprintLog* log) const {
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
}

// Behind tile.footprints those of tile.points.
void GridKernel::layPoints(Tile& tile) const {
    const GridPoints& points = tile.points;
    const auto all = [&](const std::vector<double>& column) { return part(column, 0, points.count); };
    const std::size_t before = tile.footprints.size();
    layFootprints(*tile.view, slopes_ ? &*slopes_ : nullptr, lattice_.blur, tile.scale,
                  {all(points.x), all(points.y), all(points.lambda), all(points.s), all(points.t)}, tile.footprints);
    reserve(tile.slots, tile.footprints.size());
    std::copy_n(points.slots.begin(), points.count, tile.slots.begin() + static_cast<std::ptrdiff_t>(before));
}

// The colours of tile.footprints.
void GridKernel::readPoints(Tile& tile, FootprintCounts& counts) const {
    const PointBlock& block = tile.footprints;
    reader_.read(block, {tile.slots.data(), block.size()}, tile.color.data(), counts);
    if (!tile.logging) return;
    for (std::size_t n = 0; n < block.size(); ++n) {
        tile.read.push_back({tile.slots[n], {block.s[n], block.t[n]}, block.jacobian(n)});
    }
}

void GridKernel::sumEdges(const FilterBlock& block, Tile& tile, std::span<Color> colors,
                          FootprintCounts& counts) const {
    reserve(tile.sums, tile.edges.size());
    sumPoints(tile.color.data(), tile.base, tile.offset, lattice_.weights, tile.sums);
    for (std::size_t n = 0; n < tile.edges.size(); ++n) {
        const std::size_t i = tile.edges[n];
        const auto& [red, green, blue, total] = tile.sums[n].channel;
        if (total > 0) {
            colors[i] = Color(red, green, blue) / total;
        } else {
            // The pixel's own ray met something all the same.
            ++counts.allHidden;
            colors[i] =
                reader_.levels().bilinear(0, glm::dvec2(block.s[i], block.t[i]) * tile.scale, reader_.address());
        }
    }
    counts.footprints += static_cast<std::int64_t>(tile.edges.size());
}

void GridKernel::filterTile(const FilterBlock& block, Tile& tile, std::span<Color> colors, FootprintCounts& counts,
                            Work& work, FootprintLog* log) const {
    lay(block, tile);
    wantCentres(block, tile.pixels, 1, tile, counts, work);
    findAround(tile);
    parted(block, tile);
    filterPlain(tile, colors, counts, log);
    if (tile.edges.empty()) return;
    if (wantCentres(block, tile.edges, kTileHalo, tile, counts, work)) findAround(tile);
    askPoints(block, tile);
    tile.read.clear();
    tile.logging = log != nullptr;
    takeCentres(tile, counts);
    takeMeans(tile);
    takePoints(tile, counts, work);
    sumEdges(block, tile, colors, counts);
    if (log == nullptr) return;
    log->footprint = plain_.footprint(scaled(block[0].jacobian, tile.scale), block[0].place * tile.scale);
    log->color = colors[0];
    logPoints(block[0], tile, *log);
}

// The pixels [first, last) of one view and tile that the grid serves, and the cells around them.
void GridKernel::gather(const FilterBlock& block, std::size_t first, std::size_t last, Tile& tile,
                        std::vector<std::size_t>& alone) const {
    tile.pixels.clear();
    int x0 = block.x[first], x1 = x0, y0 = block.y[first], y1 = y0;
    for (std::size_t i = first; i < last; ++i) {
        x0 = std::min(x0, block.x[i]), x1 = std::max(x1, block.x[i]);
        y0 = std::min(y0, block.y[i]), y1 = std::max(y1, block.y[i]);
    }
    tile.x0 = x0 - kTileHalo, tile.y0 = y0 - kTileHalo;
    tile.width = x1 - x0 + 1 + 2 * kTileHalo, tile.height = y1 - y0 + 1 + 2 * kTileHalo;
    const double largest = 4.0 * std::max(tracer_->field().width(), tracer_->field().height());
    const bool all = tile.view != nullptr && beforeHorizon(tile.view->texelFromScreen, x0, y0, x1, y1);
    const auto sidesOf = [&](std::size_t i) {
        return std::abs(block.ux[i]) + std::abs(block.uy[i]) + std::abs(block.vx[i]) + std::abs(block.vy[i]);
    };
    // Most often all of them.
    if (all && std::memchr(block.exact.data() + first, 0, last - first) == nullptr) {
        std::size_t served = 0;
        for (std::size_t i = first; i < last; ++i) served += sidesOf(i) < largest ? 1 : 0;
        if (served == last - first) {
            tile.pixels.resize(served);
            return std::iota(tile.pixels.begin(), tile.pixels.end(), first);
        }
    }
    for (std::size_t i = first; i < last; ++i) {
        const bool before = all || (tile.view != nullptr && beforeHorizon(tile.view->texelFromScreen, block.x[i],
                                                                          block.y[i], block.x[i], block.y[i]));
        // NaN fails.
        (before && block.exact[i] != 0 && sidesOf(i) < largest ? tile.pixels : alone).push_back(i);
    }
}

void GridKernel::filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                        Work& work, FootprintLog* log) const {
    static thread_local Tile tile;
    tile.scale = scale;
    tile.picture = block.picture;
    std::vector<std::size_t> aloneOf;
    for (std::size_t first = 0; first < block.size() && !work.stopped();) {
        tile.view = block.view[first];
        std::size_t last = first;
        const auto same = [&](std::size_t i) {
            return block.view[i] == tile.view && block.x[i] >> kTileAcross == block.x[first] >> kTileAcross &&
                   block.y[i] >> kTileDown == block.y[first] >> kTileDown;
        };
        while (last < block.size() && same(last)) ++last;
        gather(block, first, last, tile, aloneOf);
        if (!tile.pixels.empty()) filterTile(block, tile, colors, counts, work, log);
        first = last;
    }
    if (aloneOf.empty()) return;
    FilterBlock alone;
    for (const std::size_t i : aloneOf) alone.push(block[i]);
    std::vector<Color> found(aloneOf.size());
    alone_.filter(alone, scale, found, counts, work, log);
    for (std::size_t n = 0; n < aloneOf.size(); ++n) colors[aloneOf[n]] = found[n];
}

}  // namespace relief
