#include "rendering/edited_tiles.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "filtering/elliptical_options.h"
#include "filtering/grid_stages.h"
#include "rendering/frame_tools.h"

namespace relief {

namespace {

constexpr int kMostSquares = 256;  // along an axis of ChangedTexels
// Texels around a point that its height and its slope depend on, and one for rounding.
constexpr double kAroundPoint = 3;
// Pixels around a tile that count as part of it for the grid filter, which traces rays for it up to grid::kTileHalo and
// half a pixel away. It leaves a pixel to another form if the horizon is closer than (kTileHalo + 1) / 0.75 pixels
// (beforeHorizon() in elliptical_grid.cpp), so none whose surroundings of this size lie before the horizon.
constexpr int kAroundPixel = 6;
static_assert(3 * kAroundPixel >= 4 * (grid::kTileHalo + 1));

// The part of a polygon that a tile sees.
struct Seen {
    TexelRange s, t;  // texels that the tile's rays pass over within the slab
    double side = 0;  // bound of the larger semi-axis of a pixel's footprint, texels
};

TexelRange widened(TexelRange span, double by) {
    return {span.low - by, span.high + by};
}
TexelRange along(TexelRange span, double run) {
    return {span.low + std::min(0.0, run), span.high + std::max(0.0, run)};
}

// Coordinates of points of the top plane lie in [low, high]; those of their rays farther down follow from the eye's.
TexelRange passed(TexelRange entry, double eye, double runPerTexel, int size) {
    const TexelRange top{std::clamp(entry.low, 0.0, static_cast<double>(size)),
                         std::clamp(entry.high, 0.0, static_cast<double>(size))};
    const auto bottom = [&](double at) { return at + (at - eye) * runPerTexel; };
    return {std::min(top.low, bottom(top.low)), std::max(top.high, bottom(top.high))};
}

// around: pixels around the tile that count as part of it.
Seen seenThrough(const VisiblePolygon& polygon, const PixelArea& tile, int around) {
    const Homography& map = polygon.texelFromScreen;
    constexpr double kFar = std::numeric_limits<double>::infinity();
    TexelRange s{kFar, -kFar}, t{kFar, -kFar};
    double leastQ = kFar, mostNumerator = 0;
    for (const double x : {tile.x0 - around, tile.x1 + around}) {
        for (const double y : {tile.y0 - around, tile.y1 + around}) {
            const TexelPoint at = map.at(x, y);
            leastQ = std::min(leastQ, at.q);
            s = {std::min(s.low, at.s), std::max(s.high, at.s)};
            t = {std::min(t.low, at.t), std::max(t.high, at.t)};
            // The derivatives times q^2, which are linear on the screen.
            const double ds = std::hypot(map.sx * at.q - at.s * at.q * map.qx, map.sy * at.q - at.s * at.q * map.qy);
            const double dt = std::hypot(map.tx * at.q - at.t * at.q * map.qx, map.ty * at.q - at.t * at.q * map.qy);
            mostNumerator = std::max(mostNumerator, std::hypot(ds, dt));
        }
    }
    Seen seen;
    // On the screen between points before the horizon, coordinates lie between theirs.
    if (!(leastQ > 0)) s = t = {-kFar, kFar};
    seen.s = passed(s, polygon.sEye, polygon.runPerTexel, polygon.width);
    seen.t = passed(t, polygon.tEye, polygon.runPerTexel, polygon.height);
    seen.side = leastQ > 0 ? mostNumerator / (leastQ * leastQ) * (1 + polygon.runPerTexel) : kFar;
    return seen;
}

// Decides for the tiles of one frame.
class TileTest {
  public:
    TileTest(const FrameRequest& request, const Frame& frame, const VisiblePolygons& visible,
             const ChangedTexels& changed)
        : request_(request), frame_(frame), visible_(visible), changed_(changed) {
        const bool footprints = frame.filter && frame.filter->description().footprint;
        reads_ = !frame.filter                                      ? Reads::Hit
                 : !frame.filter->description().visible             ? (request.color ? Reads::Hit : Reads::Heights)
                 : request.color && frame.filter->readsNeighbours() ? Reads::Neighbours
                                                                    : Reads::Anything;
        if (reads_ == Reads::Heights && !footprints) reads_ = Reads::Hit;
    }

