// Maps in the form that engines read: codings round outward, cones on the surface hold no surface, files keep numbers
// and conventions.
#include "relief/maps/engine_map.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"
#include "algorithms/relief/fields.h"
#include "relief/files.h"
#include "relief/maps/engine_builders.h"
#include "relief/maps/engine_json.h"
#include "relief/maps/robust_cones.h"
#include "relief/maps/surface_cones.h"

namespace relief::test {
namespace {

using testing::faultOf;
using testing::TemporaryFolder;

constexpr std::array kBits{8, 16, 32};
constexpr std::array kUnits{ConeUnit::Ratio, ConeUnit::SqrtRatio, ConeUnit::Slope};

std::vector<ConeCoding> codings() {
    std::vector<ConeCoding> all;
    for (const ConeUnit unit : kUnits) {
        for (const ConeLength length : {ConeLength::Uv, ConeLength::Width}) {
            all.push_back({unit, length, unit == ConeUnit::Slope ? 500.0 : 1.0});
            all.push_back({unit, length, unit == ConeUnit::Slope ? 321.7 : 0.37});
        }
    }
    return all;
}

std::string nameOf(const ConeCoding& coding, int bits) {
    return std::string(coneUnitName(coding.unit)) + " " + std::string(coneLengthName(coding.length)) + " scale " +
           numberText(coding.scale) + ", " + std::to_string(bits) + " bits";
}

// A slope, heights per texel, of any order of magnitude that occurs; on a map of 100 x 40 no steeper than 300 per unit
// of length.
double anySlope(Random& random) {
    return 3 * std::exp2(-12 * random.unit());
}

EngineConventions conventions(const std::string& pack, int bits, ConeUnit unit = ConeUnit::SqrtRatio) {
    EngineConventions c;
    c.channels = parseEnginePack(pack, "");
    c.bits = bits;
    c.cone.unit = unit;
    return c;
}

EngineMap cones(const HeightField& field, const EngineConventions& c, int levels = 1,
                ConeKind kind = ConeKind::Conservative) {
    Work work(2);
    return buildEngineCones(kind, {}, field, c, levels, work);
}

// The slope of a stored cone, heights per texel, as a shader computes it.
float slopeInFloat(const ConeCoding& coding, float stored, int width, int height) {
    const auto scale = static_cast<float>(coding.scale), texels = static_cast<float>(coding.texels(width, height));
    if (coding.unit == ConeUnit::Slope) return stored * scale / texels;
    const float share = coding.unit == ConeUnit::SqrtRatio ? stored * stored : stored;
    return 1 / (share * scale * texels);
}

TEST(EngineCodes, ConesAreNeverStoredWider) {
    for (const int bits : kBits) {
        for (const ConeCoding& coding : codings()) {
            Random random(7);
            int wider = 0;
            for (int n = 0; n < 2000; ++n) {
                const double slope = anySlope(random);
                const float outward = coding.encode(slope, 100, 40, bits, EngineRounding::Outward);
                ASSERT_GE(coding.slope(static_cast<double>(outward), 100, 40), slope) << nameOf(coding, bits);
                ASSERT_GE(static_cast<double>(slopeInFloat(coding, outward, 100, 40)), slope) << nameOf(coding, bits);
                // No wider code would do, but for the margin.
                const float next = coding.unit == ConeUnit::Slope ? codeBelow(outward, bits) : codeAbove(outward, bits);
                if (outward > 0 && outward < 1 && bits != 32) {
                    ASSERT_LT(coding.slope(static_cast<double>(next), 100, 40), slope * (1 + 3 * kEngineMargin));
                }
                const float nearest = coding.encode(slope, 100, 40, bits, EngineRounding::Nearest);
                if (coding.slope(static_cast<double>(nearest), 100, 40) < slope) ++wider;
            }
            EXPECT_GT(wider, 0) << "rounding to the nearest would be safe: " << nameOf(coding, bits);
        }
    }
}

TEST(EngineCodes, NumbersAreRoundedToEachSide) {
    Random random(3);
    for (const int bits : kBits) {
        for (int n = 0; n < 3000; ++n) {
            const double x = n == 0 ? 0 : n == 1 ? 1 : random.unit();
            const float low = lowerCode(x, bits), high = higherCode(x, bits), near = nearestCode(x, bits);
            ASSERT_LE(static_cast<double>(low), x);
            ASSERT_GE(static_cast<double>(high), x);
            ASSERT_TRUE(near == low || near == high);
            ASSERT_TRUE(low == high || codeAbove(low, bits) == high);
            ASSERT_EQ(nearestCode(static_cast<double>(near), bits), near) << "stored numbers are codes";
        }
    }
    EXPECT_EQ(lowerCode(-1, 8), 0.0F);
    EXPECT_EQ(higherCode(2, 16), 1.0F);
}

TEST(EngineCodes, PacksAreParsed) {
    const std::vector<EngineRole> channels = parseEnginePack("R=height,A=cone", "--pack");
    EXPECT_EQ(enginePackText(channels), "R=height,G=zero,B=zero,A=cone");
    EXPECT_TRUE(packs(channels, EngineRole::Cone));
    EXPECT_FALSE(packs(channels, EngineRole::Apex));
    for (const char* wrong : {"", "R", "X=cone", "R=cones", "R=cone,R=height", "R=cone,"}) {
        EXPECT_TRUE(faultOf([&] { parseEnginePack(wrong, "--pack"); }).starts_with("--pack")) << wrong;
    }
}

// Any point, the widest cone that can be fetched there, and any other point.
TEST(SurfaceCones, HoldNoPointOfTheSurface) {
    const std::vector<std::pair<int, int>> sizes{{12, 9}, {1, 6}, {5, 1}, {16, 16}};
    for (const auto& [width, height] : sizes) {
        for (const Address address : allAddresses()) {
            const HeightField field(randomHeights(width, height, 5), Surface::Bilinear, address, 0.2);
            Work work(2);
            const FloatImage slopes = surfaceCones(field, work);
            Random random(11);
            double tightest = 0;
            for (int n = 0; n < 40'000; ++n) {
                const double s = random.unit() * width, t = random.unit() * height;
                const double reach = n % 2 == 0 ? 2 : 2.0 * std::max(width, height);
                const double x = (random.unit() - 0.5) * reach, y = (random.unit() - 0.5) * reach;
                double least = 1e30;
                for (const double down : {std::floor(t - 0.5), std::floor(t - 0.5) + 1}) {
                    for (const double across : {std::floor(s - 0.5), std::floor(s - 0.5) + 1}) {
                        const int i = addressIndex(static_cast<std::int64_t>(across), width, address);
                        const int j = addressIndex(static_cast<std::int64_t>(down), height, address);
                        least = std::min(least, static_cast<double>(slopes(i, j)));
                    }
                }
                const double rise = field.at(s + x, t + y) - field.at(s, t);
                ASSERT_LE(rise, least * std::hypot(x, y) * (1 + 1e-6) + 1e-9) << describe(field);
                tightest = std::max(tightest, rise / (least * std::hypot(x, y)));
            }
            EXPECT_GT(tightest, width > 1 && height > 1 ? 0.5 : 0.3)
                << "cones are needlessly narrow: " << describe(field);
        }
    }
}

// In each of the eight directions, the nearest peak may stand in the neighbouring period.
TEST(SurfaceCones, HoldNoPeakBeyondTheSeam) {
    constexpr int kSide = 32, kNear = 2, kFar = kSide - 3;
    for (const auto& [x, y] : {std::pair{kNear, kNear}, {kFar, kNear}, {kNear, kFar}, {kFar, kFar}}) {
        FloatImage heights(kSide, kSide, 0.0F);
        heights(x, y) = 1;
        Work work(1);
        const FloatImage slopes = surfaceCones(HeightField(share(std::move(heights))), work);
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const double gap = std::hypot(std::remainder(i - x, kSide), std::remainder(j - y, kSide));
                EXPECT_GE(static_cast<double>(slopes(i, j)) * gap, gap > 0 ? 1.0 : 0.0) << i << ',' << j;
            }
        }
    }
}

