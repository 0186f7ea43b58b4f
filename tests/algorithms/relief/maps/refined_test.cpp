// Refined maps against the pointwise definition, evaluated by dense search, and an example that can be followed by
// hand.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "brute_cells.h"
#include "relief/maps/distance_map.h"
#include "relief/maps/refined.h"
#include "relief/methods/distance_options.h"
#include "relief/tracers/point_distances.h"

namespace relief::test {
namespace {

// The pointwise definition: the smallest distance from P to the first hit over all rays that reach P from above without
// an earlier hit. D(P) = min over azimuths u and horizontal distances t of sqrt(t^2 + max(P.z - H(P + t u), t m_h(P,
// u), 0)^2), where m_h is the slope below which a ray was blocked before it reached P. The result is never below the
// true value, apart from sampling: horizons are rounded up; directions and distances are sampled.
class PointForm {
  public:
    PointForm(const HeightField& field, double flattest)
        : field_(field), cells_(field), mMin_(std::tan(flattest * std::numbers::pi / 180)) {
        // Bound on the slope along a line in any patch, from the differences of neighbours along both axes.
        for (int y = -1; y <= field.height(); ++y) {
            for (int x = -1; x <= field.width(); ++x) {
                const double across = std::abs(static_cast<double>(field.texel(x + 1, y) - field.texel(x, y)));
                const double along = std::abs(static_cast<double>(field.texel(x, y + 1) - field.texel(x, y)));
                slope_ = std::max({slope_, across, along});
            }
        }
        slope_ *= std::numbers::sqrt2 * field.slabTexels();
    }

    // z: in the units of the distance, texels above the bottom of the slab.
    double distance(double s, double t, double z, double angle) const {
        const double c = std::cos(angle);
        const double b = std::sin(angle);
        double horizon = mMin_;
        const double slab = field_.slabTexels();
        const double out = walk(s, t, -c, -b, [&](double way, double high, double) {
            if (high > z) horizon = way > 0 ? std::max(horizon, (high - z) / way) : 1e30;
            return way * horizon <= slab - z;
        });
        // Under border a ray that enters outside the picture has already missed.
        return nearest(s, t, z, angle, std::max(horizon, (slab - z) / out));
    }

    // For rays at least as steep as `horizon`; 0 gives the Euclidean distance in that direction.
    double nearest(double s, double t, double z, double angle, double horizon) const {
        const double c = std::cos(angle);
        const double b = std::sin(angle);
        double least = std::max(z - heightAt(s, t), 0.0);
        walk(s, t, c, b, [&](double way, double, double height) {
            const double fall = std::max({z - height, way * horizon, 0.0});
            least = std::min(least, std::hypot(way, fall));
            return way < least;
        });
        return least;
    }

    double heightAt(double s, double t) const { return field_.at(s, t) * field_.slabTexels(); }

  private:
    // Calls body(way, largest height up to the next sample, height there) along a line until it returns false. Returns
    // the smallest horizontal distance at which the line may have left the picture, infinite if it did not.
    template <class Body>
    double walk(double s, double t, double c, double b, const Body& body) const {
        if (field_.surface() == Surface::Columns) {
            std::vector<double> ways = crossings(s, t, c, b);
            for (std::size_t n = 0; n + 1 < ways.size(); ++n) {
                const double middle = 0.5 * (ways[n] + ways[n + 1]);
                if (!cells_.holds(s + middle * c, t + middle * b)) return ways[n];
                const double height = heightAt(s + middle * c, t + middle * b);
                if (!body(ways[n], height, height)) return kNever;
            }
            return kNever;
        }
        constexpr double kStep = 1.0 / 64;
        for (int n = 0; n < 64 * kFar; ++n) {
            const double way = n * kStep;
            if (!cells_.holds(s + way * c, t + way * b)) return std::max(way - kStep, 1e-9);
            const double height = heightAt(s + way * c, t + way * b);
            if (!body(way, height + slope_ * kStep, height)) return kNever;
        }
        return kNever;
    }
    static std::vector<double> crossings(double s, double t, double c, double b) {
        std::vector<double> ways{0};
        for (const auto& [x, d] : {std::pair(s, c), std::pair(t, b)}) {
            if (std::abs(d) < 1e-12) continue;
            for (int n = 0; n < kFar; ++n) {
                const double line = d > 0 ? std::floor(x) + 1 + n : std::ceil(x) - 1 - n;
                ways.push_back((line - x) / d);
            }
        }
        std::sort(ways.begin(), ways.end());
        return ways;
    }

