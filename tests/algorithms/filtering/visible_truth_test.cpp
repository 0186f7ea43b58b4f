// elliptical-visible against brute force in long double: which texels of a footprint are hidden from the viewer, by the
// largest height of the surface above the line of sight, and the colour of the visible ones.
#include <gtest/gtest.h>

#include "footprint_truth.h"
#include "rendering/frame.h"

namespace relief::test {
namespace {

using namespace truth;

// A relief by the definition in height_field.h. Under border there is nothing outside the picture.
class Ground {
  public:
    explicit Ground(const HeightField& field)
        : heights_(field.heights()), columns_(field.surface() == Surface::Columns), address_(field.address()) {}

    bool outside(Truth s, Truth t) const {
        return address_ == Address::Border && (s < 0 || t < 0 || s > heights_.width() || t > heights_.height());
    }

    Truth at(Truth s, Truth t) const {
        if (columns_) return texel(static_cast<long>(std::floor(s)), static_cast<long>(std::floor(t)));
        const auto i = static_cast<long>(std::floor(s - 0.5L)), j = static_cast<long>(std::floor(t - 0.5L));
        const Truth u = s - 0.5L - i, v = t - 0.5L - j;
        return (1 - v) * ((1 - u) * texel(i, j) + u * texel(i + 1, j)) +
               v * ((1 - u) * texel(i, j + 1) + u * texel(i + 1, j + 1));
    }
    // Returns true if the position is on a border of columns, where the height jumps; bilinear relief has no jumps.
    bool onALine(Truth place) const { return columns_ && std::abs(place - std::round(place)) < 1e-9L; }
    // Returns the largest height of the surface above the line of sight from (s, t, h) back along the ray; 0 if it is
    // nowhere above; may stop at any value of at least `enough`. Between crossings of the texel lines the surface along
    // the line of sight is a parabola (bilinear) or constant.
    Truth rise(Truth s, Truth t, Truth h, Truth a, Truth b, Truth enough = 1) const {
        std::vector<Truth> ends{0, 1 - h};
        const auto crossings = [&](Truth from, Truth run) {
            const Truth line = columns_ ? 0 : 0.5L;
            const Truth low = std::min(from, from - (1 - h) * run), high = std::max(from, from - (1 - h) * run);
            for (Truth k = std::ceil(low - line); k <= high - line; ++k) {
                if (run != 0) ends.push_back((from - (k + line)) / run);
            }
        };
        crossings(s, a);
        crossings(t, b);
        for (const Truth edge : {Truth{0}, static_cast<Truth>(heights_.width())}) {
            if (a != 0) ends.push_back((s - edge) / a);
        }
        for (const Truth edge : {Truth{0}, static_cast<Truth>(heights_.height())}) {
            if (b != 0) ends.push_back((t - edge) / b);
        }
        std::sort(ends.begin(), ends.end());
        Truth most = 0;
        for (std::size_t n = 0; n + 1 < ends.size() && most < enough; ++n) {
            const Truth from = std::max(ends[n], Truth{0}), to = std::min(ends[n + 1], 1 - h);
            if (!(to > from)) continue;
            const Truth middle = (from + to) / 2;
            if (outside(s - middle * a, t - middle * b)) continue;
            const auto gap = [&](Truth mu) { return at(s - mu * a, t - mu * b) - (h + mu); };
            if (columns_) {
                most = std::max(most, at(s - middle * a, t - middle * b) - (h + from));
                continue;
            }
            const Truth first = gap(from), half = gap(middle), last = gap(to);
            most = std::max({most, first, last});
            // first + p x + c x^2, x from 0 to 1.
            const Truth c = 2 * (first + last - 2 * half), p = last - first - c;
            if (c < 0 && p > 0 && p < -2 * c) most = std::max(most, first - p * p / (4 * c));
        }
        return most;
    }

  private:
    Truth texel(long i, long j) const {
        const auto addressed = [&](long k, int size) {
            return address_ == Address::Repeat ? wrapped(k, size) : static_cast<int>(std::clamp<long>(k, 0, size - 1));
        };
        return static_cast<Truth>(heights_(addressed(i, heights_.width()), addressed(j, heights_.height())));
    }

