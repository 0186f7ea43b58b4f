// Rays aimed at situations that random rays meet about once in a million. algorithms/relief/margins.md lists for each
// margin the test that fails without it, and the margins for which none does.
#include <algorithm>
#include <bit>
#include <cmath>

#include "lanes.h"
#include "relief/maps/packed_cones.h"
#include "relief/visibility/any_hit.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20261124;
// A hundred times as many with RELIEF_LONG.
std::size_t rayCount() {
    return std::getenv("RELIEF_LONG") != nullptr ? 1'000'000 : 10'000;
}

// Pillars on level ground; a side of each lies on a grid line of the pyramid, on levels 1 to 5 and at the map's ends.
struct Pillars {
    static constexpr int kSide = 64;
    struct Pillar {
        int i, j;
        double height;
    };
    std::vector<Pillar> all;
    Heights heights;

    explicit Pillars(std::uint64_t seed) {
        Random random(seed);
        auto image = std::make_shared<FloatImage>(kSide, kSide, 0.0625F);
        for (int n = 0; n < 60; ++n) {
            const int line = (1 << (1 + random.below(5))) * (1 + random.below(kSide));
            const int i = (line - random.below(2)) % kSide, j = random.below(kSide);
            const auto height = static_cast<float>(random.between(0.3, 0.95));
            (*image)(i, j) = height;
            all.push_back({i, j, static_cast<double>(height)});
        }
        heights = std::move(image);
    }

    // Returns a ray past a corner of a pillar, some units in the last place of a float to either side. For every second
    // ray the height at the corner is that of the pillar, with the same accuracy. cellShift: offset of the cells' lines
    // from the texels' borders.
    ViewRay pastCorner(Random& random, double cellShift) const {
        const Pillar& pillar = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
        const double unit = 0x1p-24;
        const auto units = [&] { return unit * random.below(33) - 16 * unit; };
        const auto run = [&] { return (random.below(2) == 0 ? 1 : -1) * std::exp(random.between(0, 5)); };
        ViewRay ray;
        ray.a = run();
        ray.b = run();
        const bool atTop = random.below(2) == 0;
        const double lambda = atTop ? 1 - pillar.height * (1 + units()) : random.between(0.02, 1 - pillar.height / 2);
        const double x = pillar.i + random.below(2) + cellShift, y = pillar.j + random.below(2) + cellShift;
        ray.s0 = x - lambda * ray.a + units() * std::abs(ray.a);
        ray.t0 = y - lambda * ray.b + units() * std::abs(ray.b);
        return ray;
    }
};

TEST(Margins, pastCornersOfPillars) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    const Pillars pillars(kSeed);
    MapCache cache;
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) {
            const HeightField field(pillars.heights, surface, address, 0.5);
            Random random(kSeed + 1);
            RayBlock rays;
            for (std::size_t i = 0; i < 2 * rayCount(); ++i) {
                rays.push(pillars.pastCorner(random, surface == Surface::Columns ? 0.0 : -0.5 + random.below(2)));
            }
            for (const char* method : {"max-pyramid", "cone"}) expectSameBits(field, {method, {}}, rays, cache);
        }
    }
}

// Plateaus whose heights the packed cones store exactly, and slopes between them: some of their edges are cell lines of
// each level.
Heights terraces(int width, int height, std::uint64_t seed) {
    constexpr int kDepths = 1023;
    Random random(seed);
    FloatImage image(width, height);
    for (float& h : image.pixels()) h = 0;
    for (int n = 0; n < 40; ++n) {
        const int side = 1 << random.below(5);
        const int x0 = side * random.below(width / side), y0 = side * random.below(height / side);
        const auto level = static_cast<float>(static_cast<double>(random.below(kDepths + 1)) / kDepths);
        const int right = std::min(width, x0 + side * (1 + random.below(2)));
        for (int y = y0; y < std::min(height, y0 + side); ++y) {
            for (int x = x0; x < right; ++x) image(x, y) = level;
        }
    }
    image(0, 0) = 0, image(width - 1, height - 1) = 1;
    return share(std::move(image));
}

// Generates rays that hit, or nearly hit, the surface very close to a cell line.
class Aim {
  public:
    Aim(const HeightField& field, std::uint64_t seed) : field_(field), random_(seed) {}