    static constexpr double kNever = std::numeric_limits<double>::infinity();
    static constexpr int kFar = 40;  // texels
    const HeightField& field_;
    BruteCells cells_;
    double mMin_;
    double slope_ = 0;
};

Heights pitsAndWalls(int width, int height, std::uint64_t seed) {
    Random random(seed);
    FloatImage image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool deep = (x / 3 + y / 4) % 2 == 0;
            image(x, y) = static_cast<float>((deep ? 0.05 : 0.85) + 0.15 * random.unit());
        }
    }
    return share(std::move(image));
}

struct Case {
    Surface surface;
    Address address;
    int footprint;
    int layers;
    int horizons;
    int sectors;
};

class Refined : public testing::TestWithParam<Case> {
  protected:
    static constexpr double kFlattest = 20;  // degrees
    Refined() : field_(pitsAndWalls(14, 11, 41), GetParam().surface, GetParam().address, 0.3) {}

    DistanceMap built(DistanceKind kind) const {
        Work work(2);
        DistanceParameters parameters;
        parameters.footprint = GetParam().footprint;
        parameters.layers = GetParam().layers;
        if (kind == DistanceKind::Refined) {
            parameters.flattest = kFlattest;
            parameters.horizons = GetParam().horizons;
            parameters.sectors = GetParam().sectors;
        }
        return buildDistanceMap(kind, parameters, field_, work, &exactHits);
    }
    HeightField field_;
};

TEST_P(Refined, IsNeverBelowItsEuclidean) {
    constexpr double kFloatRounding = 2e-6;
    const DistanceMap plain = built(DistanceKind::EuclideanConservative);
    const DistanceMap map = built(DistanceKind::Refined);
    int larger = 0;
    for (int q = 0; q < GetParam().sectors; ++q) {
        for (int k = 0; k < map.layers(); ++k) {
            for (int by = 0; by < map.ny(); ++by) {
                for (int bx = 0; bx < map.nx(); ++bx) {
                    const float euclidean = plain.at(bx, by, k, 0);
                    const float refined = map.at(bx, by, k, q);
                    if (euclidean < 0) {
                        ASSERT_EQ(refined, euclidean);
                        continue;
                    }
                    const double least = std::min(static_cast<double>(euclidean), map.cap) * (1 - kFloatRounding);
                    ASSERT_GE(refined, least) << bx << ", " << by << ", " << k << ", sector " << q;
                    larger += refined > 1.01F * euclidean ? 1 : 0;
                }
            }
        }
    }
    EXPECT_GT(larger, 0);
}

TEST_P(Refined, IsNeverAboveThePointForm) {
    constexpr int kPoints = 12000;
    constexpr double kNearly = 0.2;  // texels; the smallest difference found for this number of points
    constexpr int kAzimuths = 24;    // per sector
    const DistanceMap map = built(DistanceKind::Refined);
    const PointForm form(field_, kFlattest);
    const BruteCells cells(field_);
    const int sectors = GetParam().sectors;
    Random random(17);
    double tightest = 1e30;
    int looked = 0;
    for (int n = 0; n < kPoints; ++n) {
        const int bx = random.below(map.nx());
        const int by = random.below(map.ny());
        const int k = random.below(map.layers());
        const int sector = random.below(sectors);
        const double bound = static_cast<double>(map.at(bx, by, k, sector));
        if (bound < 0) continue;
        const int f = GetParam().footprint;
        // Every third point is at a corner of the box, or next to it.
        const auto within = [&](int from, int to) {
            const double share = n % 3 == 0 ? (random.below(2) == 0 ? 1e-9 : 1 - 1e-9) : random.unit();
            return from + share * (to - from);
        };
        const double s = within(bx * f, std::min((bx + 1) * f, cells.nx)) - cells.shift;
        const double t = within(by * f, std::min((by + 1) * f, cells.ny)) - cells.shift;
        if (!cells.holds(s, t)) continue;
        const double z = within(k, k + 1) / map.layers() * field_.slabTexels();
        ++looked;
        for (int a = 0; a <= kAzimuths; ++a) {
            const double share = std::clamp(static_cast<double>(a) / kAzimuths, 1e-9, 1 - 1e-9);
            const double angle = 2 * std::numbers::pi * (sector + share) / sectors;
            const double truth = form.distance(s, t, z, angle);
            ASSERT_LE(bound, truth) << "box " << bx << ", " << by << ", " << k << " sector " << sector << " at " << s
                                    << "," << t << "," << z << " angle " << angle;
            tightest = std::min(tightest, truth - bound);
        }
    }
    EXPECT_GT(looked, kPoints / 40);
    EXPECT_LT(tightest, kNearly);
}