// The steepest slope towards a texel from which the surface falls away within one of the quadrants behind it.
double slopeToFallingEdges(const HeightField& field, int x, int y, int radius) {
    double slope = 0;
    for (const int sx : {-1, 1}) {
        for (const int sy : {-1, 1}) {
            for (int m = 0; m <= radius; ++m) {
                for (int n = m == 0 ? 1 : 0; n <= radius; ++n) {
                    const int i = x + sx * m, j = y + sy * n;
                    const float here = field.texel(i, j), across = field.texel(i + sx, j),
                                down = field.texel(i, j + sy), far = field.texel(i + sx, j + sy);
                    if (!(here > across || here > down || across > far || down > far)) continue;
                    slope = std::max(slope, static_cast<double>(here - field.texel(x, y)) / std::hypot(m, n));
                }
            }
        }
    }
    return slope;
}

TEST(RobustCones, AreBoundedByFallingEdgesAround) {
    for (const Address address : allAddresses()) {
        for (const int radius : {3, 12}) {
            const HeightField field(randomHeights(12, 9, 8), Surface::Bilinear, address, 0.2);
            Work work(2);
            const FloatImage slopes = robustRelaxedCones(field, radius, work);
            for (int y = 0; y < field.height(); ++y) {
                for (int x = 0; x < field.width(); ++x) {
                    double steepest = 0;
                    for (int dy = -1; dy <= 1; ++dy) {
                        for (int dx = -1; dx <= 1; ++dx) {
                            const int i = addressIndex(x + dx, field.width(), address);
                            const int j = addressIndex(y + dy, field.height(), address);
                            steepest = std::max(steepest, slopeToFallingEdges(field, i, j, radius));
                        }
                    }
                    ASSERT_FLOAT_EQ(slopes(x, y), static_cast<float>(steepest))
                        << describe(field) << " " << x << " " << y;
                }
            }
        }
    }
    // On a slope that rises to the border the surface never falls: the cone has no side.
    FloatImage ramp(8, 1);
    for (int x = 0; x < 8; ++x) ramp(x, 0) = 0.1F * static_cast<float>(x);
    Work work(1);
    const HeightField field(share(std::move(ramp)), Surface::Bilinear, Address::Clamp);
    EXPECT_EQ(robustRelaxedCones(field, 8, work)(0, 0), 0.0F);
}

