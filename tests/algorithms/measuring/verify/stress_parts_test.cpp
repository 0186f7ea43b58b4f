// relief stress beyond view rays: any-hit queries, frames, homographies and rows.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "algorithms/images/temporary_folder.h"
#include "measuring/verify/stress.h"
#include "measuring/verify/stress_cases.h"
#include "measuring/verify/stress_part_checks.h"
#include "relief/reliefs.h"
#include "rendering/pinhole.h"
#include "scenario/scenario.h"

namespace relief::test {
namespace {

class StressPartsTest : public ::testing::Test {
  protected:
    StressReport run(std::set<StressPart> parts, int threads = 2) {
        StressOptions options;
        options.seconds = 0;
        options.seed = 7;
        options.parts = std::move(parts);
        options.folder = folder_ / ".";
        Work work(threads);
        return stress(options, work);
    }

    // A frame over a relief with slopes and walls.
    static std::shared_ptr<const Frame> smallFrame() {
        FrameRequest request(HeightField(std::make_shared<FloatImage>(makeRelief("bricks", 32, 32, 1))));
        request.width = 24;
        request.height = 18;
        Work work(1);
        return FrameRenderer(std::make_shared<MapCache>()).render(request, work);
    }

    static std::string checkOf(const std::optional<StressFault>& fault) { return fault ? fault->check : ""; }

