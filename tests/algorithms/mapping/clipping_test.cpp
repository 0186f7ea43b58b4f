#include "mapping/clipping.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "mapping_cases.h"

namespace relief {
namespace {

using test::directHit;
using test::lookAlong;
using test::Random;
using test::randomView;
using test::View;

using Points = std::vector<glm::dvec2>;

std::string trace(std::uint64_t seed, int n) {
    return "seed " + std::to_string(seed) + ", case " + std::to_string(n);
}

// Counts how often each pixel is covered by all polygons together.
class Coverage {
  public:
    Coverage(std::int64_t width, std::int64_t height)
        : width_(width), height_(height), counts_(static_cast<std::size_t>(width * height), 0) {}
    void add(const Points& polygon) {
        const PixelSpan rows = rowRange(polygon, height_);
        for (std::int64_t row = rows.begin; row < rows.end; ++row) {
            const PixelSpan span = rowSpan(polygon, row, width_);
            for (std::int64_t x = span.begin; x < span.end; ++x) ++counts_[static_cast<std::size_t>(row * width_ + x)];
        }
    }
    int at(std::int64_t x, std::int64_t y) const { return counts_[static_cast<std::size_t>(y * width_ + x)]; }
    // Returns the number of pixels that are not covered exactly once.
    std::int64_t wrong() const {
        return std::count_if(counts_.begin(), counts_.end(), [](int n) { return n != 1; });
    }
    bool operator==(const Coverage&) const = default;