    const FloatImage& heights_;
    bool columns_;
    Address address_;
};

// Heights between which rounding decides whether a line of sight is free: the library uses 2^-30.
constexpr Truth kSurelyFree = 1e-12L, kSurelyHidden = 1e-6L;

struct View {
    double azimuth, elevation, distance;
};

// Filter queries of the pixels of a frame: the view's rays and their hits on the relief.
std::vector<FilterQuery> queriesOf(const HeightField& field, const View& view) {
    FrameRequest request(field);
    request.width = 40;
    request.height = 30;
    request.camera.azimuth = view.azimuth;
    request.camera.elevation = view.elevation;
    request.camera.distance = view.distance;
    request.method = {"exact", {}};
    request.filter = {"nearest", {}};
    Work work(1);
    FrameRenderer renderer(std::make_shared<MapCache>());
    const auto frame = renderer.render(request, work);
    const VisiblePolygons visible = frame->visible(request);
    std::vector<FilterQuery> all;
    // From afar the floor is only a few pixels wide.
    const int step = view.distance > 2 ? 1 : 3;
    for (int y = 1; y < request.height; y += step) {
        for (int x = 2; x < request.width; x += step) {
            if (auto query = filterQuery(*frame, request, visible, x, y)) {
                query->view = nullptr;  // would point into the frame, which no longer exists
                all.push_back(*query);
            }
        }
    }
    return all;
}

struct Tally {
    int pixels = 0, plain = 0, unsure = 0, nothingSeen = 0;
    int hidden = 0, seen = 0;
    std::map<int, int> levels;
};

enum class Form { Plane, Position, PositionArea };
const char* nameOf(Form form) {
    return form == Form::Plane ? "plane" : form == Form::Position ? "position" : "position-area";
}

// Largest extent, in pixels, of a texel that is not split into parts (surface_pieces.h).
constexpr Truth kWhole = 0.5L;

void expectTruth(Form form, const HeightField& field, const Picture& picture, const std::vector<View>& views,
                 const OptionValues& more, const Settings& settings, const std::function<Truth(Truth square)>& weigh,
                 Tally& tally) {
    constexpr double kColor = 1e-5;  // weights and products are float
    constexpr double kWeight = 1e-5;
    constexpr Truth kTie = 1e-7L;  // relative to r^2: hits are rounded
    const Levels levels(*picture, field.address());
    const Ground ground(field);
    const Truth toFieldX = static_cast<Truth>(field.width()) / picture->width();
    const Truth toFieldY = static_cast<Truth>(field.height()) / picture->height();
    OptionValues options = more;
    options["form"] = nameOf(form);
    options["implementation"] = "scalar";
    MadeFilter made({"elliptical-visible", options}, picture, field, false);
    for (const View& view : views) {
        for (const FilterQuery& query : queriesOf(field, view)) {
            const glm::dvec2 scale(static_cast<double>(1 / toFieldX), static_cast<double>(1 / toFieldY));
            const Jacobian j{query.jacobian.ux * scale.x, query.jacobian.vx * scale.y, query.jacobian.uy * scale.x,
                             query.jacobian.vy * scale.y};
            const glm::dvec2 place = query.place * scale;
            const Footprint f = footprintOf(j, place, settings, levels.top());
            if (f.kind != Kind::Ellipse || f.tie) continue;
            FootprintLog log;
            const Color found = made.at(query, &log);
            ++tally.pixels;
            // Where nothing is hidden and the relief is nearly planar, these forms equal plain filtering.
            if (form != Form::Plane && log.skipped) {
                ++tally.plain;
                continue;
            }
            const Truth texels = std::ldexp(Truth{1}, f.level), reach = settings.radius * settings.radius;
            const Truth a = query.ray.a, b = query.ray.b, h0 = 1 - static_cast<Truth>(query.lambda);
            // Direction of the view ray in texels of the level.
            const Vector run{a / (texels * toFieldX), b / (texels * toFieldY)};
            if (form == Form::Position && field.surface() == Surface::Bilinear) {
                ASSERT_LT(f.square(run), kWhole * kWhole) << "texels would be split";
            }
            if (form == Form::PositionArea) {
                ASSERT_LT(f.square(run), kWhole * kWhole) << "texels would be split";
            }
            const Vector half = f.halfExtents(settings.radius);
            struct Seen {
                Truth weight;
                bool hidden;
                Rgb color;
            };
            std::map<std::pair<long, long>, Seen> expected, beyond;  // keyed by position in 1/1024 texels
            const auto key = [](Truth u, Truth v) { return std::pair(std::lround(1024 * u), std::lround(1024 * v)); };
            Rgb sum{};
            Truth total = 0;
            bool unsure = false, hides = false;
            const Vector box{half.x + std::abs(run.x) + 1, half.y + std::abs(run.y) + 1};
            levels.around(f.level, f.centre, box, [&](const LevelTexel& texel) {
                const Vector offset{texel.centre.x - f.centre.x, texel.centre.y - f.centre.y};
                const Truth s = texel.centre.x * texels * toFieldX, t = texel.centre.y * texels * toFieldY;
                // Between columns rounding decides which height applies.
                unsure = unsure || (ground.onALine(s) || ground.onALine(t));
                const bool outside = ground.outside(s, t);
                if (outside && form != Form::Plane) return;
                const Truth h = ground.at(s, t);
                const Truth moved = form == Form::Plane ? 0 : h - h0;
                const Vector at{offset.x + moved * run.x, offset.y + moved * run.y};
                const Truth square = f.square(at);
                unsure = unsure || std::abs(square / reach - 1) < kTie;
                if (square > reach) return;
                Truth share = texel.size.x * texel.size.y;
                if (form == Form::PositionArea) {
                    const Truth x = texel.size.x * texels * toFieldX / 2, y = texel.size.y * texels * toFieldY / 2;
                    const Truth alongS = (ground.at(s + x, t) - ground.at(s - x, t)) / (2 * x);
                    const Truth alongT = (ground.at(s, t + y) - ground.at(s, t - y)) / (2 * y);
                    share *= 1 + a * alongS + b * alongT;
                    unsure = unsure || std::abs(share) < kTie;
                    if (share <= 0) return;
                }
                const Truth rise = outside ? 0 : ground.rise(s, t, h, a, b, kSurelyHidden);
                unsure = unsure || (rise > kSurelyFree && rise < kSurelyHidden);
                const Seen seen{weigh(square) * share, rise >= kSurelyHidden, levels.texel(f.level, texel.i, texel.j)};
                (outside ? beyond : expected)[key(offset.x, offset.y)] = seen;
                hides = hides || seen.hidden;
            });
            if (unsure) {
                ++tally.unsure;
                continue;
            }
            // Nothing is hidden beyond the border: the texels of the rim are repeated, as in plain filtering.
            if (!hides || form == Form::Plane) expected.merge(beyond);
            for (const auto& [where, seen] : expected) {
                if (seen.hidden) continue;
                for (std::size_t k = 0; k < 3; ++k) sum[k] += seen.weight * seen.color[k];
                total += seen.weight;
            }
            ++tally.levels[f.level];
            ASSERT_EQ(log.footprint.level, f.level);
            ASSERT_EQ(log.texels.size(), expected.size());
            const bool none = !(total > 0);
            ASSERT_EQ(log.allHidden, none);
            tally.nothingSeen += none ? 1 : 0;
            Truth logged = 0;
            for (const FootprintTexel& texel : log.texels) {
                logged += texel.hidden ? 0 : static_cast<Truth>(texel.weight.x);
            }
            for (const FootprintTexel& texel : log.texels) {
                const auto at = expected.find(key(texel.u - log.footprint.centre.x, texel.v - log.footprint.centre.y));
                ASSERT_NE(at, expected.end()) << texel.u << " " << texel.v;
                ASSERT_EQ(texel.hidden, at->second.hidden) << nameOf(form) << " " << texel.u << " " << texel.v;
                (texel.hidden ? tally.hidden : tally.seen) += 1;
                if (none) continue;
                ASSERT_NEAR(static_cast<double>(texel.weight.x / logged),
                            static_cast<double>(at->second.weight / total), kWeight);
            }
            const Rgb colorAtHit = levels.bilinear({place.x, place.y});
            for (std::size_t k = 0; k < 3; ++k) {
                const Truth truth = none ? colorAtHit[k] : sum[k] / total;
                ASSERT_NEAR(found[static_cast<int>(k)], static_cast<double>(truth), kColor)
                    << nameOf(form) << " at " << place.x << " " << place.y;
            }
        }
    }
}

HeightField randomGround(int width, int height, Surface surface, double depth, Address address = Address::Repeat) {
    Random random(21);
    auto heights = std::make_shared<FloatImage>(width, height);
    for (float& value : heights->pixels()) value = static_cast<float>(random.unit());
    return HeightField(heights, surface, address, depth);
}

Settings gaussianSettings(bool exhaustive) {
    Settings settings;
    settings.leastMinor = kCovering / settings.radius;
    settings.exhaustive = exhaustive;
    return settings;
}
Truth gaussianWeight(Truth square) {
    constexpr Truth kSigma = 0.53L;
    return std::exp(-square / (2 * kSigma * kSigma));
}
Settings uniformSettings() {
    Settings settings;
    settings.radius = 0.9L;
    settings.texelSize = false;
    settings.leastMinor = kCovering / settings.radius;
    return settings;
}
Truth uniformWeight(Truth) {
    return 1;
}

// From all sides, low and steep, near (a pixel is about a texel) and far (on higher levels).
const std::vector<View> kTurned{{20, 60, 1.2}, {-75, 25, 1.5}, {130, 15, 1}, {200, 40, 3}, {-20, 35, 6}, {95, 8, 0.9}};

// Over deep relief lines of sight are long, so only a few views are tested.
const std::vector<View> kDeep{{-75, 25, 1.5}, {200, 40, 3}};

void expectMany(const Tally& tally, int hidden, int seen) {
    EXPECT_GT(tally.hidden, hidden);
    EXPECT_GT(tally.seen, seen);
    EXPECT_LT(tally.unsure, tally.pixels / 10);
}

TEST(VisibleTruth, PlaneLeavesOutWhatTheReliefHides) {
    Tally all;
    for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
        Tally tally;
        const HeightField field = randomGround(48, 40, surface, 0.06);
        // For columns the picture has another size, so that no texel's centre lies between two columns.
        const Picture picture = surface == Surface::Bilinear ? randomPicture(48, 40, 22) : randomPicture(64, 64, 22);
        expectTruth(Form::Plane, field, picture, kTurned, {}, gaussianSettings(false), gaussianWeight, tally);
        expectTruth(Form::Plane, field, picture, kTurned, {{"weights", "uniform"}}, uniformSettings(), uniformWeight,
                    tally);
        expectMany(tally, 1000, 1000);
        EXPECT_GT(tally.levels[0], 100);
        EXPECT_GT(tally.levels[1], 50);
        // In deep relief some footprints contain no visible texel.
        expectTruth(Form::Plane, randomGround(48, 40, surface, 0.4), picture, kDeep, {}, gaussianSettings(false),
                    gaussianWeight, all);
    }
    EXPECT_GT(all.nothingSeen, 0);
}

// If the tests find nothing hidden, form=plane gives the bits of plain filtering, also in SIMD.
TEST(VisibleTruth, WhatIsNotHiddenHasThePlainFiltersBits) {
    const HeightField field = randomGround(48, 40, Surface::Bilinear, 0.03);
    const Picture picture = randomPicture(48, 40, 27);
    MadeFilter plain({"elliptical", {}}, picture, field);
    MadeFilter visible({"elliptical-visible", {{"form", "plane"}}}, picture, field, false);
    int free = 0, hidden = 0;
    for (const View& view : kTurned) {
        for (const FilterQuery& query : queriesOf(field, view)) {
            FootprintLog log;
            const FootprintCounts before = visible.counts;
            const Color color = visible.at(query, &log);
            if (visible.counts.hidden > before.hidden) {
                ++hidden;
                continue;
            }
            free += visible.counts.tested > before.tested ? 1 : 0;
            ASSERT_EQ(color, plain.at(query));
        }
    }
    EXPECT_GT(free, 100);
    EXPECT_GT(hidden, 100);
}

// A picture of another size than the height map, neither a power of two.
TEST(VisibleTruth, PicturesFinerThanTheHeights) {
    Tally tally;
    const HeightField field = randomGround(24, 20, Surface::Bilinear, 0.1);
    expectTruth(Form::Plane, field, randomPicture(54, 50, 24), kTurned, {}, gaussianSettings(false), gaussianWeight,
                tally);
    expectMany(tally, 500, 500);
}

// Beyond the rim a clamped relief continues without limit. Under border nothing there can hide or be hidden, and the
// rim's colours are repeated whether or not anything else is hidden.
TEST(VisibleTruth, RimsGoOnOrEnd) {
    for (const Address address : {Address::Clamp, Address::Border}) {
        for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
            Tally tally;
            // With these sides no texel's centre lies between two columns.
            const HeightField field = randomGround(12, 12, surface, 0.2, address);
            const Picture picture = randomPicture(16, 16, 28);
            expectTruth(Form::Plane, field, picture, kTurned, {}, gaussianSettings(false), gaussianWeight, tally);
            expectMany(tally, 300, 300);
        }
    }
}