    std::uint32_t stale(const PixelArea& tile, std::uint32_t stages) const {
        std::uint32_t stale = 0;
        for (const VisiblePolygon& polygon : visible_.polygons) {
            if (!sees(tile, polygon.number)) continue;
            stale |= staleThrough(polygon, tile, stages);
            if (stale == stages) break;
        }
        return stale;
    }

  private:
    // What a pixel's colour depends on besides the colour picture: its hit, the heights in its footprint, the hits of
    // the pixels around it, or more.
    enum class Reads : std::uint8_t { Hit, Heights, Neighbours, Anything };

    bool sees(const PixelArea& tile, std::uint8_t polygon) const {
        for (int y = tile.y0; y < tile.y1; ++y) {
            const auto row = frame_.rays->polygon.begin() + static_cast<std::ptrdiff_t>(frame_.index(tile.x0, y));
            if (std::find(row, row + (tile.x1 - tile.x0), polygon) != row + (tile.x1 - tile.x0)) return true;
        }
        return false;
    }

    bool touched(TexelRange s, TexelRange t, double reach) const {
        return changed_.within(widened(s, reach), widened(t, reach), request_.field.address());
    }

    std::uint32_t staleThrough(const VisiblePolygon& polygon, const PixelArea& tile, std::uint32_t stages) const {
        const Seen seen = seenThrough(polygon, tile, 0);
        if (touched(seen.s, seen.t, kAroundPoint)) return stages;
        std::uint32_t stale = 0;
        if (recolors(polygon, tile, seen)) stale |= bit(Stage::Color);
        const glm::dvec3 toLight = lightDirection(request_.light);
        if (request_.shadows && glm::dot(polygon.quad.normal, toLight) > 0) {
            const glm::dvec2 run = lightRun(polygon.quad, toLight, frame_.slabTexels);
            if (touched(along(seen.s, run.x), along(seen.t, run.y), kAroundPoint)) stale |= bit(Stage::Shadows);
        }
        return stale == 0 ? 0 : (stale | bit(Stage::Light)) & stages;
    }

    bool recolors(const VisiblePolygon& polygon, const PixelArea& tile, const Seen& seen) const {
        switch (reads_) {
            case Reads::Hit:
                return false;
            case Reads::Heights:
                return touched(seen.s, seen.t, filterReach(seen.side));
            case Reads::Neighbours: {
                const Seen more = seenThrough(polygon, tile, kAroundPixel);
                const double largest = 4.0 * std::max(request_.field.width(), request_.field.height());
                // Larger footprints are left to another form.
                return !(2 * more.side < largest) || touched(more.s, more.t, kAroundPoint);
            }
            case Reads::Anything:
                break;
        }
        return true;
    }

    // Bound of the distance, in texels along an axis, from a hit to the texels that its footprint reads, on any level.
    double filterReach(double side) const {
        const std::optional<EllipticalSettings> settings = ellipticalSettings(request_.filter);
        // Two bilinear samples on the levels around that of the footprint.
        if (!settings) return 8 * (side + 1);
        const double level = std::max(1.0, side / settings->floor);  // at least a texel of the level
        const double axis = side + level * (0.5 / settings->sigma + settings->smallestMinor());
        // Twice, for samples along both sides of a pixel of another shape.
        return 2 * (std::max(1.0, settings->radius) * axis + 2 * level);
    }