std::string jsonOf(const EngineConventions& c) {
    return engineJson({c, {"x"}, {{1, 1}}}).dump();
}

void expectSame(const EngineMap& read, const EngineMap& written, const std::string& what) {
    EXPECT_EQ(jsonOf(read.conventions), jsonOf(written.conventions)) << what;
    ASSERT_EQ(read.levels.size(), written.levels.size()) << what;
    for (std::size_t l = 0; l < read.levels.size(); ++l) {
        ASSERT_EQ(read.levels[l].channels.size(), written.levels[l].channels.size());
        for (std::size_t c = 0; c < read.levels[l].channels.size(); ++c) {
            EXPECT_EQ(read.levels[l].channels[c], written.levels[l].channels[c]) << what << ", channel " << c;
        }
    }
}

EngineMap readBack(const std::string& path) {
    Work work(1);
    const auto stated = readEngineConventions(path);
    EXPECT_TRUE(stated) << path;
    return readEngineMap(path, stated.value_or(EngineConventions()), work);
}

struct FileCase {
    std::string ending;
    int bits;
};
const std::vector<FileCase>& fileCases() {
    static const std::vector<FileCase> all{{"png", 8}, {"png", 16}, {"exr", 32}, {"tif", 8}, {"tif", 16}, {"tif", 32}};
    return all;
}

