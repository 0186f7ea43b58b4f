// Maps as engines read them: safe cones are proven after rounding, whatever the shader interpolates; rounding to the
// nearest code, published cones and altered codes are refuted by a ray.
#include "measuring/verify/engine_certificate.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "relief/maps/engine_builders.h"
#include "relief/reliefs.h"

namespace relief::test {
namespace {

EngineConventions conventions(int bits, ConeUnit unit, EngineRounding rounding = EngineRounding::Outward) {
    EngineConventions c;
    c.channels = parseEnginePack("R=height,G=cone", "");
    c.bits = bits;
    c.cone.unit = unit;
    c.rounding = rounding;
    return c;
}

EngineMap cones(const HeightField& field, const EngineConventions& c, ConeKind kind = ConeKind::Conservative) {
    Work work(2);
    return buildEngineCones(kind, {}, field, c, 1, work);
}

// Certifies level 0 over the heights that the picture holds.
EngineConeCertificate certified(const EngineMap& map, const HeightField& field, const EngineCheckOptions& options) {
    Work work(2);
    const HeightField drawn(share(*map.heights()), field.surface(), field.address(), field.reliefDepth());
    return certifyEngineCones(drawn, map, 0, options, work);
}

EngineCheckOptions withRays(std::uint64_t rays, ConeFetch fetch = ConeFetch::Bilinear) {
    return {{.rays = rays, .seed = 3}, fetch};
}

// One texel of height 1 on level ground, so that cones are bounded by it alone.
HeightField spike(int width, int height) {
    FloatImage image(width, height);
    image(width / 2, height / 2) = 1;
    return HeightField(share(std::move(image)), Surface::Bilinear, Address::Clamp, 0.5);
}

TEST(EngineCertificate, SafeConesStaySafeAfterRounding) {
    for (const Address address : allAddresses()) {
        for (const int bits : {8, 16, 32}) {
            for (const ConeUnit unit : {ConeUnit::Ratio, ConeUnit::SqrtRatio, ConeUnit::Slope}) {
                const HeightField field(share(makeRelief("bricks", 24, 16, 5)), Surface::Bilinear, address, 0.2);
                const EngineMap map = cones(field, conventions(bits, unit));
                for (const ConeFetch fetch : {ConeFetch::Bilinear, ConeFetch::Nearest}) {
                    const auto options = withRays(1500, fetch);
                    const EngineConeCertificate found = certified(map, field, options);
                    EXPECT_TRUE(found.proven())
                        << describe(field) << " " << bits << " bits " << coneUnitName(unit) << "\n"
                        << engineCertificateText(found, options);
                    EXPECT_EQ(found.texelsInCones, 0U);
                    EXPECT_EQ(found.rays, 1500U);
                }
            }
        }
    }
}

// So wide a map that half a code of 8 bits is more than the four texels by which the cones are conservative.
TEST(EngineCertificate, RoundingToTheNearestIsRefuted) {
    const HeightField field = spike(4096, 3);
    const EngineConeCertificate safe = certified(cones(field, conventions(8, ConeUnit::Ratio)), field, withRays(500));
    EXPECT_TRUE(safe.proven());
    const EngineMap nearest = cones(field, conventions(8, ConeUnit::Ratio, EngineRounding::Nearest));
    const EngineConeCertificate found = certified(nearest, field, withRays(0));
    EXPECT_FALSE(found.safe());
    EXPECT_GT(found.texelsInCones, 100U);
    ASSERT_TRUE(found.first);
    const std::string text = engineCertificateText(found, withRays(0));
    EXPECT_NE(text.find("NOT SAFE\n  first ray: step 1, from the point "), std::string::npos) << text;
    // The same ray, checked by hand: the first step ends behind the spike, in whose side the ray is.
    const ViewRay& ray = found.first->ray;
    const double run = std::abs(ray.a), away = std::abs(field.width() / 2 + 0.5 - ray.s0);
    const auto code = static_cast<double>((*nearest.channel(EngineRole::Cone))(static_cast<int>(ray.s0), 1));
    EXPECT_GT(code * 4096 / (code * 4096 + run) * run, away);
    EXPECT_LT(1 - away / run, 1.0);
}

TEST(EngineCertificate, ConesAsPublishedAreRefuted) {
    const HeightField field(share(makeRelief("bricks", 48, 48, 5)), Surface::Bilinear, Address::Repeat, 0.2);
    for (const ConeKind kind : {ConeKind::Dummer, ConeKind::Relaxed}) {
        EngineConventions c = conventions(8, ConeUnit::SqrtRatio);
        c.relaxed = kind == ConeKind::Relaxed;
        const EngineConeCertificate found = certified(cones(field, c, kind), field, withRays(60'000));
        EXPECT_FALSE(found.safe()) << coneKindName(kind);
        EXPECT_EQ(found.bounds.has_value(), kind == ConeKind::Dummer);
        EXPECT_FALSE(found.first->where.empty());
    }
}

// The corrected relaxed cones let far fewer rays pass, but some: they are compared with texels, not with points
// between.
TEST(EngineCertificate, CorrectedRelaxedConesAreRefutedMoreRarely) {
    const HeightField field(share(makeRelief("spikes", 64, 64, 5)), Surface::Bilinear, Address::Repeat, 0.1);
    EngineConventions c = conventions(16, ConeUnit::SqrtRatio);
    c.relaxed = true;
    const auto overshoots = [&](ConeKind kind) {
        return certified(cones(field, c, kind), field, withRays(60'000)).overshoots;
    };
    const std::uint64_t published = overshoots(ConeKind::Relaxed), corrected = overshoots(ConeKind::RelaxedRobust);
    EXPECT_GT(published, 50 * corrected) << corrected;
    EXPECT_GT(corrected, 0U);
}

// Without a ray that shows it, a cone without proof decides nothing.
TEST(EngineCertificate, AlteredCodesAreFound) {
    const HeightField field = spike(32, 24);
    EngineMap map = cones(field, conventions(8, ConeUnit::Ratio));
    FloatImage& codes = map.levels[0].channels[1];
    const float before = codes(3, 12);
    codes(3, 12) = codeAbove(before, 8);
    const EngineConeCertificate doubtful = certified(map, field, withRays(0));
    EXPECT_EQ(doubtful.bounds->open, 2U) << "those of the texel's four cells that are nearer to the spike";
    EXPECT_TRUE(doubtful.safe());
    EXPECT_FALSE(doubtful.proven());
    EXPECT_NE(engineCertificateText(doubtful, withRays(0)).find("not decided"), std::string::npos);
    codes(3, 12) = 0.9F;
    const EngineConeCertificate refuted = certified(map, field, withRays(0));
    EXPECT_FALSE(refuted.safe());
    EXPECT_EQ(refuted.texelsInCones, 1U);
    EXPECT_EQ(refuted.aimed, 1U);
    EXPECT_DOUBLE_EQ(refuted.first->ray.s0, 3.5);
    EXPECT_GT(refuted.worst, 0.01);
}

// Beside a spike of height 1 the surface rises by the square root of 2 per texel along the diagonal, more than towards
// any texel.
TEST(EngineCertificate, TheSlopeOfTheSurfaceItselfIsABound) {
    const HeightField field = spike(32, 24);
    EngineMap map = cones(field, conventions(16, ConeUnit::Ratio));
    for (int y = 11; y <= 13; ++y) {
        for (int x = 15; x <= 17; ++x) map.levels[0].channels[1](x, y) = nearestCode(1 / (1.2 * 32), 16);
    }
    const EngineConeCertificate found = certified(map, field, withRays(0));
    EXPECT_EQ(found.texelsInCones, 0U);
    EXPECT_EQ(found.bounds->open, 16U) << "the cells of those texels";
    EXPECT_NEAR(found.bounds->first->needed, std::sqrt(2), 1e-6);
    EXPECT_FALSE(found.proven());
}

// A spike of height 1 at the corner of a picture that repeats, and cones that are safe only farther than 1 / 0.3 texels
// from it: all nearer cells and texels are found, on every side of the spike and of the picture's edges. In texture
// coordinates the cones are ellipses, of which the proof takes the longer axis all around.
TEST(EngineCertificate, ConesAroundASpikeAreFoundOnAllSides) {
    constexpr int kWidth = 24, kHeight = 16;
    FloatImage image(kWidth, kHeight);
    image(0, 0) = 1;
    const HeightField field(share(std::move(image)), Surface::Bilinear, Address::Repeat, 0.5);
    ConeCoding round;
    round.unit = ConeUnit::Slope, round.length = ConeLength::Width, round.scale = kWidth;
    ConeCoding ellipse = round;
    ellipse.length = ConeLength::Uv;
    const FloatImage codes(kWidth, kHeight, 0.3F);
    std::uint64_t cells = 0, texels = 0, texelsInEllipse = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const int right = std::min(x, kWidth - x), down = std::min(y, kHeight - y);
            if (right + down > 0 && 0.3 * std::hypot(right, down) < 1) ++texels;
            if (right + down > 0 && 0.3 * std::hypot(right, 1.5 * down) < 1) ++texelsInEllipse;
            // Cell x lies between the texels x and x + 1; the spike's cells are the last and the first.
            const int gapX = std::max(0, std::min(x - 1, kWidth - 2 - x));
            const int gapY = std::max(0, std::min(y - 1, kHeight - 2 - y));
            if (0.3 * std::hypot(gapX, gapY) < 1) ++cells;
        }
    }
    Work work(1);
    EXPECT_EQ(checkEngineCones(field, codes, round, work).open, cells);
    EXPECT_EQ(checkEngineCones(field, codes, ellipse, work).open, cells);
    EXPECT_EQ(violationsOfTexels(field, codes, round, 100, work).texels, texels);
    EXPECT_EQ(violationsOfTexels(field, codes, ellipse, 100, work).texels, texelsInEllipse);
}

TEST(EngineCertificate, ConesWithoutWidthAreCounted) {
    const HeightField field = spike(300, 5);
    const EngineConeCertificate found = certified(cones(field, conventions(8, ConeUnit::Ratio)), field, withRays(10));
    EXPECT_GT(found.stalled, 0U) << "a ratio of 1/300 is less than a code";
    EXPECT_TRUE(found.proven());
    EXPECT_NE(engineCertificateText(found, withRays(10)).find("where rays stop"), std::string::npos);
}

TEST(EngineCertificate, LowMaximaAreFound) {
    const HeightField field(randomHeights(9, 6, 2));
    Work work(2);
    const auto levels = [&](EngineRounding rounding) {
        EngineConventions c = conventions(8, ConeUnit::Ratio, rounding);
        c.channels = parseEnginePack("R=height", "");
        const EngineMap map = buildEnginePyramid(PyramidKind::Max, field, c, work);
        std::vector<FloatImage> all;
        for (int l = 0; l < static_cast<int>(map.levels.size()); ++l) all.push_back(*map.heights(l));
        return all;
    };
    const LowMaxima safe = checkEngineMaxima(field.heights(), levels(EngineRounding::Outward), work);
    EXPECT_EQ(safe.values, 9U * 6 + 5 * 3 + 3 * 2 + 2 * 1 + 1);
    EXPECT_EQ(safe.low, 0U);
    const LowMaxima low = checkEngineMaxima(field.heights(), levels(EngineRounding::Nearest), work);
    EXPECT_GT(low.low, 0U);
    EXPECT_LT(low.stored, low.height);
    EXPECT_NE(engineMaximaText(low).find("NOT SAFE\n  first value: level 0, texel ("), std::string::npos);
}

TEST(EngineCertificate, DistancesAndCellConesAreProvenLikeStoredOnes) {
    const HeightField field(share(makeRelief("hills", 24, 24, 5)), Surface::Bilinear, Address::Repeat, 0.2);
    Work work(2);
    EngineConventions c = conventions(8, ConeUnit::SqrtRatio);
    c.channels = parseEnginePack("R=apex,G=cone", "");
    const EngineMap cells = cones(field, c);
    const auto map = cellConesOfEngine(cells, field, "x");
    ASSERT_TRUE(map);
    EXPECT_EQ(checkConeBounds(*map, field, work).broken, 0U);
    c.channels = parseEnginePack("R=distance", "");
    for (const DistanceKind kind : {DistanceKind::EuclideanConservative, DistanceKind::Refined}) {
        const EngineMap volume = buildEngineDistances(buildDistanceMap(kind, {}, field, work), field, c, work);
        const auto distances = distancesOfEngine(volume, field, "x");
        ASSERT_TRUE(distances);
        EXPECT_EQ(checkDistanceBounds(*distances, field, work).broken, 0U) << distanceKindName(kind);
        EngineMap wrong = volume;
        for (float& x : wrong.levels[0].channels[0].pixels()) {
            if (x > 0 && x < 0.5F) x = codeAbove(codeAbove(codeAbove(x, 8), 8), 8);
        }
        EXPECT_GT(checkDistanceBounds(*distancesOfEngine(wrong, field, "x"), field, work).broken, 0U);
    }
    EXPECT_FALSE(cellConesOfEngine(cones(field, conventions(8, ConeUnit::Ratio)), field, "x"));
}

TEST(EngineMarch, FetchesAreThoseOfTextures) {
    FloatImage codes(2, 2);
    codes(0, 0) = 0.25F, codes(1, 0) = 0.5F, codes(0, 1) = 0.75F, codes(1, 1) = 1;
    const HeightField repeat(constantHeights(2, 2, 0), Surface::Bilinear, Address::Repeat);
    const HeightField clamp(constantHeights(2, 2, 0), Surface::Bilinear, Address::Clamp);
    const auto at = [&](const HeightField& field, ConeFetch fetch, double s, double t) {
        return EngineMarch(field, codes, {}, false, fetch).codeAt(s, t);
    };
    EXPECT_DOUBLE_EQ(at(repeat, ConeFetch::Bilinear, 0.5, 0.5), 0.25);
    EXPECT_DOUBLE_EQ(at(repeat, ConeFetch::Bilinear, 1, 0.5), 0.375);
    EXPECT_DOUBLE_EQ(at(repeat, ConeFetch::Bilinear, 1, 1), 0.625);
    EXPECT_DOUBLE_EQ(at(repeat, ConeFetch::Bilinear, 0, 0.5), 0.375);
    EXPECT_DOUBLE_EQ(at(clamp, ConeFetch::Bilinear, 0, 0.5), 0.25);
    EXPECT_DOUBLE_EQ(at(repeat, ConeFetch::Nearest, 1.25, 3.9), 1.0);
    EXPECT_DOUBLE_EQ(at(clamp, ConeFetch::Nearest, -4, 9), 0.75);
}

}  // namespace
}  // namespace relief::test