    const FrameRequest& request_;
    const Frame& frame_;
    const VisiblePolygons& visible_;
    const ChangedTexels& changed_;
    Reads reads_ = Reads::Anything;
};

}  // namespace

std::optional<ChangedTexels> ChangedTexels::between(const FloatImage& before, const FloatImage& after) {
    if (before.width() != after.width() || before.height() != after.height()) return std::nullopt;
    ChangedTexels changed;
    changed.width_ = after.width(), changed.height_ = after.height();
    while (std::max(changed.width_, changed.height_) >> changed.shift_ > kMostSquares) ++changed.shift_;
    const auto squares = [&](int texels) { return ((texels - 1) >> changed.shift_) + 1; };
    changed.across_ = squares(changed.width_);
    const auto stride = static_cast<std::size_t>(changed.across_) + 1;
    changed.sums_.assign(stride * (static_cast<std::size_t>(squares(changed.height_)) + 1), 0);
    std::size_t different = 0;
    for (int y = 0; y < changed.height_; ++y) {
        const auto was = before.row(y), is = after.row(y);
        const std::size_t row = stride * static_cast<std::size_t>((y >> changed.shift_) + 1) + 1;
        for (int x = 0; x < changed.width_; ++x) {
            const auto i = static_cast<std::size_t>(x);
            if (std::bit_cast<std::uint32_t>(was[i]) == std::bit_cast<std::uint32_t>(is[i])) continue;
            changed.sums_[row + (i >> changed.shift_)] = 1;
            ++different;
        }
    }
    if (4 * different > after.size()) return std::nullopt;
    for (std::size_t i = stride + 1; i < changed.sums_.size(); ++i) {
        if (i % stride != 0) changed.sums_[i] += changed.sums_[i - 1];
    }
    for (std::size_t i = 2 * stride; i < changed.sums_.size(); ++i) changed.sums_[i] += changed.sums_[i - stride];
    return changed;
}

bool ChangedTexels::within(TexelRange s, TexelRange t, Address address) const {
    // The squares [first, last] of an axis, as one or two ranges.
    struct Ranges {
        int count = 1;
        int first[2], last[2];
    };
    const auto rangesOf = [&](TexelRange span, int size) {
        const auto square = [&](double x) {
            return static_cast<int>(std::clamp(std::floor(x), 0.0, size - 1.0)) >> shift_;
        };
        // Written so that NaN gives the whole axis.
        if (!(span.high - span.low < size)) return Ranges{1, {0}, {(size - 1) >> shift_}};
        if (address != Address::Repeat) return Ranges{1, {square(span.low)}, {square(span.high)}};
        const double turn = std::floor(span.low / size) * size;
        const double low = span.low - turn, high = span.high - turn;
        if (high < size) return Ranges{1, {square(low)}, {square(high)}};
        return Ranges{2, {square(low), 0}, {square(high), square(high - size)}};
    };
    const Ranges across = rangesOf(s, width_), down = rangesOf(t, height_);
    const auto sum = [&](int x, int y) {
        return sums_[static_cast<std::size_t>(y) * (static_cast<std::size_t>(across_) + 1) +
                     static_cast<std::size_t>(x)];
    };
    for (int i = 0; i < across.count; ++i) {
        for (int j = 0; j < down.count; ++j) {
            const int x0 = across.first[i], x1 = across.last[i] + 1, y0 = down.first[j], y1 = down.last[j] + 1;
            if (sum(x1, y1) - sum(x0, y1) - sum(x1, y0) + sum(x0, y0) > 0) return true;
        }
    }
    return false;
}

std::size_t KeptTiles::kept() const {
    return static_cast<std::size_t>(std::count(stale.begin(), stale.end(), 0U));
}

std::optional<KeptTiles> keptTiles(const FrameRequest& request, const HeightField& lastField,
                                   std::shared_ptr<const Frame> last, std::shared_ptr<const FrameBuffers> buffers,
                                   const Frame& frame, const VisiblePolygons& visible, std::uint32_t stale) {
    // Approximate hits may depend on heights far away, by a map or by the error that is allowed; coordinates of rows in
    // float differ from those of the polygon's map.
    const bool local = frame.exactHits && !(request.bounded > 0) && request.mapping == kDirectRows &&
                       request.filter.name != kSupersample && request.field.tiles() == nullptr &&
                       lastField.tiles() == nullptr && !has(stale, Stage::Rays);
    if (!local) return std::nullopt;
    const auto changed = ChangedTexels::between(lastField.heights(), request.field.heights());
    if (!changed) return std::nullopt;
    const TileTest test(request, *last, visible, *changed);
    KeptTiles kept{last, std::move(buffers), {}};
    for (const PixelArea& tile : tilesOf(frame.width, frame.rows)) kept.stale.push_back(test.stale(tile, stale));
    return kept;
}

}  // namespace relief
