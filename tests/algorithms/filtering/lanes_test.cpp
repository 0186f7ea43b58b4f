// elliptical_lanes.h against its reference, and independence of instruction set and neighbours.
#include "filtering/elliptical_lanes.h"

#include <gtest/gtest.h>

#include "algorithms/every_target.h"
#include "filter_cases.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 20;

// Errors: 8e-6 of 16-bit levels, 3e-6 of the exponential, 2e-5 of the weights of ellipses with ratio 16 computed in
// float.
constexpr double kLaneTolerance = 1e-4;
// Share of pixels in which a texel on the rim, or the choice between two levels, may be rounded to the other side. Such
// pixels may differ by the weight of a texel at the rim.
constexpr double kRimShare = 5e-4;

struct LaneCase {
    int width, height;
    Address address;
};
const std::vector<LaneCase> kCases{{64, 32, Address::Repeat},  {37, 53, Address::Repeat}, {256, 16, Address::Repeat},
                                   {64, 64, Address::Clamp},   {37, 53, Address::Clamp},  {32, 128, Address::Border},
                                   {5, 1024, Address::Repeat}, {2, 2, Address::Repeat},   {1, 1, Address::Clamp}};

const std::vector<OptionValues> kSettings{{},
                                          {{"weights", "uniform"}},
                                          {{"weights", "texel-distance"}},
                                          {{"anisotropy", "64"}, {"floor", "3"}},
                                          {{"sigma", "0.3"}, {"radius", "3"}, {"texel-size", "off"}}};

// Footprints from a hundredth of a texel to the size at the horizon, at far positions, on seams and on rims; some not
// finite.
FilterBlock block(Random& random, const LaneCase& picture, std::size_t count) {
    FilterBlock block;
    for (std::size_t i = 0; i < count; ++i) {
        FilterQuery query;
        query.jacobian = randomJacobian(random, i % 7 == 0 ? 3000 : 20);
        query.place = {random.between(-2, 3) * picture.width, random.between(-2, 3) * picture.height};
        if (i % 11 == 0) query.place = {random.below(3) * picture.width * 0.5, random.below(3) * picture.height};
        if (i % 13 == 0) query.place *= 1e5;
        if (i % 17 == 0) query.jacobian = {4, 0, 0, 4};
        if (i % 19 == 0) query.jacobian.ux = i % 2 == 0 ? 1e30 : std::nan("");
        if (i % 23 == 0) query.place.x = 1e300;
        block.push(query);
    }
    return block;
}

std::vector<Color> colorsOf(const TextureFilter& filter, const FilterBlock& block, FootprintCounts& counts) {
    Work work(1);
    std::vector<Color> colors(block.size());
    filter.colors(block, colors, counts, work);
    return colors;
}

TEST(EllipticalLanes, NearTheReference) {
    Random random(kSeed);
    for (const OptionValues& options : kSettings) {
        std::size_t apart = 0, pixels = 0;
        double worst = 0;
        for (const LaneCase& c : kCases) {
            const Picture picture = randomPicture(c.width, c.height, kSeed);
            const HeightField field = fieldFor(*picture, c.address);
            OptionValues scalar = options;
            scalar["implementation"] = "scalar";
            MadeFilter lanes({"elliptical", options}, picture, field);
            MadeFilter reference({"elliptical", scalar}, picture, field);
            const FilterBlock queries = block(random, c, 2011);
            FootprintCounts read, readByReference;
            const auto got = colorsOf(*lanes.filter, queries, read);
            const auto expected = colorsOf(*reference.filter, queries, readByReference);
            EXPECT_NEAR(static_cast<double>(read.footprints), static_cast<double>(readByReference.footprints), 2);
            EXPECT_EQ(read.bilinear, readByReference.bilinear);
            for (std::size_t i = 0; i < queries.size(); ++i) {
                double difference = 0;
                for (int k = 0; k < 3; ++k) {
                    ASSERT_TRUE(std::isfinite(got[i][k])) << i;
                    difference = std::max(difference, std::abs(double{got[i][k]} - double{expected[i][k]}));
                }
                apart += difference > kLaneTolerance ? 1 : 0;
                worst = std::max(worst, difference);
                ++pixels;
            }
        }
        EXPECT_LE(static_cast<double>(apart), kRimShare * static_cast<double>(pixels))
            << (options.empty() ? "" : options.begin()->first) << " worst " << worst;
    }
}