    ViewRay ray() {
        const double s = place(field_.width()), t = place(field_.height());
        const double z = std::clamp(static_cast<double>(field_.at(s, t)) + hair(12), 0.0, 1.0);
        const double lambda = 1 - z;
        ViewRay ray;
        // Starts within the map, or has any slope.
        if (lambda > 0 && random_.below(2) == 0) {
            ray.s0 = place(field_.width()), ray.t0 = place(field_.height());
            ray.a = (s - ray.s0) / lambda, ray.b = (t - ray.t0) / lambda;
            return ray;
        }
        ray.a = run();
        ray.b = random_.below(4) == 0 ? 0 : run();
        ray.s0 = s - lambda * ray.a, ray.t0 = t - lambda * ray.b;
        return ray;
    }
    RayBlock rays(std::size_t count) {
        RayBlock all;
        for (std::size_t i = 0; i < count; ++i) all.push(ray());
        return all;
    }

    // Returns a segment from the surface upwards past such a point.
    AnyRay segment() {
        const double s = place(field_.width()), t = place(field_.height());
        const double z = static_cast<double>(field_.at(s, t)) + hair(12);
        AnyRay ray{place(field_.width()), place(field_.height()), 0, 0, 0, 0};
        ray.z = static_cast<double>(field_.at(ray.s, ray.t));
        const double mu = random_.between(0.1, 1);
        ray.ds = (s - ray.s) / mu, ray.dt = (t - ray.t) / mu, ray.dz = (z - ray.z) / mu;
        return ray;
    }

  private:
    // Of any magnitude; some nearly parallel to an axis.
    double run() {
        const double exponent = random_.below(4) == 0 ? random_.between(-60, -10) : random_.between(-16, 14);
        return (random_.below(2) == 0 ? 1 : -1) * std::exp2(exponent);
    }
    // A small offset of up to 2^-bits in either direction, of any magnitude.
    double hair(int bits) {
        if (random_.below(4) == 0) return 0;
        return (random_.below(2) == 0 ? 1 : -1) * std::exp2(-random_.between(bits, 50));
    }
    double place(int size) {
        if (random_.below(4) == 0) return random_.between(0, size);
        const int step = 1 << random_.below(5);
        const double shift = field_.surface() == Surface::Bilinear ? 0.5 : 0.0;
        return shift + step * random_.below(size / step + 1) + hair(8);
    }

    const HeightField& field_;
    Random random_;
};

// Heights are clamped to `highest`; below 1, traversal begins at that height, inside a cell.
std::vector<HeightField> terraceFields(float highest = 1) {
    std::vector<HeightField> fields;
    FloatImage image = *terraces(96, 64, kSeed);
    for (float& h : image.pixels()) h = std::min(h, highest);
    const Heights heights = share(std::move(image));
    for (const Surface surface : allSurfaces()) {
        for (const Address address : allAddresses()) fields.emplace_back(heights, surface, address, 0.5);
    }
    return fields;
}

TEST(Margins, lanesMeetTerracesAtTheirEdgesAsTheReference) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    MapCache cache;
    for (const HeightField& field : terraceFields()) {
        const RayBlock rays = Aim(field, kSeed).rays(rayCount());
        for (const char* method : {"max-pyramid", "cone"}) expectSameBits(field, {method, {}}, rays, cache);
    }
}

// Most rays hit a plateau at the lambda at which traversal begins, next to a line or to the map's rim.
TEST(Margins, simdStartsNextToLinesAsTheReference) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    MapCache cache;
    for (const HeightField& field : terraceFields(0.375F)) {
        const RayBlock rays = Aim(field, kSeed).rays(rayCount());
        for (const char* method : {"max-pyramid", "cone"}) expectSameBits(field, {method, {}}, rays, cache);
    }
}

// Returns the hits of `exact`, after checking that all exact methods agree.
HitBlock expectAllReferencesAgree(const HeightField& field, const RayBlock& rays, MapCache& cache) {
    static const std::vector<MethodChoice> methods = choicesThatPromise(Guarantee::Exact);
    Work work(2);
    const HitBlock truth = scalarHits(*makeTracer({"exact", {}}, field, cache, work), rays);
    for (const MethodChoice& method : methods) {
        if (!supports(method, field.surface(), field.address())) continue;
        const auto tracer = makeTracer(method, field, cache, work);
        expectSameHits(truth, scalarHits(*tracer, rays), rays, describe(method) + ", " + describe(field));
    }
    return truth;
}

TEST(Margins, referencesMeetTerracesAtTheirEdgesAlike) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    MapCache cache;
    for (const HeightField& field : terraceFields()) {
        const RayBlock rays = Aim(field, kSeed).rays(rayCount() / 2);
        expectAllReferencesAgree(field, rays, cache);
    }
}

