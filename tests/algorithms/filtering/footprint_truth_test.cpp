// Plain elliptical filtering of pixels of rotated cameras, near and far, against sums over all texels in long double:
// level, membership in the ellipse, every texel's weight, and the colour.
#include <numbers>

#include <gtest/gtest.h>

#include "footprint_truth.h"
#include "rendering/pinhole.h"
#include "rendering/scene.h"

namespace relief::test {
namespace {

using namespace truth;

// The arguments of a filter for one pixel.
struct Pixel {
    glm::dvec2 place;
    Jacobian j;
};

// Pixels of a floor, from all sides and at low and steep angles, by cameras from nearby (a texel covers many pixels) to
// far away (a pixel covers the whole picture). Derivatives are computed by the quotient rule.
std::vector<Pixel> cameraPixels(int width, int height) {
    constexpr int kWide = 160, kHigh = 120, kStep = 41;
    const TexturedPlane plane = makeScene(SceneKind::Floor, width, height).front().plane;
    std::vector<Pixel> pixels;
    for (const double distance : {0.08, 0.5, 2.0, 6.0, 25.0, 90.0, 230.0}) {
        for (const auto& [azimuth, elevation] : {std::pair(0.0, 80.0), std::pair(37.0, 40.0), std::pair(115.0, 22.0),
                                                 std::pair(-140.0, 55.0), std::pair(-62.0, 31.0)}) {
            Camera camera;
            camera.azimuth = azimuth;
            camera.elevation = elevation;
            camera.distance = distance;
            const Homography map = fromCameraAndPlane(pinholeCamera(camera, kWide, kHigh), plane);
            for (int y = 9; y < kHigh; y += kStep) {
                for (int x = 7; x < kWide; x += kStep) {
                    const Truth px = x + 0.5L, py = y + 0.5L;
                    const Truth q = map.qx * px + map.qy * py + map.q1;
                    if (!(q > 0)) continue;
                    const Truth s = (map.sx * px + map.sy * py + map.s1) / q;
                    const Truth t = (map.tx * px + map.ty * py + map.t1) / q;
                    const auto over = [&](Truth numerator, Truth at, Truth denominator) {
                        return static_cast<double>((numerator - at * denominator) / q);
                    };
                    pixels.push_back({{static_cast<double>(s), static_cast<double>(t)},
                                      {over(map.sx, s, map.qx), over(map.tx, t, map.qx), over(map.sy, s, map.qy),
                                       over(map.ty, t, map.qy)}});
                }
            }
        }
    }
    return pixels;
}

// Returns the weight of a texel per channel, from its position in the pixel, r^2, and its distance in texels.
using Weigh = std::function<Rgb(Vector pixel, Truth square, Truth texels)>;

Rgb same(Truth weight) {
    return {weight, weight, weight};
}

struct Case {
    std::string name;
    OptionValues options;
    Settings settings;
    Weigh weigh;
    // Returns true if a texel is so close to a discontinuity of the weight (the rim, the edge of a map's cell) that
    // rounding may change its weight.
    std::function<bool(Vector pixel, Truth square)> jumps = [](Vector, Truth) { return false; };
    double weight = 1e-6;  // relative tolerance of a weight in float
};

Weigh gaussian(Truth sigma) {
    return [=](Vector, Truth square, Truth) { return same(std::exp(-square / (2 * sigma * sigma))); };
}

Settings plain(Truth radius, bool texelSize) {
    Settings settings;
    settings.radius = radius;
    settings.texelSize = texelSize;
    settings.leastMinor = kCovering / radius;
    return settings;
}

// Weight of a display's pixel, by its description in pixel_model.h.
Rgb box(Vector p) {
    return same(p.x >= -0.5L && p.x < 0.5L && p.y >= -0.5L && p.y < 0.5L ? 1 : 0);
}
Rgb lcd(Vector p) {
    Rgb weights{};
    const Truth stripe = std::floor((p.x + 0.5L) * 3);
    if (stripe >= 0 && stripe < 3 && p.y >= -0.5L && p.y < 0.5L) weights[static_cast<std::size_t>(stripe)] = 1;
    return weights;
}
Rgb crt(Vector p) {
    constexpr Truth kSigma = 0.25L, kSide = 0.5L;
    const Truth circle = kSide / std::sqrt(Truth{3});
    const Vector spots[3] = {{-kSide / 2, -circle / 2}, {kSide / 2, -circle / 2}, {0, circle}};
    Rgb weights{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector off{p.x - spots[k].x, p.y - spots[k].y};
        weights[k] = std::exp(-dot(off, off) / (2 * kSigma * kSigma));
    }
    return weights;
}

// Stored weights: the cell that contains a position, and the cell's centre.
constexpr int kCells = 48;
struct Cell {
    // centre of the cell in the unit of the position; distance of the position from the cell's edge, in cells
    Truth middle, toEdge;
};
Cell cellOf(Truth place, Truth from, Truth to, int cells) {
    const Truth at = (place - from) / (to - from) * cells, cell = std::floor(at);
    return {from + (cell + 0.5L) / cells * (to - from), std::min(at - cell, cell + 1 - at)};
}
// Tolerance in cells: positions are float, which in a table of 2304 cells is half of this.
constexpr Truth kCellTie = 3e-4L;

Case stored(const std::string& name, OptionValues options, Settings settings, const std::function<Rgb(Vector)>& at) {
    const Truth r = settings.radius;
    Case c{name, std::move(options), settings, {}};
    c.weigh = [=](Vector pixel, Truth, Truth) {
        if (std::abs(pixel.x) >= r || std::abs(pixel.y) >= r) return same(0);
        return at({cellOf(pixel.x, -r, r, kCells).middle, cellOf(pixel.y, -r, r, kCells).middle});
    };
    c.jumps = [=](Vector pixel, Truth) {
        return cellOf(pixel.x, -r, r, kCells).toEdge < kCellTie || cellOf(pixel.y, -r, r, kCells).toEdge < kCellTie;
    };
    return c;
}

Settings shaped(Truth radius, Truth leastMinor) {
    Settings settings;
    settings.radius = radius;
    settings.texelSize = false;
    settings.shaped = true;
    settings.leastMinor = leastMinor;
    // With fewer than two texels across half a pixel the level would be too coarse for the shape.
    settings.floor = std::max(Truth{2}, leastMinor);
    return settings;
}

std::vector<Case> directCases() {
    constexpr Truth kSigma = 0.53L;
    std::vector<Case> cases{
        {"gaussian", {}, plain(2.5L * kSigma, true), gaussian(kSigma)},
        {"uniform", {{"weights", "uniform"}}, plain(0.9L, false), [](Vector, Truth, Truth) { return same(1); }},
        {"texel-distance",
         {{"weights", "texel-distance"}},
         plain(1.15L, false),
         [](Vector, Truth, Truth texels) { return same(1 / (1 + texels)); }},
        {"no texel size", {{"texel-size", "off"}}, plain(2.5L * kSigma, false), gaussian(kSigma)},
        {"sigma", {{"sigma", "0.3"}, {"radius", "2"}}, plain(2, true), gaussian(0.3L)},
        {"levels", {{"anisotropy", "3"}, {"floor", "2.5"}}, plain(2.5L * kSigma, true), gaussian(kSigma)},
    };
    cases[4].settings.sigma = 0.3L;
    cases[5].settings.anisotropy = 3;
    cases[5].settings.floor = 2.5L;
    return cases;
}

std::vector<Case> storedCases() {
    constexpr Truth kSigma = 0.53L, kRadius = 2.5L * kSigma;
    const std::string cells = std::to_string(kCells);
    std::vector<Case> cases;
    cases.push_back(stored("map", {{"source", "map"}, {"resolution", cells}}, plain(kRadius, true), [=](Vector p) {
        const Truth square = dot(p, p);
        return same(square > kRadius * kRadius ? 0 : std::exp(-square / (2 * kSigma * kSigma)));
    }));
    // A table over r^2 with as many entries as a map has cells.
    Case table{"table", {{"source", "table"}, {"resolution", cells}}, plain(kRadius, true), {}};
    constexpr int kEntries = kCells * kCells;
    table.weigh = [=](Vector, Truth square, Truth) {
        return same(std::exp(-cellOf(square, 0, kRadius * kRadius, kEntries).middle / (2 * kSigma * kSigma)));
    };
    table.jumps = [=](Vector, Truth square) {
        return cellOf(square, 0, kRadius * kRadius, kEntries).toEdge < kCellTie;
    };
    cases.push_back(table);
    const Truth corners = 0.7072L, spots = 0.5L / std::sqrt(Truth{3}) + 2.5L * 0.25L;
    cases.push_back(stored("box", {{"weights", "box"}, {"resolution", cells}}, shaped(corners, kCovering * 2), box));
    cases.push_back(stored("lcd", {{"weights", "lcd"}, {"resolution", cells}}, shaped(corners, kCovering * 6), lcd));
    cases.push_back(
        stored("crt", {{"weights", "crt"}, {"resolution", cells}}, shaped(spots, kCovering / (2.5L * 0.25L)), crt));
    return cases;
}

struct Painted {
    int width, height;  // size of the picture
    int across, down;   // size of the height map
    Address address;
};
const std::vector<Painted> kPictures{
    {64, 64, 64, 64, Address::Repeat}, {37, 50, 37, 50, Address::Repeat}, {64, 32, 32, 64, Address::Clamp}};

// Counts how pixels were read, to check that every case occurs.
struct Tally {
    std::map<Kind, int> kinds;
    std::map<int, int> levels;
    int ties = 0;
};

// Compares one implementation of the filter with the truth, over all pixels. tie: relative distance of r^2 from R^2
// within which a texel on the rim may be in or out. weight, color: tolerances.
void expectTruth(const Case& c, const std::string& implementation, Truth tie, double weight, double color,
                 Tally& tally) {
    for (const Painted& painted : kPictures) {
        const Picture picture = randomPicture(painted.width, painted.height, 11);
        const auto heights = std::make_shared<const FloatImage>(painted.across, painted.down, 1.0F);
        OptionValues options = c.options;
        options["implementation"] = implementation;
        MadeFilter made({"elliptical", options}, picture, HeightField(heights, Surface::Bilinear, painted.address));
        const Levels levels(*picture, painted.address);
        const glm::dvec2 scale(static_cast<double>(painted.width) / painted.across,
                               static_cast<double>(painted.height) / painted.down);
        for (const Pixel& pixel : cameraPixels(painted.across, painted.down)) {
            const glm::dvec2 place = pixel.place * scale;
            // Far outside a clamped picture only its rim is seen; such pixels are skipped.
            const bool far = std::abs(place.x) > 3 * painted.width || std::abs(place.y) > 3 * painted.height;
            if (painted.address != Address::Repeat && far) continue;
            const Jacobian j{pixel.j.ux * scale.x, pixel.j.vx * scale.y, pixel.j.uy * scale.x, pixel.j.vy * scale.y};
            const Footprint f = footprintOf(j, place, c.settings, levels.top());
            // Longer footprints are shortened (levelFootprint) and skipped here.
            if (std::hypot(j.ux, j.uy) + std::hypot(j.vx, j.vy) > 4.0 * std::max(painted.width, painted.height))
                continue;
            if (f.kind == Kind::Shape) continue;  // tested below
            FootprintLog log;
            const Color found = made.at(pixel.place, pixel.j, &log);
            Rgb sum{}, total{};
            std::vector<std::pair<Vector, Rgb>> texels;
            bool tied = f.tie;
            if (f.kind == Kind::Ellipse) {
                const Truth reach = c.settings.radius * c.settings.radius;
                const Vector half = f.halfExtents(c.settings.radius);
                levels.around(f.level, f.centre, {half.x + 1, half.y + 1}, [&](const LevelTexel& texel) {
                    const Vector offset{texel.centre.x - f.centre.x, texel.centre.y - f.centre.y};
                    const Truth square = f.square(offset);
                    tied = tied || std::abs(square / reach - 1) < tie;
                    if (square > reach) return;
                    tied = tied || c.jumps(f.pixel(offset), square);
                    Rgb w = c.weigh(f.pixel(offset), square, std::hypot(offset.x, offset.y));
                    for (std::size_t k = 0; k < 3; ++k) {
                        w[k] *= texel.size.x * texel.size.y;
                        sum[k] += w[k] * levels.texel(f.level, texel.i, texel.j)[k];
                        total[k] += w[k];
                    }
                    texels.emplace_back(offset, w);
                });
            } else {
                total = same(1);
                sum = f.kind == Kind::Top ? levels.texel(levels.top(), 0, 0) : levels.bilinear({place.x, place.y});
            }
            // A position between two cells, or on the rim, may be rounded to either side.
            if (tied) {
                ++tally.ties;
                continue;
            }
            ++tally.kinds[f.kind];
            ++tally.levels[f.level];
            const std::string where = c.name + " " + implementation + ", " + std::to_string(painted.width) + " at " +
                                      std::to_string(place.x) + "," + std::to_string(place.y);
            ASSERT_EQ(log.footprint.level, f.level) << where;
            ASSERT_EQ(log.texels.size(), texels.size()) << where;
            Rgb logged{};
            for (const FootprintTexel& texel : log.texels) {
                for (std::size_t k = 0; k < 3; ++k) logged[k] += static_cast<Truth>(texel.weight[static_cast<int>(k)]);
            }
            for (std::size_t n = 0; n < texels.size(); ++n) {
                constexpr double kPlace = 1e-4;  // centres are float in SIMD
                const FootprintTexel& texel = log.texels[n];
                ASSERT_NEAR(texel.u - log.footprint.centre.x, static_cast<double>(texels[n].first.x), kPlace) << where;
                ASSERT_NEAR(texel.v - log.footprint.centre.y, static_cast<double>(texels[n].first.y), kPlace) << where;
                for (std::size_t k = 0; k < 3; ++k) {
                    if (!(total[k] > 0)) continue;
                    ASSERT_NEAR(static_cast<double>(texel.weight[static_cast<int>(k)] / logged[k]),
                                static_cast<double>(texels[n].second[k] / total[k]), weight)
                        << where;
                }
            }
            for (std::size_t k = 0; k < 3; ++k) {
                if (total[k] > 0) {
                    ASSERT_NEAR(found[static_cast<int>(k)], static_cast<double>(sum[k] / total[k]), color) << where;
                }
            }
        }
    }
}

// Weights are float values of at most 1, their sums are double.
constexpr double kScalarWeight = 1e-6, kScalarColor = 2e-6;
// In double hardly any pixel has a texel on the rim.
constexpr Truth kScalarTie = 1e-9L;
// SIMD: levels of 16 bits, the exponential with an error of 1e-5, ellipses in float (lanes_test.cpp).
constexpr double kSimdWeight = 1e-4, kSimdColor = 1e-4;
constexpr Truth kSimdTie = 1e-4L;
// Largest share of pixels that may be skipped because of ties.
constexpr double kMostTies = 0.1;

void expectEveryKind(const Tally& tally, std::initializer_list<Kind> kinds) {
    int pixels = tally.ties;
    for (const auto& [kind, count] : tally.kinds) pixels += count;
    for (const Kind kind : kinds) {
        const auto found = tally.kinds.find(kind);
        EXPECT_GT(found == tally.kinds.end() ? 0 : found->second, 20) << static_cast<int>(kind);
    }
    for (const int level : {0, 1, 2, 3})
        EXPECT_GT(tally.levels.contains(level) ? tally.levels.at(level) : 0, 20) << level;
    EXPECT_LT(tally.ties, kMostTies * pixels);
}

TEST(FootprintTruth, EveryTexelOfTheEllipseHasItsWeight) {
    Tally tally;
    for (const Case& c : directCases()) expectTruth(c, "scalar", kScalarTie, kScalarWeight, kScalarColor, tally);
    expectEveryKind(tally, {Kind::Ellipse, Kind::Bilinear, Kind::Top});
}

TEST(FootprintTruth, TheSimdVersionHasTheSameEllipsesAndWeights) {
    Tally tally;
    for (const Case& c : directCases()) expectTruth(c, "lanes", kSimdTie, kSimdWeight, kSimdColor, tally);
    expectEveryKind(tally, {Kind::Ellipse, Kind::Bilinear, Kind::Top});
}

TEST(FootprintTruth, TablesAndMapsHaveTheWeightOfTheirCells) {
    Tally tally;
    for (const Case& c : storedCases()) expectTruth(c, "scalar", kScalarTie, kScalarWeight, kScalarColor, tally);
    expectEveryKind(tally, {Kind::Ellipse, Kind::Bilinear, Kind::Top});
}

// Tests nearest and bilinear at the pixels' positions, in pictures of the height map's size and of others.
TEST(FootprintTruth, PointFiltersReadTheirTexels) {
    constexpr Truth kBorder = 1e-9L;  // near a border between two texels rounding decides
    int read = 0;
    for (const Painted& painted : kPictures) {
        for (const Address address : {painted.address, Address::Clamp, Address::Border}) {
            const Picture picture = randomPicture(painted.width, painted.height, 13);
            const auto heights = std::make_shared<const FloatImage>(painted.across, painted.down, 1.0F);
            const HeightField field(heights, Surface::Bilinear, address);
            MadeFilter nearest({"nearest", {}}, picture, field), bilinear({"bilinear", {}}, picture, field);
            const Levels levels(*picture, address);
            for (const Pixel& pixel : cameraPixels(painted.across, painted.down)) {
                const Truth x = static_cast<Truth>(pixel.place.x) * painted.width / painted.across;
                const Truth y = static_cast<Truth>(pixel.place.y) * painted.height / painted.down;
                if (std::abs(x - std::round(x)) < kBorder || std::abs(y - std::round(y)) < kBorder) continue;
                const auto at = [&](Truth place, int size) {
                    const auto i = static_cast<long>(std::floor(place));
                    return address == Address::Repeat ? wrapped(i, size)
                                                      : static_cast<int>(std::clamp<long>(i, 0, size - 1));
                };
                ASSERT_EQ(nearest.at(pixel.place, pixel.j), (*picture)(at(x, painted.width), at(y, painted.height)));
                const Color found = bilinear.at(pixel.place, pixel.j);
                const Rgb truth = levels.bilinear({x, y});
                for (std::size_t k = 0; k < 3; ++k) {
                    ASSERT_NEAR(found[static_cast<int>(k)], static_cast<double>(truth[k]), kScalarColor)
                        << x << " " << y;
                }
                ++read;
            }
        }
    }
    EXPECT_GT(read, 500);
}

// Seen from nearby, a display's pixel has its own shape and the picture is bilinear: the result is compared with the
// integral over a fine grid. The filter takes two samples per texel, and at least twelve along a side.
TEST(FootprintTruth, ShapesNearByAreTheirIntegrals) {
    constexpr int kGrid = 48;  // samples along a side; a stripe gets a third of them
    constexpr double kFewPlaces = 0.03;
    const Picture picture = randomPicture(64, 64, 12);
    const Levels levels(*picture, Address::Repeat);
    int shapes = 0;
    const std::vector<Case> cases = storedCases();
    for (const auto& [c, weigh, reach] : {std::tuple(cases[2], &box, 0.5L), std::tuple(cases[3], &lcd, 0.5L),
                                          std::tuple(cases[4], &crt, cases[4].settings.radius)}) {
        MadeFilter made({"elliptical", c.options}, picture, fieldFor(*picture, Address::Repeat));
        const std::vector<Pixel> pixels = cameraPixels(64, 64);
        for (std::size_t n = 0; n < pixels.size(); n += 17) {
            const auto& [place, j] = pixels[n];
            const Footprint f = footprintOf(j, place, c.settings, levels.top());
            if (f.kind != Kind::Shape || f.tie) continue;
            ++shapes;
            Rgb sum{}, total{};
            for (int y = 0; y < kGrid; ++y) {
                for (int x = 0; x < kGrid; ++x) {
                    const Vector at{(2 * x + 1 - kGrid) * reach / kGrid, (2 * y + 1 - kGrid) * reach / kGrid};
                    const Rgb w = weigh(at);
                    const Rgb color =
                        levels.bilinear({place.x + j.ux * at.x + j.uy * at.y, place.y + j.vx * at.x + j.vy * at.y});
                    for (std::size_t k = 0; k < 3; ++k) {
                        sum[k] += w[k] * color[k];
                        total[k] += w[k];
                    }
                }
            }
            const Color found = made.at(place, j);
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(found[static_cast<int>(k)], static_cast<double>(sum[k] / total[k]), kFewPlaces)
                    << c.name << " channel " << k;
            }
        }
    }
    EXPECT_GT(shapes, 30);
}

}  // namespace
}  // namespace relief::test