INSTANTIATE_TEST_SUITE_P(All, Refined,
                         testing::Values(Case{Surface::Columns, Address::Repeat, 1, 8, 16, 1},
                                         Case{Surface::Columns, Address::Border, 3, 6, 16, 8},
                                         Case{Surface::Columns, Address::Repeat, 4, 8, 16, 8},
                                         Case{Surface::Columns, Address::Border, 1, 8, 12, 6},
                                         Case{Surface::Bilinear, Address::Repeat, 1, 8, 16, 8},
                                         Case{Surface::Bilinear, Address::Border, 1, 8, 16, 1},
                                         Case{Surface::Bilinear, Address::Repeat, 4, 20, 16, 4},
                                         Case{Surface::Bilinear, Address::Border, 3, 20, 32, 16}));

// Columns of heights 7 2 2 2 2 2 2 2 10 in a slab of height 10, C = (4, 6) in the vertical plane. The nearest surface
// is the left wall at distance 3. But a ray that moves left through C falls by at least 45 degrees, since otherwise the
// right wall would have blocked it, so it meets the left wall at a distance of at least 3 sqrt(2). A ray that moves
// right falls by at least 1 in 3 and meets the right wall at 4 sqrt(10) / 3. The smallest remaining distance is that to
// the floor, 4 below.
class WorkedExample : public testing::Test {
  protected:
    static constexpr int kRows = 41;
    WorkedExample() : field_(profile(0.2F, 0), Surface::Columns, Address::Border, 10.0 / 9) {}
    static Heights profile(float floor, int before) {
        FloatImage image(before + 9, kRows, floor);
        for (int y = 0; y < kRows; ++y) {
            image(before, y) = 0.7F;
            image(before + 8, y) = 1.0F;
        }
        return share(std::move(image));
    }
    HeightField field_;
};

TEST_F(WorkedExample, InThePlane) {
    constexpr double kFloatHeights = 1e-6;  // 0.7 and 0.2 as floats, ten times
    const double y = 0.5 * kRows;
    const auto either = [&](const auto& distance) { return std::min(distance(std::numbers::pi), distance(0.0)); };
    const PointForm form(field_, 1);
    EXPECT_NEAR(either([&](double angle) { return form.distance(4, y, 6, angle); }), 4, kFloatHeights);
    EXPECT_NEAR(either([&](double angle) { return form.nearest(4, y, 6, angle, 0); }), 3, kFloatHeights);
    // With a lower floor the walls are nearest. Empty ground in front of them keeps flat rays from entering outside the
    // picture.
    constexpr int kBefore = 12;
    const HeightField deep(profile(0, kBefore), Surface::Columns, Address::Border, 10.0 / (9 + kBefore));
    const PointForm walls(deep, 1);
    EXPECT_NEAR(walls.distance(4 + kBefore, y, 6, std::numbers::pi), 3 * std::numbers::sqrt2, kFloatHeights);
    EXPECT_NEAR(walls.distance(4 + kBefore, y, 6, 0), 4 * std::sqrt(10.0) / 3, kFloatHeights);
}