// The top of each column is at its own position in the pixel.
TEST(VisibleTruth, PositionMovesColumnsToTheirOwnPlaces) {
    Tally tally;
    expectTruth(Form::Position, randomGround(48, 40, Surface::Columns, 0.05), randomPicture(48, 40, 25), kTurned,
                {{"levels", "exhaustive"}}, gaussianSettings(true), gaussianWeight, tally);
    expectMany(tally, 500, 500);
    EXPECT_LT(tally.plain, tally.pixels / 2);
}

// Low relief, so that no texel is split: slopes turned away from the viewer count less, those turned to the viewer
// more.
TEST(VisibleTruth, AreasAreThoseTurnedToTheViewer) {
    Tally tally;
    const HeightField field = randomGround(48, 40, Surface::Bilinear, 0.02);
    const std::vector<View> views{{30, 45, 6}, {-100, 38, 7}, {170, 52, 5}};
    for (const Form form : {Form::Position, Form::PositionArea}) {
        expectTruth(form, field, randomPicture(48, 40, 26), views, {}, gaussianSettings(false), gaussianWeight, tally);
    }
    EXPECT_GT(tally.seen, 500);
    EXPECT_LT(tally.plain, tally.pixels / 2);
    EXPECT_LT(tally.unsure, tally.pixels / 10);
}