  private:
    std::int64_t width_;
    std::int64_t height_;
    std::vector<int> counts_;
};

glm::dvec2 onBorder(double part, double width, double height) {
    const double at = part * 4.0;
    if (at < 1) return {at * width, 0};
    if (at < 2) return {width, (at - 1) * height};
    if (at < 3) return {(3 - at) * width, height};
    return {0, (4 - at) * height};
}

// Returns a fan of triangles from a point to the screen's border, including its corners; some pairs are replaced by a
// quad and a triangle.
std::vector<Points> randomFan(Random& random, double width, double height, bool onCentres) {
    glm::dvec2 hub(random.real(0.0, width), random.real(0.0, height));
    if (onCentres) hub = glm::floor(hub) + 0.5;
    std::vector<double> places{0.0, 0.25, 0.5, 0.75};
    for (int k = random.whole(0, 12); k > 0; --k) places.push_back(random.real(0.0, 1.0));
    std::sort(places.begin(), places.end());
    std::vector<Points> polygons;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const glm::dvec2 a = onBorder(places[k], width, height);
        const glm::dvec2 b = onBorder(places[(k + 1) % places.size()], width, height);
        if (random.whole(0, 1) == 0) {
            polygons.push_back({hub, a, b});
        } else {  // a quad at the border and a triangle at the centre
            const double part = onCentres ? 0.5 : random.real(0.2, 0.8);
            const glm::dvec2 nearA = hub + part * (a - hub);
            const glm::dvec2 nearB = hub + part * (b - hub);
            polygons.push_back({nearA, a, b, nearB});
            polygons.push_back({nearB, hub, nearA});
        }
        if (random.whole(0, 1) == 1) std::reverse(polygons.back().begin(), polygons.back().end());
    }
    return polygons;
}

TEST(Clipping, FansCoverEachPixelExactlyOnce) {
    constexpr std::uint64_t kSeed = 7;
    Random random(kSeed);
    for (int n = 0; n < 200; ++n) {
        SCOPED_TRACE(trace(kSeed, n));
        const int width = random.whole(1, 90);
        const int height = random.whole(1, 70);
        Coverage coverage(width, height);
        // Every third fan has its centre at a pixel centre, so that many edges run through pixel centres.
        for (const Points& polygon : randomFan(random, width, height, n % 3 == 0)) coverage.add(polygon);
        ASSERT_EQ(coverage.wrong(), 0);
    }
}

// A jittered grid whose points extend beyond the border, so that rows and columns are cut on all four sides.
TEST(Clipping, GridsOfQuadsCoverEachPixelExactlyOnce) {
    constexpr std::uint64_t kSeed = 8;
    Random random(kSeed);
    for (int n = 0; n < 60; ++n) {
        SCOPED_TRACE(trace(kSeed, n));
        const double cell = random.real(0.4, 9.0);
        const double jitter = n % 4 == 0 ? 0.0 : 0.2 * cell;
        std::map<std::pair<int, int>, glm::dvec2> points;
        for (int j = 0; j <= 12; ++j) {
            for (int i = 0; i <= 12; ++i) {
                points[{i, j}] = glm::dvec2(i - 2, j - 2) * cell + random.point(-jitter, jitter);
            }
        }
        const int size = static_cast<int>(std::floor(8.0 * cell));
        Coverage coverage(size, size);
        for (int j = 0; j < 12; ++j) {
            for (int i = 0; i < 12; ++i) {
                coverage.add({points[{i, j}], points[{i + 1, j}], points[{i + 1, j + 1}], points[{i, j + 1}]});
            }
        }
        ASSERT_EQ(coverage.wrong(), 0);
    }
}

TEST(Clipping, FillRuleByHand) {
    // Corners at pixel centres: pixels on the upper and left edges are covered, those on the right and lower edges are
    // not.
    const Points square{{1.5, 1.5}, {4.5, 1.5}, {4.5, 3.5}, {1.5, 3.5}};
    EXPECT_EQ(rowRange(square, 10), (PixelSpan{1, 3}));
    EXPECT_TRUE(rowSpan(square, 0, 10).empty());
    EXPECT_EQ(rowSpan(square, 1, 10), (PixelSpan{1, 4}));
    EXPECT_EQ(rowSpan(square, 2, 10), (PixelSpan{1, 4}));
    EXPECT_TRUE(rowSpan(square, 3, 10).empty());
    EXPECT_EQ(rowSpan(square, 1, 3), (PixelSpan{1, 3}));
    // Empty if the polygon lies between two rows of centres, or wholly outside.
    EXPECT_TRUE(rowRange(Points{{0, 1.6}, {9, 1.6}, {4, 2.4}}, 10).empty());
    EXPECT_TRUE(rowRange(Points{{0, -9}, {9, -9}, {4, -2}}, 10).empty());
    EXPECT_TRUE(rowRange(Points{{0, 29}, {9, 29}, {4, 22}}, 10).empty());
    EXPECT_TRUE(rowSpan(Points{{-9, 0}, {-2, 0}, {-2, 9}}, 4, 10).empty());
    EXPECT_TRUE(rowSpan(Points{{29, 0}, {22, 0}, {22, 9}}, 4, 10).empty());
    // Coordinates far beyond the range of integers.
    const Points huge{{-1e30, -1e30}, {1e30, -1e30}, {1e30, 1e30}, {-1e30, 1e30}};
    EXPECT_EQ(rowRange(huge, 10), (PixelSpan{0, 10}));
    EXPECT_EQ(rowSpan(huge, 5, 10), (PixelSpan{0, 10}));
}

TEST(Clipping, WhollyBehindIsEmptyAndWhollyInFrontIsUnchanged) {
    View view;
    view.camera = lookAlong({0, 0, 5}, {0, 0, -1}, 0.3);
    view.camera.focal = {500, 500};
    const auto corners = view.texelCorners();
    const ClipPolygon front = projectPolygon(view.camera, view.plane, corners);
    const ClipPolygon same = clipToNear(front, 0.1);
    ASSERT_EQ(same.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(same[k].projected, front[k].projected);
    EXPECT_TRUE(clipToNear(front, 5.5).empty());
    view.camera = lookAlong({0, 0, 5}, {0, 0, 1}, 0.3);
    EXPECT_TRUE(clipToNear(projectPolygon(view.camera, view.plane, corners), 0.1).empty());
    EXPECT_TRUE(clipToScreen({}, 100, 100).empty());
    EXPECT_TRUE(clipToNear({}, 0.1).empty());
}

// An edge or a corner in the near plane: a polygon behind it is removed completely, one in front of it gets no
// duplicate corners.
TEST(Clipping, TouchingTheNearPlane) {
    const auto at = [](double x, double y, double depth) {
        return ClipVertex{{x * depth, y * depth, depth}, {x, depth}};
    };
    EXPECT_TRUE(clipToNear(ClipPolygon{at(0, 0, 1), at(5, 0, 1), at(5, 5, 0.5)}, 1.0).empty());
    EXPECT_TRUE(clipToNear(ClipPolygon{at(0, 0, 1), at(5, 0, 0.5), at(5, 5, 0.5)}, 1.0).empty());
    EXPECT_EQ(clipToNear(ClipPolygon{at(0, 0, 1), at(5, 0, 1), at(5, 5, 2)}, 1.0).size(), 3U);
    EXPECT_EQ(clipToNear(ClipPolygon{at(0, 0, 1), at(5, 0, 2), at(5, 5, 0.5)}, 1.0).size(), 3U);
    EXPECT_EQ(clipToNear(ClipPolygon{at(0, 0, 2), at(5, 0, 2), at(5, 5, 0.5)}, 1.0).size(), 4U);
}

// Two polygons with a common edge share the rest of that edge after clipping, bit for bit, in whichever direction each
// lists it.
TEST(Clipping, SharedEdgesStayShared) {
    constexpr std::uint64_t kSeed = 9;
    Random random(kSeed);
    int cut = 0;
    for (int n = 0; n < 500; ++n) {
        SCOPED_TRACE(trace(kSeed, n));
        const View view = randomView(random);
        const double nearDepth = 0.5 * std::abs(view.camera.project(view.plane.at(0, 0)).z) + 1e-3;
        const Points shared{{random.real(0, 1) * view.width, 0}, {random.real(0, 1) * view.width, view.height}};
        const Points left{{0, 0}, shared[0], shared[1], {0, view.height}};
        const Points right{shared[1], shared[0], {view.width, 0}, {view.width, view.height}};
        std::vector<Points> ends;
        for (const Points& side : {left, right}) {
            Points onShared;
            const auto kept =
                clipToScreen(clipToNear(projectPolygon(view.camera, view.plane, side), nearDepth), 1600.0, 1000.0);
            for (const ClipVertex& vertex : kept) {
                const glm::dvec2 d = shared[1] - shared[0];
                const glm::dvec2 e = vertex.texel - shared[0];
                if (std::abs(d.x * e.y - d.y * e.x) < 1e-9 * glm::dot(d, d)) onShared.push_back(vertex.screen());
            }
            std::sort(onShared.begin(), onShared.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
                return std::pair(a.x, a.y) < std::pair(b.x, b.y);
            });
            ends.push_back(onShared);
        }
        if (ends[0].size() != 2 || ends[1].size() != 2) continue;  // the edge is not visible
        ++cut;
        EXPECT_EQ(ends[0], ends[1]);
    }
    EXPECT_GT(cut, 50);
}

struct Seen {
    int pixels = 0;
    int doubtful = 0;
    bool partlyBehind = false;
};

// Compares every pixel of a small screen with its view ray: it is covered exactly if the ray meets the picture beyond
// the near plane, and has the ray's texture coordinates.
Seen compareWithRays(const View& view, double nearDepth, int width, int height) {
    Seen seen;
    const auto corners = view.texelCorners();
    const ClipPolygon whole = projectPolygon(view.camera, view.plane, corners);
    seen.partlyBehind = std::any_of(whole.begin(), whole.end(), [](const ClipVertex& v) { return v.projected.z < 0; });
    const ClipPolygon kept = clipToScreen(clipToNear(whole, nearDepth), width, height);
    const Points screen = screenPoints(kept);
    Coverage coverage(width, height);
    coverage.add(screen);
    const Homography map = fromCameraAndPlane(view.camera, view.plane);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const test::DirectHit hit = directHit(view, x + 0.5, y + 0.5);
            const double s = hit.s / view.width;
            const double t = hit.t / view.height;
            // Distance from the edges of the picture and from the near plane, in parts of the picture; close to zero
            // both results are right.
            const double within = std::min({s, 1 - s, t, 1 - t, hit.depth / nearDepth - 1.0});
            if (std::abs(within) < 1e-7) {
                ++seen.doubtful;
                continue;
            }
            EXPECT_EQ(coverage.at(x, y), within > 0.0 ? 1 : 0) << x << ", " << y;
            if (within < 0.0) continue;
            ++seen.pixels;
            const TexelPoint p = map.at(x + 0.5, y + 0.5);
            EXPECT_GT(p.q, 0.0);
            EXPECT_NEAR(p.s / view.width, s, 1e-9);
            EXPECT_NEAR(p.t / view.height, t, 1e-9);
        }
    }
    for (const ClipVertex& vertex : kept) {  // clipping kept the texture coordinates
        const test::DirectHit hit = directHit(view, vertex.screen().x, vertex.screen().y);
        EXPECT_NEAR(vertex.texel.x / view.width, hit.s / view.width, 1e-7);
        EXPECT_NEAR(vertex.texel.y / view.height, hit.t / view.height, 1e-7);
    }
    return seen;
}