// The voxel [4, 5] x [6, 7] of the profile, repeated over rows. Its bounds must hold for each of its points, so they
// are smaller than those of C. A ray that moves left fell by 3 over a horizontal distance of at most 4 / cos 22.5
// degrees within a sector of the horizon, which gives 3.65. A ray that moves right at height 7 may pass horizontally
// over the left wall, so only the flattest ray bounds it.
TEST_F(WorkedExample, AsAVoxel) {
    constexpr double kRounding = 1e-5;
    constexpr double kDegree = std::numbers::pi / 180;
    Work work(1);
    DistanceParameters parameters;
    parameters.layers = 10;
    const auto voxel = [&](DistanceKind kind, int sector) {
        return static_cast<double>(
            buildDistanceMap(kind, parameters, field_, work, &exactHits).at(4, kRows / 2, 6, sector));
    };
    EXPECT_NEAR(voxel(DistanceKind::EuclideanConservative, 0), 3, kRounding);
    const double right = 3 / std::cos(10 * kDegree);
    EXPECT_NEAR(voxel(DistanceKind::Refined, 0), right, kRounding);
    parameters.sectors = 8;
    const double left = 3 * std::hypot(1, 3.0 / 4 * std::cos(22.5 * kDegree));
    EXPECT_NEAR(left, 3.65, 0.001);
    // With the centre line of the right wall as the horizon the bound would be 3.61, a fall of 3 over 4.5; the wall's
    // face is nearer.
    EXPECT_GE(left, std::hypot(3, 2));
    for (const int sector : {0, 7}) EXPECT_NEAR(voxel(DistanceKind::Refined, sector), right, kRounding);
    for (const int sector : {3, 4}) EXPECT_NEAR(voxel(DistanceKind::Refined, sector), left, kRounding);
    // Along the walls the floor, 4 below, is nearest.
    for (const int sector : {1, 2, 5, 6}) EXPECT_LE(voxel(DistanceKind::Refined, sector), 4);
}

// The example of the paper's figures: 3 texels to the wall, 4 to the floor for rays from above.
TEST(PointDistances, OfThePapersExample) {
    Work work(1);
    MapCache cache;
    const HeightField field(share(makeRelief("paper-walls", 9, 9, 1)), Surface::Columns, Address::Border, 10.0 / 9);
    const PointDistances found = distancesAt(field, 4, 4.5, 0.6, 10, cache, work);
    constexpr double kRounding = 1e-6;  // of heights in float
    EXPECT_NEAR(found.euclidean, 3, kRounding);
    EXPECT_NEAR(found.s, 1, kRounding);
    EXPECT_NEAR(found.z, 0.6, kRounding);
    EXPECT_NEAR(found.refined, 4, kRounding);
    EXPECT_EQ(found.ray.a, 0);
    EXPECT_EQ(found.ray.b, 0);
    EXPECT_TRUE(found.reached);
    EXPECT_GT(found.blocked, 0);
    // A ray towards the left wall, blocked by the right one, whose top is at the top of the slab.
    EXPECT_LT(found.blockedRay.a, 0);
    EXPECT_LT(found.blockedHit.lambda, 0.4);
    EXPECT_GE(found.blockedHit.s, 8 - kRounding);
    // Inside a wall and on the floor the distance is zero.
    EXPECT_EQ(distancesAt(field, 0.5, 4.5, 0.6, 10, cache, work).refined, 0);
    EXPECT_EQ(distancesAt(field, 4, 4.5, 0.1, 10, cache, work).euclidean, 0);
}

// Every row is the same gentle ramp, thousands of texels below the point.
TEST(PointDistances, TheNearestPointOfEqualRowsLiesInTheSameRow) {
    Work work(1);
    MapCache cache;
    FloatImage ramp(8, 8);
    for (int n = 0; n < 64; ++n) ramp(n % 8, n / 8) = 1e-4F * static_cast<float>(n % 8);
    const HeightField field(share(std::move(ramp)), Surface::Bilinear, Address::Border, 1000);
    for (const double t : {2.75, 4.5, 6.125}) EXPECT_EQ(distancesAt(field, 4, t, 1, 10, cache, work).t, t);
}

// Never smaller than the Euclidean distance.
TEST(PointDistances, RefinedIsNeverTheSmaller) {
    Work work(1);
    MapCache cache;
    Random random(5);
    for (const Surface surface : allSurfaces()) {
        const HeightField field(randomHeights(12, 10, 3), surface, Address::Repeat, 0.5);
        for (int n = 0; n < 40; ++n) {
            const double z = random.between(0.3, 1);
            const PointDistances found = distancesAt(field, random.unit() * 12, random.unit() * 10, z, 10, cache, work);
            EXPECT_GE(found.refined, found.euclidean - 1e-4);
        }
    }
}

}  // namespace
}  // namespace relief::test