    relief::testing::TemporaryFolder folder_;
};

TEST_F(StressPartsTest, PartsAreReadByTheirNames) {
    for (int p = 0; p < kStressParts; ++p) {
        const auto part = static_cast<StressPart>(p);
        EXPECT_EQ(parseStressPart(stressPartName(part), "--parts"), part);
    }
    EXPECT_THROW(parseStressPart("none", "--parts"), InputError);
}

TEST_F(StressPartsTest, AnyHitQueriesAgreeWithTheExactHits) {
    const StressReport report = run({StressPart::AnyHit});
    EXPECT_EQ(report.violationCount, 0U) << stressText(report, 7);
    for (const MethodDescription& query : anyHitList()) {
        ASSERT_EQ(report.methods.count(query.name), 1U) << query.name;
        EXPECT_GT(report.methods.at(query.name).logs, 0U);
        EXPECT_LE(report.methods.at(query.name).worstBound, 1.0);
    }
    EXPECT_EQ(report.methods.size(), anyHitList().size()) << "no other part was run";
}

TEST_F(StressPartsTest, ExactAgreesWithRationalArithmetic) {
    StressOptions options;
    options.seed = 7;
    options.cases = 12;
    options.parts = {StressPart::AnyHit};
    options.oracle = true;
    Work work(2);
    const StressReport report = stress(options, work);
    EXPECT_EQ(report.violationCount, 0U) << stressText(report, 7);
    const StressPartCoverage& decided = report.parts.at("oracle");
    EXPECT_GT(decided.total(), 10 * decided.refused);
    for (const char* family : {"ordinary", "through-corners", "through-nodes", "along-borders"}) {
        EXPECT_EQ(decided.tried.count(family), 1U) << family;
    }
}

TEST_F(StressPartsTest, FramesAreFiniteAndTheSameHoweverTheyAreRendered) {
    const StressReport report = run({StressPart::Frames});
    EXPECT_EQ(report.violationCount, 0U) << stressText(report, 7);
    const StressPartCoverage& frames = report.parts.at("frames");
    for (const StressCameraFamily& camera : stressCameraFamilies()) {
        EXPECT_EQ(frames.tried.count(std::string(camera.name)), 1U) << camera.name;
    }
    EXPECT_EQ(frames.refused, frames.tried.at("on-target"));
    EXPECT_LT(frames.refused, frames.total() / 2);
    const StressPartCoverage& filters = report.parts.at("filters");
    for (const FilterDescription& filter : filterList()) {
        EXPECT_EQ(filters.tried.count(filter.name), 1U) << filter.name;
    }
    EXPECT_EQ(filters.tried.count("elliptical-visible:form=position-area"), 1U);
    EXPECT_NE(stressText(report, 7).find("frames (" + std::to_string(frames.total())), std::string::npos);
}

TEST_F(StressPartsTest, HomographiesAndRowsKeepToTheirBounds) {
    const StressReport report = run({StressPart::Homographies, StressPart::Rows});
    EXPECT_EQ(report.violationCount, 0U) << stressText(report, 7);
    const StressPartCoverage& homographies = report.parts.at("homographies");
    for (const StressCameraFamily& camera : stressCameraFamilies()) {
        EXPECT_EQ(homographies.tried.count(std::string(camera.name)), 1U) << camera.name;
    }
    const StressPartCoverage& rows = report.parts.at("rows");
    for (int v = 0; v < kRowVariants; ++v) {
        const std::string name(rowVariantName(static_cast<RowVariant>(v)));
        EXPECT_EQ(rows.tried.count(name), 1U) << name;
    }
    EXPECT_TRUE(report.methods.empty());
}

TEST_F(StressPartsTest, PartsDependOnTheSeedAlone) {
    const std::set<StressPart> parts{StressPart::AnyHit, StressPart::Homographies, StressPart::Rows};
    const StressReport one = run(parts, 1);
    const StressReport two = run(parts, 2);
    for (const auto& [name, part] : one.parts) {
        EXPECT_EQ(part.tried, two.parts.at(name).tried) << name;
        EXPECT_EQ(part.refused, two.parts.at(name).refused) << name;
    }
    for (const auto& [name, coverage] : one.methods) {
        EXPECT_EQ(coverage.rays, two.methods.at(name).rays) << name;
        EXPECT_EQ(coverage.worstBound, two.methods.at(name).worstBound) << name;
    }
}

TEST_F(StressPartsTest, OneCaseIsTheSameAlone) {
    StressOptions options;
    options.seconds = 0;
    options.parts = {StressPart::Homographies};
    options.only = 4;
    Work work(2);
    const StressReport report = stress(options, work);
    EXPECT_EQ(report.cases, 1U);
    EXPECT_EQ(report.sizes.size(), 1U);
}

TEST_F(StressPartsTest, AWrongVisibilityIsFound) {
    const HeightField field(std::make_shared<FloatImage>(FloatImage(16, 16, 0.5F)));
    MapCache maps;
    Work work(1);
    const auto query = makeAnyHit({"max-pyramid-any", {}}, field, maps, work);
    const ViewRay ray{8.3, 8.2, 3, 2};
    const Hit hit = Hit::at(ray, 0.5);
    CountedVisibility answer;
    answer.visibility = Visibility::Blocked;
    EXPECT_FALSE(anyHitFault(*query, ray, answer, hit));
    EXPECT_EQ(checkOf(anyHitFault(*query, ray, answer, Hit::none(Outcome::Miss))), "any-hit");
    answer.log.steps.resize(1);
    answer.log.steps[0].lambdaOut = 0.25;
    EXPECT_EQ(checkOf(anyHitFault(*query, ray, answer, hit)), "any-hit") << "blocked before the hit";
    answer.visibility = Visibility::Clear;
    EXPECT_EQ(checkOf(anyHitFault(*query, ray, answer, hit)), "any-hit") << "clear behind the hit";
    answer.visibility = Visibility::Limit;
    EXPECT_EQ(checkOf(anyHitFault(*query, ray, answer, hit)), "limit");
    answer.steps = std::numeric_limits<std::uint32_t>::max();
    EXPECT_EQ(checkOf(anyHitFault(*query, ray, answer, hit)), "steps");
}

TEST_F(StressPartsTest, AClearAnswerIsRefutedOnlyByASurePlaceOfTheSurface) {
    const auto check = [](Surface surface, Address address, const ViewRay& ray) {
        const HeightField field(std::make_shared<FloatImage>(FloatImage(16, 16, 0.5F)), surface, address);
        MapCache maps;
        Work work(1);
        CountedVisibility clear;
        clear.visibility = Visibility::Clear;
        return checkOf(
            anyHitFault(*makeAnyHit({"max-pyramid-any", {}}, field, maps, work), ray, clear, Hit::at(ray, 0.5)));
    };
    EXPECT_EQ(check(Surface::Columns, Address::Repeat, {8.3, 8.2, 3, 2}), "any-hit");
    EXPECT_EQ(check(Surface::Columns, Address::Repeat, {8.3, 8, 3, 0}), "") << "between two columns";
    EXPECT_EQ(check(Surface::Columns, Address::Repeat, {8, 8.2, 0, 2}), "") << "between two columns";
    EXPECT_EQ(check(Surface::Bilinear, Address::Border, {8.3, 8.2, 3, 2}), "any-hit");
    EXPECT_EQ(check(Surface::Bilinear, Address::Border, {8, 8.2, 16, 2}), "") << "no surface outside the picture";
}

TEST_F(StressPartsTest, AWrongPixelIsFound) {
    const auto frame = smallFrame();
    EXPECT_FALSE(finiteFault(*frame));
    EXPECT_FALSE(differenceFault(*frame, *smallFrame(), "no-skip", "again"));
    Frame wrong = *frame;
    auto light = std::make_shared<LightStage>(*frame->light);
    light->color(5, 4).y = std::nextafter(light->color(5, 4).y, 2.0F);
    wrong.light = light;
    const auto fault = differenceFault(*frame, wrong, "no-skip", "with --no-skip");
    ASSERT_EQ(checkOf(fault), "no-skip");
    EXPECT_EQ(fault->detail.substr(0, 10), "pixel 5,4:") << fault->detail;
    light = std::make_shared<LightStage>(*frame->light);
    light->color(5, 4).y = std::nanf("");
    wrong.light = light;
    EXPECT_EQ(checkOf(finiteFault(wrong)), "not-finite");
}

TEST_F(StressPartsTest, AHitFartherThanTheBoundIsFound) {
    const auto frame = smallFrame();
    EXPECT_FALSE(boundFault(*frame, *smallFrame(), 0));
    const auto& outcomes = frame->hits->hits.outcome;
    const auto pixel =
        static_cast<std::size_t>(std::find(outcomes.begin(), outcomes.end(), Outcome::Hit) - outcomes.begin());
    ASSERT_LT(pixel, outcomes.size());
    Frame spared = *frame;
    auto moved = std::make_shared<HitStage>(*frame->hits);
    moved->hits.s[pixel] += 0.3;
    spared.hits = moved;
    EXPECT_FALSE(boundFault(spared, *frame, 0.31));
    EXPECT_EQ(checkOf(boundFault(spared, *frame, 0.29)), "bounded");
}

TEST_F(StressPartsTest, AWrongMapIsFound) {
    const PinholeCamera camera = pinholeCamera(Camera{}, 800, 600);
    const Homography map = fromCameraAndPlane(camera, makeScene(SceneKind::Floor, 64, 64).front().plane);
    const auto terms = derivativeTerms<double>(map);
    EXPECT_FALSE(roundTripFault(map, map.inverse(), 400.5, 310.5));
    EXPECT_FALSE(derivativeFault(map, terms, 400.5, 310.5));
    Homography inverse = map.inverse();
    inverse.s1 *= 1 + 1e-9;
    EXPECT_EQ(checkOf(roundTripFault(map, inverse, 400.5, 310.5)), "round-trip");
    auto wrong = terms;
    wrong.c1 *= 1 + 1e-6;
    EXPECT_EQ(checkOf(derivativeFault(map, wrong, 400.5, 310.5)), "derivatives");
}

TEST_F(StressPartsTest, AWrongRowIsFound) {
    const PinholeCamera camera = pinholeCamera(Camera{}, 800, 600);
    const Homography map = fromCameraAndPlane(camera, makeScene(SceneKind::Floor, 64, 64).front().plane);
    StressRow<float> row = evaluatedRow<float>(map, 500.5, {0, 800}, {RowVariant::Streams}, false);
    ASSERT_GT(row.valid.size(), 100);
    EXPECT_FALSE(rowFault(row));
    const auto n = static_cast<std::size_t>(row.valid.begin) + 50;
    const float right = row.u[n];
    row.u[n] = std::numeric_limits<float>::infinity();
    EXPECT_EQ(checkOf(rowFault(row)), "not-finite");
    row.u[n] = 1e9F;
    EXPECT_EQ(checkOf(rowFault(row)), "row");
    row.options.variant = RowVariant::Affine;
    EXPECT_FALSE(rowFault(row)) << "approximations are only finite";
    row.u[n] = right;
    Homography behind = map;
    behind.q1 = -2000;
    row.map = &behind;
    EXPECT_EQ(checkOf(rowFault(row)), "horizon");
}

TEST_F(StressPartsTest, ARowsStatedBoundIsTight) {
    Homography map;
    map.sx = 1.25;
    map.qx = 1e-4;
    StressRow<float> row = evaluatedRow<float>(map, 0.5, {0, 1000}, {RowVariant::Direct}, true);
    EXPECT_FALSE(rowFault(row));
    row.u[700] += 0.01F;
    EXPECT_EQ(checkOf(rowFault(row)), "row");
}

TEST_F(StressPartsTest, RenderCommandsNameAllThatTheFrameDependsOn) {
    Scenario scenario;
    scenario.pictures.recipe = "bricks";
    scenario.filter = {"elliptical-visible", {{"form", "position"}}};
    scenario.shadows = true;
    scenario.skip = false;
    scenario.camera.kind = Camera::Kind::Free;
    const std::string line = renderCommand(scenario);
    EXPECT_EQ(line.substr(0, 14), "relief render ");
    for (const std::string part :
         {"--relief bricks:256x256:1", "--filter elliptical-visible:form=position", " --shadows", " --no-skip",
          "--eye 0,1,1", "--size 800x600", "--light azimuth=-50,elevation=40"}) {
        EXPECT_NE(line.find(part), std::string::npos) << part << ": " << line;
    }
}

}  // namespace
}  // namespace relief::test