// Lines of sight along a slope, over a ridge and next to a wall, with results computed by hand.
TEST(VisibleTruth, LinesOfSightByHand) {
    // One ridge at s = 10.5, one texel wide on either side (bilinear), 0.5 high over ground of 0.2.
    FloatImage heights(32, 8, 0.2F);
    for (int j = 0; j < 8; ++j) heights(10, j) = 0.5F;
    const auto shared = std::make_shared<const FloatImage>(heights);
    const Ground slope(HeightField(shared, Surface::Bilinear)), wall(HeightField(shared, Surface::Columns));
    constexpr double kRounding = 1e-7;  // heights are float
    // The viewer is to the left: from (20.5, 0.2) the line of sight rises by 0.1 per texel; at the ridge it is at 1.2.
    EXPECT_NEAR(static_cast<double>(slope.rise(20.5L, 4, 0.2L, 10, 0)), 0, kRounding);
    // It rises by 0.02 per texel: at the ridge it is at 0.4, which is 0.1 below the top.
    EXPECT_NEAR(static_cast<double>(slope.rise(20.5L, 4, 0.2L, 50, 0)), 0.1, kRounding);
    // The wall's near side is at s = 11, where the line of sight is at 0.2 + 9.5 * 0.02.
    EXPECT_NEAR(static_cast<double>(wall.rise(20.5L, 4, 0.2L, 50, 0)), 0.11, kRounding);
    // In the other direction nothing blocks the view up to the next period's ridge, at 10.5 + 32.
    EXPECT_NEAR(static_cast<double>(slope.rise(20.5L, 4, 0.2L, -50, 0)), 0, kRounding);
    EXPECT_NEAR(static_cast<double>(slope.rise(20.5L, 4, 0.2L, -100, 0)), 0.5 - (0.2 + 22 * 0.01), kRounding);
    // Diagonally, 22 texels in t for each 10 in s: the ridge is as far in s.
    EXPECT_NEAR(static_cast<double>(slope.rise(20.5L, 4, 0.2L, 50, 110)), 0.1, kRounding);
}

}  // namespace
}  // namespace relief::test