// The picture alone suffices, too: it holds the conventions.
TEST(EngineFiles, KeepNumbersAndConventions) {
    const HeightField field(randomHeights(9, 6, 2), Surface::Bilinear, Address::Clamp, 0.25);
    for (const FileCase& one : fileCases()) {
        for (const char* pack : {"R=cone", "R=height,G=cone", "B=cone,A=depth", "R=height,G=cone,B=normal-x,A=normal-y",
                                 "R=normal-x,G=normal-y,B=normal-z,A=cone"}) {
            const TemporaryFolder folder;
            const std::string path = folder / ("map." + one.ending);
            const EngineMap map = cones(field, conventions(pack, one.bits));
            writeEngineMap(path, map);
            EXPECT_TRUE(isEngineMap(path));
            expectSame(readBack(path), map, path + " " + pack);
            std::filesystem::remove(engineSidecar(path));
            EXPECT_TRUE(isEngineMap(path));
            expectSame(readBack(path), map, path + " alone " + pack);
        }
    }
}

TEST(EngineFiles, AReliefWithoutDepthIsReadBack) {
    const TemporaryFolder folder;
    const EngineMap map =
        cones({randomHeights(9, 6, 2), Surface::Bilinear, Address::Clamp, 0}, conventions("R=height,G=cone", 16));
    writeEngineMap(folder / "map.png", map);
    expectSame(readBack(folder / "map.png"), map, "depth 0");
}

TEST(EngineFiles, OtherKindsAreKept) {
    const HeightField field(randomHeights(16, 8, 4), Surface::Bilinear, Address::Repeat, 0.5);
    Work work(2);
    for (const FileCase& one : fileCases()) {
        const TemporaryFolder folder;
        const std::string path = folder / ("map." + one.ending);
        std::vector<EngineMap> maps{
            buildEnginePyramid(PyramidKind::Max, field, conventions("R=height", one.bits), work),
            buildEngineNormals(field, conventions("R=normal-x,G=normal-y,B=normal-z", one.bits), 2, work),
            cones(field, conventions("R=apex,G=cone", one.bits)),
            cones(field, conventions("R=height,G=cone", one.bits), 3)};
        maps[0].conventions.kind = "max-pyramid";
        for (const DistanceKind kind : {DistanceKind::Euclidean, DistanceKind::Refined}) {
            DistanceParameters parameters;
            parameters.layers = 5;
            maps.push_back(buildEngineDistances(buildDistanceMap(kind, parameters, field, work), field,
                                                conventions("R=distance", one.bits), work));
            maps.back().conventions.kind = distanceKindName(kind);
        }
        for (const EngineMap& map : maps) {
            writeEngineMap(path, map);
            expectSame(readBack(path), map, path + " " + map.conventions.kind);
        }
    }
}

TEST(EngineFiles, WhatIsNoMapIsRefused) {
    const TemporaryFolder folder;
    const std::string path = folder / "map.png";
    const HeightField field(randomHeights(4, 4, 1));
    writeEngineMap(path, cones(field, conventions("R=height,G=cone", 8)));
    Work work(1);
    const auto stated = *readEngineConventions(path);
    EngineConventions other = stated;
    other.channels = parseEnginePack("A=cone", "");
    EXPECT_NE(faultOf([&] { readEngineMap(path, other, work); }).find("no channel A"), std::string::npos);
    std::string text = readTextFile(engineSidecar(path));
    text.replace(text.find("sqrt-ratio"), 10, "cube-ratio");
    writeTextFile(engineSidecar(path), text);
    EXPECT_NE(faultOf([&] { readEngineConventions(path); }).find("cube-ratio"), std::string::npos);
    writeTextFile(engineSidecar(path), "{}");
    EXPECT_FALSE(faultOf([&] { readEngineConventions(path); }).empty());
    // Numbers that no volume has, before anything is allocated by them.
    DistanceParameters parameters;
    parameters.layers = 5;
    EngineMap volume = buildEngineDistances(buildDistanceMap(DistanceKind::Euclidean, parameters, field, work), field,
                                            conventions("R=distance", 8), work);
    volume.conventions.kind = "euclidean";
    writeEngineMap(path, volume);
    EXPECT_TRUE(readEngineConventions(path));
    text = readTextFile(engineSidecar(path));
    text.replace(text.find("\"layers\": 5"), 11, "\"layers\": 2000000000");
    writeTextFile(engineSidecar(path), text);
    EXPECT_NE(faultOf([&] { readEngineConventions(path); }).find("damaged: distance"), std::string::npos);
    writeHeight(folder / "plain.png", field.heights());
    EXPECT_FALSE(isEngineMap(folder / "plain.png"));
}