TEST(Clipping, PartlyBehindTheEyeAgreesWithRays) {
    constexpr std::uint64_t kSeed = 10;
    Random random(kSeed);
    int partly = 0;
    std::int64_t pixels = 0;
    std::int64_t doubtful = 0;
    for (int n = 0; n < 400; ++n) {
        SCOPED_TRACE(trace(kSeed, n));
        View view = randomView(random);
        // The eye is above or near the picture, so that most views have corners in front of it and behind it.
        const double size = glm::length(view.plane.perS) * view.width;
        view.camera = lookAlong(view.plane.at(view.width * random.real(0, 1), view.height * random.real(0, 1)) +
                                    size * random.real(0.02, 0.3) * glm::normalize(view.plane.frontNormal()),
                                random.direction(), random.real(0, 6));
        view.camera.focal = {random.real(10, 60), random.real(10, 60)};
        view.camera.principal = {random.real(0, 48), random.real(0, 36)};
        const Seen seen = compareWithRays(view, 1e-3 * size, 48, 36);
        if (::testing::Test::HasFailure()) return;
        partly += seen.partlyBehind && seen.pixels > 0 ? 1 : 0;
        pixels += seen.pixels;
        doubtful += seen.doubtful;
    }
    EXPECT_GT(partly, 100);
    EXPECT_GT(pixels, 50000);
    EXPECT_LT(doubtful, 10);
}