// A picture of 18 levels, and a footprint on the last but one, which has two texels.
TEST(EllipticalLanes, NearTheReferenceOnCoarseLevelsOfAWidePicture) {
    const Picture picture = randomPicture(1 << 17, 1, kSeed);
    const HeightField field = fieldFor(*picture, Address::Repeat);
    MadeFilter lanes({"elliptical", {{"floor", "0.5"}, {"radius", "0.5"}}}, picture, field);
    MadeFilter reference({"elliptical", {{"floor", "0.5"}, {"radius", "0.5"}, {"implementation", "scalar"}}}, picture,
                         field);
    FilterBlock queries;
    queries.push({{40'000, 0.25}, {33'000, 0, 0, 33'000}, {40'000, 0.25, 0, 0}, 0});
    FootprintCounts read, readByReference;
    const auto got = colorsOf(*lanes.filter, queries, read);
    const auto expected = colorsOf(*reference.filter, queries, readByReference);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(got[0][k], expected[0][k], kLaneTolerance);
    EXPECT_EQ(read.texels, readByReference.texels);
}

TEST(EllipticalLanes, BitsDependOnNeitherInstructionSetNorNeighbours) {
    Random random(kSeed + 1);
    ASSERT_FALSE(laneTargets().empty());
    for (const OptionValues& options : kSettings) {
        for (const LaneCase& c : kCases) {
            const Picture picture = randomPicture(c.width, c.height, kSeed + 2);
            const HeightField field = fieldFor(*picture, c.address);
            MadeFilter made({"elliptical", options}, picture, field);
            const FilterBlock queries = block(random, c, 211);
            FootprintCounts counts;
            const auto expected = colorsOf(*made.filter, queries, counts);
            for (const std::int64_t target : laneTargets()) {
                const ForcedTarget forced(target);
                FootprintCounts again;
                EXPECT_EQ(colorsOf(*made.filter, queries, again), expected) << laneTargetName(target);
                EXPECT_EQ(again.texels, counts.texels) << laneTargetName(target);
                for (std::size_t i = 0; i < queries.size(); ++i) {
                    // Alone, and among others.
                    ASSERT_EQ(made.at(queries[i]), expected[i]) << laneTargetName(target) << ' ' << i;
                }
                FilterBlock turned;
                for (std::size_t i = queries.size(); i-- > 3;) turned.push(queries[i]);
                const auto other = colorsOf(*made.filter, turned, again);
                for (std::size_t i = 0; i < turned.size(); ++i) {
                    ASSERT_EQ(other[i], expected[queries.size() - 1 - i]) << laneTargetName(target) << ' ' << i;
                }
            }
        }
    }
}

TEST(EllipticalLanes, TheLogIsWhatWasSummed) {
    Random random(kSeed + 3);
    const LaneCase c{64, 32, Address::Repeat};
    const Picture picture = randomPicture(c.width, c.height, kSeed + 4);
    Work work(1);
    const ColorLevels levels(picture, work);
    MadeFilter made({"elliptical", {}}, picture, fieldFor(*picture, c.address));
    const FilterBlock queries = block(random, c, 211);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        FootprintLog log;
        made.counts = {};
        const Color color = made.at(queries[i], &log);
        ASSERT_EQ(color, made.at(queries[i])) << i;
        ASSERT_EQ(log.color, color) << i;
        if (log.texels.empty()) continue;
        ASSERT_EQ(made.counts.texels, 2 * static_cast<std::int64_t>(log.texels.size())) << i;
        glm::dvec3 sum(0), total(0);
        for (const FootprintTexel& texel : log.texels) {
            const ColorImage& level = levels.level(texel.level);
            sum += glm::dvec3(texel.weight) * glm::dvec3(level(texel.i, texel.j));
            total += glm::dvec3(texel.weight);
            EXPECT_EQ(texel.i, addressIndex(static_cast<std::int64_t>(std::floor(texel.u)), level.width(), c.address));
            EXPECT_EQ(texel.j, addressIndex(static_cast<std::int64_t>(std::floor(texel.v)), level.height(), c.address));
        }
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum[k] / total[k], color[k], kLaneTolerance) << i;
    }
}

// 16 bits cannot represent these values: the reference is used.
TEST(EllipticalLanes, BrighterThanWhite) {
    Random random(kSeed + 5);
    const auto picture = std::make_shared<ColorImage>(*randomPicture(32, 32, kSeed));
    (*picture)(3, 4).g = 7;
    const LaneCase c{32, 32, Address::Repeat};
    const HeightField field = fieldFor(*picture, c.address);
    MadeFilter made({"elliptical", {}}, picture, field);
    MadeFilter reference({"elliptical", {{"implementation", "scalar"}}}, picture, field);
    const FilterBlock queries = block(random, c, 50);
    FootprintCounts counts;
    EXPECT_EQ(colorsOf(*made.filter, queries, counts), colorsOf(*reference.filter, queries, counts));
}

}  // namespace
}  // namespace relief::test