// A ray leaves a plateau one unit in the last place above it; the leaf, which rounds the plateau's height up, reports a
// hit. So no traversal may skip that cell.
TEST(Margins, aPlateauThatTheLeafRoundsUpIsNeverSkipped) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    MapCache cache;
    Random random(kSeed);
    std::size_t hits = 0;
    for (int n = 0; n < 40; ++n) {
        FloatImage image(8, 8, 0.0F);
        const auto height = static_cast<float>(random.between(0.5, 0.95));
        image(2, 2) = image(3, 2) = image(2, 3) = image(3, 3) = height;
        const HeightField field(share(std::move(image)), Surface::Bilinear, Address::Clamp, 0.5);
        // Where the ray leaves the plateau's cell.
        const double lambda = 1 - static_cast<double>(height) - 0x1p-53, s = 3.5;
        RayBlock rays;
        for (int k = 0; k < 250; ++k) {
            ViewRay ray;
            ray.a = random.between(2.5, 4), ray.b = random.between(-0.5, 0.5);
            ray.s0 = s - lambda * ray.a, ray.t0 = random.between(2.9, 3.1) - lambda * ray.b;
            rays.push(ray);
        }
        const HitBlock truth = expectAllReferencesAgree(field, rays, cache);
        hits += static_cast<std::size_t>(std::count(truth.lambda.begin(), truth.lambda.end(), lambda));
        for (const char* method : {"max-pyramid", "cone"}) expectSameBits(field, {method, {}}, rays, cache);
    }
    EXPECT_GT(hits, 100U) << "too few to notice anything";
}

// The visited cells may differ, but not the result for the cell that blocks.
TEST(Margins, anyHitQueriesSeeTerracesAtTheirEdgesAlike) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    MapCache cache;
    Work work(2);
    for (const HeightField& field : terraceFields()) {
        Aim aim(field, kSeed);
        AnyRayBlock segments(2 * rayCount());
        for (std::size_t i = 0; i < segments.size(); ++i) segments.set(i, aim.segment());
        BlockCounts counts;
        VisibilityBlock truth;
        makeAnyHit({"max-pyramid-any", {}}, field, cache, work)->query(segments, truth, counts, work);
        const auto blocked = std::count(truth.visibility.begin(), truth.visibility.end(), Visibility::Blocked);
        EXPECT_GT(static_cast<std::size_t>(blocked), segments.size() / 2);
        EXPECT_LT(static_cast<std::size_t>(blocked), segments.size() * 97 / 100);
        const auto expectSame = [&](const VisibilityBlock& results, const char* what) {
            for (std::size_t i = 0; i < segments.size(); ++i) {
                if (results.visibility[i] == truth.visibility[i]) continue;
                const AnyRay ray = segments[i];
                ADD_FAILURE() << what << ", " << describe(field) << ", segment " << i << ": " << numberText(ray.s)
                              << "," << numberText(ray.t) << "," << numberText(ray.z) << "," << numberText(ray.ds)
                              << "," << numberText(ray.dt) << "," << numberText(ray.dz);
                break;
            }
        };
        const auto cones = makeAnyHit({"packed-cone-any", {}}, field, cache, work);
        VisibilityBlock scalar;
        cones->query(segments, scalar, counts, work);
        expectSame(scalar, "packed cones");
        onEveryTarget([&] {
            VisibilityBlock lanes;
            NullSink sink;
            cones->query(segments, lanes, sink, work);
            expectSame(lanes, "packed cones, SIMD");
        });
    }
}

// Returns the height of a wall on level ground for which a packed cone can be exact: the cone of a cell at that gap
// from the wall almost touches the wall's near edge. Only three bits of the slope's mantissa are stored; the bits below
// hold the depths of the cell and of its apex, here those of level ground.
double heightThatFits(double about, double gap) {
    constexpr double kSpare = 1e-6;  // the map's kApexLower, 2^-21, and as much again for rounding
    const auto slope = std::bit_cast<std::uint32_t>(static_cast<float>(about / gap)) | 0xFFFFFU;
    return static_cast<double>(static_cast<float>(std::bit_cast<float>(slope) * gap - kSpare));
}
bool tight(const PackedCones& cones, int x, int y, double height, double gap) {
    constexpr double kTight = 5e-4;  // relative to the slope
    return static_cast<double>(coneSlope(cones.quadrant(0)[cones.index(x, y)])) * gap < height * (1 + kTight);
}

