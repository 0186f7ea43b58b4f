// Quantities of lessons: each is measured, means what commands say, and is described in FORMATS.md.
#include "measuring/lesson/quantities.h"

#include <gtest/gtest.h>

#include "../../../memory_use.h"
#include "measuring/lesson/lesson_check.h"
#include "relief/files.h"

namespace relief::test {
namespace {

class Quantities : public testing::Test {
  protected:
    Quantities() {
        scenario_.pictures.recipe = "bricks";
        scenario_.pictures.recipeWidth = scenario_.pictures.recipeHeight = 32;
        scenario_.method = {"layers", {{"layers", "8"}}};
        scenario_.width = 64;
        scenario_.height = 48;
        scenario_.pixel = PixelChoice{32, 30};
    }
    ExpressionValue measured(const std::string& expression) {
        return Expression(expression).value(lessonSource(lesson_, scenario_, scenes_, work_));
    }
    double number(const std::string& expression) { return std::get<double>(measured(expression)); }

    Lesson lesson_;
    Scenario scenario_;
    SceneCache scenes_;
    Work work_;
};

TEST_F(Quantities, AreAllMeasuredAndDescribed) {
    const std::string formats = readTextFile(RELIEF_SOURCE "/algorithms/scenario/FORMATS.md");
    scenario_.filter.name = "elliptical-visible";
    scenario_.method = {"distance-conservative", {}};
    const std::map<std::string, std::string> arguments{{"scene", "'elevation'"},
                                                       {"option", "'resolution'"},
                                                       {"heights.at", "1, 2"},
                                                       {"pyramid.max", "1, 2, 3"},
                                                       {"pyramid.mean", "1, 2, 3"},
                                                       {"pyramid.min", "1, 2, 3"},
                                                       {"point.euclidean", "4, 5, 0.99"},
                                                       {"point.refined", "4, 5, 0.99"},
                                                       {"point.blocked", "4, 5, 0.99"},
                                                       {"trace.count", "'advance'"},
                                                       {"frame.error.at", "32, 30"},
                                                       {"frame.steps.at", "32, 30"},
                                                       {"counter", "'rays'"},
                                                       {"skipped", "'sky'"},
                                                       {"skipped.count", "'sky'"},
                                                       {"children.share", "2"},
                                                       {"map.overshoots", "200"},
                                                       {"map.worst", "200"},
                                                       {"map.values", "200"},
                                                       {"map.broken", "200"},
                                                       {"map.proven", "200"},
                                                       {"map.safe", "200"},
                                                       {"rows.mul", "'direct'"},
                                                       {"rows.add", "'direct'"},
                                                       {"rows.div", "'direct'"},
                                                       {"rows.error", "'direct', 256, 25, 'float'"},
                                                       {"picture.rmse", "2"},
                                                       {"picture.psnr", "2"},
                                                       {"picture.flip", "2, 'gaussian'"}};
    // The first option of the method, whatever it is.
    const std::string option = choiceOptions(scenario_.method).front().description.name;
    for (const Quantity& quantity : quantityList()) {
        std::string name(quantity.name);
        EXPECT_NE(formats.find("`" + (name.ends_with('.') ? name + "A" : name)), std::string::npos)
            << name << " is not in FORMATS.md";
        if (name.ends_with('.')) name += "q";
        const auto given = arguments.find(name);
        std::string text = name;
        if (name == "option") {
            text += "('" + option + "')";
        } else if (given != arguments.end()) {
            text += "(" + given->second + ")";
        }
        EXPECT_NO_THROW(measured(text)) << text;
    }
}

TEST_F(Quantities, MeanWhatTheySay) {
    EXPECT_EQ(number("option('layers')"), 8);
    EXPECT_EQ(number("trace.count('start') + trace.count('search') + trace.count('refine')"), number("trace.steps"));
    EXPECT_EQ(number("trace.count('hit')"), 1);
    EXPECT_EQ(number("exact.height + exact.lambda"), 1);
    EXPECT_EQ(number("frame.hits + frame.misses + frame.limits"), number("frame.rays"));
    EXPECT_GE(number("frame.error.max"), number("frame.error.p95"));
    EXPECT_GT(number("frame.error.mean"), 0);
    EXPECT_EQ(number("frame.rays"), number("counter('rays')"));
    EXPECT_EQ(number("pyramid.max(5, 0, 0)"), number("heights.max"));
    EXPECT_EQ(number("heights.levels"), 6);
    EXPECT_EQ(number("pyramid.mean(0, 3, 4)"), number("heights.at(3, 4)"));
    EXPECT_NEAR(number("pixel.q * pixel.u"), number("pixel.A * 32.5 + pixel.B * 30.5 + pixel.C"), 1e-9);
    EXPECT_EQ(number("rows.div('direct')"), 2);
    EXPECT_GT(number("rows.error('incremental:anchor=0', 4096, 25, 'float')"),
              number("rows.error('direct', 4096, 25, 'float')"));
    scenario_.method = {"max-pyramid", {}};
    EXPECT_EQ(number("frame.error.max + frame.wrong + frame.past + trace.error"), 0);
    EXPECT_EQ(std::get<std::string>(measured("trace.departure")), "none");
    EXPECT_NEAR(number("children.share(1) + children.share(2) + children.share(3)"), 1, 1e-12);
    const std::string checksum = std::get<std::string>(measured("picture.checksum"));
    scenario_.skip = false;
    EXPECT_EQ(std::get<std::string>(measured("picture.checksum")), checksum) << "skipping changes no bit";
    scenario_.light.azimuth += 10;
    EXPECT_NE(std::get<std::string>(measured("picture.checksum")), checksum);
    scenario_.filter.name = kSupersample;
    scenario_.filter.samples = 2;
    EXPECT_EQ(number("picture.rmse(2)"), 0) << "the truth itself";
}

// Of a picture of few pixels every ray counts.
TEST_F(Quantities, ChildrenAreThoseOfAllRays) {
    scenario_.method = {"max-pyramid", {}};
    MeasuredScene& scene = scenes_.scene(scenario_);
    const RayStage& rays = *scene.frame(work_).rays;
    StepLog log;
    HitBlock hits;
    ChildrenByLevel levels;
    RayBlock covered;
    for (std::size_t n = 0; n < rays.polygon.size(); ++n) {
        if (rays.polygon[n] != kNoPolygon) covered.push(rays.rays[n]);
    }
    scene.tracer(work_).trace(covered, hits, log, work_);
    for (std::size_t ray = 0; ray < log.rays(); ++ray) {
        addChildren(log.steps, log.begin[ray], log.begin[ray + 1], levels);
    }
    EXPECT_EQ(scene.children(work_).finished, sumOf(levels).finished);
    EXPECT_EQ(scene.children(work_).ended, sumOf(levels).ended);
    EXPECT_GT(scene.children(work_).descents(), 100);
}

TEST_F(Quantities, KeepOnlyAFewLargePictures) {
    scenario_.width = scenario_.height = 1200;
    double first = 0;
    for (int scene = 0; scene < 6; ++scene) {
        scenario_.method.options["layers"] = std::to_string(scene + 1);
        const double before = usedMegabytes();
        number("frame.steps.at(600, 600)");
        if (scene == 0) first = usedMegabytes() - before;
    }
    const double all = usedMegabytes();
    scenes_ = {};
    EXPECT_GT(first, 50);
    EXPECT_LT(all - usedMegabytes(), 3.5 * first) << "at most three, and maps";
}

TEST_F(Quantities, RefuseWhatTheyCannotMeasure) {
    for (const char* const text : {"frame.eror.mean",
                                   "frame.error",
                                   "pixel.Z",
                                   "option('layer')",
                                   "scene('elevaton')",
                                   "scene()",
                                   "scene(1)",
                                   "frame.rays(1)",
                                   "heights.at(32, 0)",
                                   "heights.at(1.5, 0)",
                                   "heights.at(1)",
                                   "pyramid.max(9, 0, 0)",
                                   "counter('ray')",
                                   "trace.count('jump')",
                                   "step.level(99)",
                                   "children.share(4)",
                                   "rows.mul('directly')",
                                   "rows.mul('direct', 0)",
                                   "picture.rmse(1)",
                                   "picture.rmse(2, 'round')",
                                   "frame.rays@nowhere",
                                   "map.safe(0)"}) {
        EXPECT_THROW(measured(text), InputError) << text;
    }
    scenario_.pixel.reset();
    EXPECT_THROW(measured("trace.steps"), InputError);
    EXPECT_NO_THROW(measured("frame.rays"));
}

}  // namespace
}  // namespace relief::test