TEST(Clipping, FacingAgrees) {
    constexpr std::uint64_t kSeed = 11;
    Random random(kSeed);
    int fronts = 0;
    int backs = 0;
    for (int n = 0; n < 1000; ++n) {
        SCOPED_TRACE(trace(kSeed, n));
        const View view = randomView(random);
        const auto corners = view.texelCorners();
        const ClipPolygon kept = clipToNear(projectPolygon(view.camera, view.plane, corners), 1e-4);
        if (kept.empty()) continue;
        const bool back = isBackFacing(view.plane, view.camera.eye);
        EXPECT_EQ(isBackFacing(fromCameraAndPlane(view.camera, view.plane)), back);
        EXPECT_EQ(isBackFacing(screenPoints(kept)), back);
        (back ? backs : fronts) += 1;
    }
    EXPECT_GT(fronts, 100);
    EXPECT_GT(backs, 100);
    EXPECT_TRUE(isBackFacing(TexturedPlane{}, {3, 4, 0}));
    EXPECT_FALSE(isBackFacing(TexturedPlane{}, {3, 4, 1}));
    EXPECT_TRUE(isBackFacing(Points{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(Clipping, RowsEndAtTheHorizon) {
    constexpr std::uint64_t kSeed = 12;
    Random random(kSeed);
    int crossed = 0;
    for (int n = 0; n < 2000; ++n) {
        SCOPED_TRACE(trace(kSeed, n));
        const View view = randomView(random);
        const Homography map = fromCameraAndPlane(view.camera, view.plane);
        const std::int64_t row = random.whole(-10, 2000);
        const PixelSpan all{random.whole(-5, 10), random.whole(11, 2000)};
        const double minQ = n % 2 == 0 ? kHorizonQ : random.real(0.0, 0.5);
        const PixelSpan span = clipRowToHorizon(map, row, all, minQ);
        for (std::int64_t x = all.begin; x < all.end; ++x) {
            const bool in = x >= span.begin && x < span.end;
            const double q = map.denominator(static_cast<double>(x) + 0.5, static_cast<double>(row) + 0.5);
            ASSERT_EQ(in, q >= minQ) << "pixel " << x;
        }
        crossed += span.size() > 0 && span.size() < all.size() ? 1 : 0;
    }
    EXPECT_GT(crossed, 100);
    EXPECT_TRUE(clipRowToHorizon(Homography{}, 0, {5, 5}).empty());
}

}  // namespace
}  // namespace relief