// Rays that hit the top of a distant low wall just before its far side, after a jump over a single cone: a jump that is
// too long by 2^-16 of its length misses the wall. The peak to which depths refer is behind the rays.
TEST(Margins, aLongJumpEndsBeforeTheWall) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    constexpr int kWall = 4096, kBlock = 256;  // at this distance cones are computed from blocks of that many cells
    Random random(kSeed);
    int tightOnes = 0;
    for (int n = 0; n < 40; ++n) {
        const int cell = kBlock * (1 + random.below(7)) - 1;  // the last cell of a block
        const double gap = kWall - (cell + 1), wall = heightThatFits(random.between(0.004, 0.012), gap);
        FloatImage image(kWall + 100, 2, 0.0F);
        for (int y = 0; y < 2; ++y) image(0, y) = 1, image(kWall, y) = static_cast<float>(wall);
        const HeightField field(share(std::move(image)), Surface::Columns, Address::Clamp, 0.5);
        MapCache cache;
        Work work(1);
        if (!tight(*packedCones(field, cache, work), cell, 0, wall, gap)) continue;
        ++tightOnes;
        RayBlock rays;
        for (int i = 0; i < 50; ++i) {
            ViewRay ray{cell + random.unit(), 0.5, 0, 0};
            ray.a = (kWall + 1 - 0.02 * random.unit() - ray.s0) / (1 - wall);
            rays.push(ray);
        }
        expectSameBits(field, {"cone", {}}, rays, cache);
    }
    EXPECT_GE(tightOnes, 20);
}

// Grazing rays that cut a corner off a pillar, two cells after a cone that almost touches it: a jump that ends some
// hundredths of a cell too late misses the pillar.
TEST(Margins, aGrazingJumpEndsBeforeTheCorner) {
    std::printf("seed %llu\n", static_cast<unsigned long long>(kSeed));
    constexpr int kSide = 64, kPillar = 40;
    Random random(kSeed);
    int tightOnes = 0;
    for (int n = 0; n < 40; ++n) {
        const double height = heightThatFits(random.between(0.3, 0.9), 1);
        FloatImage image(kSide, kSide, 0.0F);
        image(kPillar, kPillar) = static_cast<float>(height);
        const HeightField field(share(std::move(image)), Surface::Columns, Address::Repeat, 0.5);
        MapCache cache;
        Work work(1);
        if (!tight(*packedCones(field, cache, work), kPillar - 2, kPillar, height, 1)) continue;
        ++tightOnes;
        RayBlock rays;
        for (int i = 0; i < 100; ++i) {
            ViewRay ray;
            ray.a = random.between(3e4, 6e4), ray.b = ray.a * random.between(0.2, 1);
            // Enters the pillar's cell through its side x = kPillar, very close to the end of that side.
            const double lambda = (1 - height) * (1 + 1e-9 * random.unit());
            ray.s0 = kPillar - lambda * ray.a;
            ray.t0 = kPillar + 1 - std::exp2(-random.between(4, 16)) - lambda * ray.b;
            rays.push(ray);
        }
        expectSameBits(field, {"cone", {}}, rays, cache);
    }
    EXPECT_GE(tightOnes, 20);
}

// Rays side by side that come down to the top of a wall just before its far side. The wall's height is one that packed
// cones store exactly.
TEST(Margins, packetsHitAWallBeforeItsFarSide) {
    constexpr int kWall = 40;
    FloatImage image(64, 64, 0.0F);
    image(0, 0) = 1023 / 1024.0F;
    for (int y = 0; y < 64; ++y) image(kWall, y) = 410 / 1024.0F;
    const double lambda = 1 - 410 / 1024.0;
    RayBlock rays;
    for (int p = 0; p < 64; ++p) {
        const double a = 3 + 0.37 * p;
        for (int k = 0; k < 16; ++k) rays.push({kWall + 1 - (lambda + 1e-10) * a, 32.3 + 0.02 * k, a, 0.01});
    }
    for (const Address address : allAddresses()) {
        MapCache cache;
        const HeightField field(share(FloatImage(image)), Surface::Columns, address, 0.5);
        expectSameBits(field, {"cone", {}}, rays, cache);
        Work work(1);
        const HitBlock hits = scalarHits(*makeTracer({"cone", {}}, field, cache, work), rays);
        EXPECT_EQ(std::ranges::count(hits.lambda, lambda), std::ssize(hits.lambda)) << describe(field);
    }
}

}  // namespace
}  // namespace relief::test