// Level k has the maxima of 2 x 2 heights, and cones that are safe for that surface.
TEST(EngineMips, LevelsAreMaximaWithConesOfTheirOwn) {
    const HeightField field(randomHeights(16, 8, 9));
    EXPECT_EQ(mostMipLevels(16, 8), 5);
    EXPECT_EQ(mostMipLevels(12, 8), 3);
    EXPECT_EQ(mostMipLevels(7, 8), 1);
    const EngineMap map = cones(field, conventions("R=height,G=cone", 8), 5);
    ASSERT_EQ(map.levels.size(), 5U);
    for (int l = 1; l < 5; ++l) {
        const FloatImage below = *map.heights(l - 1), level = *map.heights(l);
        EXPECT_EQ(level.width(), std::max(1, 16 >> l));
        for (int y = 0; y < below.height(); ++y) {
            for (int x = 0; x < below.width(); ++x) EXPECT_GE(level(x / 2, y / 2), below(x, y));
        }
        const HeightField own(share(level));
        const EngineMap direct = cones(own, conventions("R=height,G=cone", 8));
        EXPECT_EQ(*map.channel(EngineRole::Cone, l), *direct.channel(EngineRole::Cone));
    }
}

TEST(EngineMaps, MaximaAndDistancesStayBounds) {
    const HeightField field(randomHeights(10, 7, 6), Surface::Bilinear, Address::Repeat, 0.3);
    Work work(2);
    for (const int bits : kBits) {
        for (const char* pack : {"R=height", "R=depth"}) {
            const EngineMap map = buildEnginePyramid(PyramidKind::Max, field, conventions(pack, bits), work);
            const Pyramid exact(PyramidKind::Max, field.sharedHeights(), work);
            for (int l = 0; l < exact.levels(); ++l) {
                const FloatImage stored = *map.heights(l);
                for (std::size_t i = 0; i < stored.size(); ++i) {
                    // A depth's float cannot always be turned back into the very height.
                    ASSERT_GE(stored.pixels()[i], exact.level(l).pixels()[i] - (bits == 32 ? 1e-7F : 0.0F)) << pack;
                }
            }
        }
        const DistanceMap distances = buildDistanceMap(DistanceKind::EuclideanConservative, {}, field, work);
        const EngineMap map = buildEngineDistances(distances, field, conventions("R=distance", bits), work);
        const auto read = distancesOfEngine(map, field, "x");
        ASSERT_TRUE(read);
        int free = 0;
        for (int k = 0; k < distances.values.layers(); ++k) {
            for (int y = 0; y < distances.ny(); ++y) {
                for (int x = 0; x < distances.nx(); ++x) {
                    const float exact = distances.values(x, y, k);
                    if (exact > 0) ++free;
                    ASSERT_LE(read->values(x, y, k), std::max(exact, 0.0F));
                }
            }
        }
        EXPECT_GT(free, 0);
    }
}

}  // namespace
}  // namespace relief::test
