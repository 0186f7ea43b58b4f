// Steps of external tracers: what is written reads back the same, and errors name the line.
#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "scenario/ray_files.h"
#include "scenario/step_columns.h"

namespace relief::test {
namespace {

const std::string kHeader = std::string(kStepsHeader) + "\n";
// The columns that earlier versions wrote, and other programs may write.
const std::string kFewColumns = std::string(kStepColumns) + "\n";

std::string refusal(const std::string& text, std::size_t rays = 2) {
    try {
        parseSteps(text, "s.csv", rays);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(StepFiles, EveryMethodsLogReadsBackTheSame) {
    constexpr std::uint64_t kSeed = 77;
    Work work(1);
    MapCache cache;
    for (const Address address : allAddresses()) {
        const HeightField field(randomHeights(20, 13, kSeed), Surface::Bilinear, address, 0.3);
        RayBlock rays;
        Random random(kSeed);
        for (int n = 0; n < 20; ++n) {
            rays.push({random.unit() * 60 - 20, random.unit() * 40 - 13, random.unit() * 90 - 45, random.unit() * 9});
        }
        for (const MethodChoice& method : allChoices()) {
            if (!supports(method, Surface::Bilinear, address)) continue;
            if (method.options.contains("base")) continue;  // its texels are not those of the picture
            HitBlock hits;
            StepLog log;
            makeTracer(method, field, cache, work)->trace(rays, hits, log, work);
            for (const Step& step : log.steps) {
                // A value that a map gives for one point takes the ray to the end of the step's interval.
                if (!step.trustsMap() || !step.atPoint()) continue;
                EXPECT_EQ(step.lambdaOut, step.lambdaAfter) << method.name;
            }
            std::string lines = kHeader;
            std::string objects = "[";
            bool empty = true;
            for (std::size_t r = 0; r < rays.size(); ++r) {
                appendStepLines(lines, log, r, r);
                appendStepObjects(objects, log, r, r, empty);
            }
            const StepLog read = parseSteps(lines, "s.csv", rays.size());
            const StepLog readObjects = parseSteps(objects + "\n]\n", "s.json", rays.size());
            ASSERT_EQ(read.begin, log.begin) << method.name;
            ASSERT_EQ(readObjects.begin, log.begin) << method.name;
            EXPECT_EQ(read.steps, readObjects.steps) << method.name;
            for (std::size_t r = 0; r < rays.size(); ++r) {
                const std::span<const Step> ofRay = stepsOf(read, r);
                std::vector<Step> steps(ofRay.begin(), ofRay.end());
                placeSteps(steps, rays[r], field, "s.csv", r);
                const Hit answer = answerOf(steps, rays[r]);
                EXPECT_EQ(answer.outcome, hits.outcome[r]) << method.name;
                if (answer.outcome == Outcome::Hit) {
                    EXPECT_EQ(answer.lambda, hits.lambda[r]) << method.name;
                }
                std::string again;
                StepLog one;
                one.steps = steps;
                one.begin.push_back(steps.size());
                appendStepLines(again, one, 0, r);
                std::string before;
                appendStepLines(before, log, r, r);
                ASSERT_EQ(again, before) << method.name;
            }
        }
    }
}

TEST(StepFiles, PeriodsAreFoundAgain) {
    // Low ground: the ray crosses several periods of the texture before it hits.
    const HeightField field(constantHeights(16, 16, 0.1F), Surface::Bilinear, Address::Repeat, 0.3);
    Work work(1);
    MapCache cache;
    for (const char* method : {"max-pyramid", "exact", "layers", "cone-dummer"}) {
        RayBlock rays;
        rays.push({-40.25, 7.5, 55, -38});
        HitBlock hits;
        StepLog log;
        makeTracer({method, {}}, field, cache, work)->trace(rays, hits, log, work);
        std::vector<Step> steps = log.steps;
        int moved = 0;
        for (Step& step : steps) {
            moved += step.periodX != 0 || step.periodY != 0 ? 1 : 0;
            step.periodX = step.periodY = 99;
        }
        EXPECT_GT(moved, 0) << "the ray stays in one period: nothing is tested";
        placeSteps(steps, rays[0], field, "s.csv", 0);
        // The coarsest texel is the whole picture; only the tracer knows which period it belongs to.
        for (std::size_t n = 0; n < steps.size(); ++n) {
            if (steps[n].level < 3) {
                EXPECT_EQ(steps[n], log.steps[n]) << method << " " << n;
            }
        }
    }
}

// For a size of 5 texels the coarsest texel, 8 wide, ends with the picture: a ray just behind the seam is in the next
// period.
TEST(StepFiles, ATexelLargerThanThePictureEndsWithIt) {
    const HeightField field(constantHeights(5, 5, 0.1F), Surface::Columns, Address::Repeat, 0.3);
    const std::string stays[] = {"0,0.02,1,0.98", "0.4,0.42,0.6,0.58", "0.8,0.82,0.2,0.18"};
    for (int period = 0; period < 3; ++period) {
        const std::string line = "0,1,search,3,0,0,0," + stays[period] + ",0.5,skip,0.9\n";
        std::vector<Step> steps = parseSteps(kFewColumns + line, "s.csv", 1).steps;
        placeSteps(steps, {0.25, 0.25, 12.5, 0.5}, field, "s.csv", 0);
        EXPECT_EQ(steps[0].periodX, period);
        EXPECT_EQ(steps[0].periodY, 0);
    }
}

TEST(StepFiles, ATexelsPlaceOfTheRayNeedsBothCoordinates) {
    const std::string known = "0,1,search,0,1,2,0,0.1,0.2,0.9,0.8,0.5,test,0.2,texel,";
    const auto placeOf = [&](const std::string& coordinates) {
        const StepLog log = parseSteps(kHeader + known + coordinates + ",,,,,\n", "s.csv", 1);
        return std::get<subject::Texel>(log.steps.at(0).subject).ray;
    };
    const std::optional<subject::LevelPoint> both = placeOf("1.5,2.25");
    ASSERT_TRUE(both);
    EXPECT_EQ(both->x, 1.5);
    EXPECT_EQ(both->y, 2.25);
    for (const char* coordinates : {",", "1.5,", ",2.25"}) EXPECT_FALSE(placeOf(coordinates)) << coordinates;
}

TEST(StepFiles, FaultsNameTheLine) {
    const std::string good = "0,1,search,0,1,2,0,0.1,0.2,0.9,0.8,0.5,test,0.2\n";
    EXPECT_EQ(refusal(kFewColumns + good), "");
    EXPECT_EQ(refusal(kFewColumns + good + "\n\n"), "");
    EXPECT_EQ(refusal("rays\n").substr(0, 36), "s.csv: line 1: the header must be \"r");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string row = good;
        row.replace(row.find(from), from.size(), to);
        return refusal(kFewColumns + row);
    };
    EXPECT_EQ(with(",test", ""), "s.csv: line 2: expected 14 values separated by commas, found 13");
    EXPECT_EQ(with("search", "look"), "s.csv: line 2: phase \"look\" is unknown; known: start, search, refine");
    EXPECT_NE(with("test", "jump").find("line 2: decision \"jump\" is unknown; known: start, skip"), std::string::npos);
    EXPECT_EQ(with("0.1,0.2", "x,0.2"), "s.csv: line 2: \"x\" is not a number");
    EXPECT_EQ(with("0.1,0.2", "0.1,nan"), "s.csv: line 2: \"nan\" is not finite");
    EXPECT_EQ(with("0.1,0.2", "0.1,1.5"), "s.csv: line 2: lambda_out is 1.5, but must be within [0, 1]");
    EXPECT_EQ(with("0.1,0.2", "0.3,0.2"), "s.csv: line 2: lambda_out 0.2 lies before lambda_in 0.3");
    EXPECT_EQ(with("0.9,0.8", "0.9,0.7"), "s.csv: line 2: z_out is 0.7, but 1 - lambda is 0.8");
    EXPECT_EQ(with("0,1,search", "5,1,search"),
              "s.csv: line 2: there is no ray 5; the rays file has 2, numbered from 0");
    EXPECT_EQ(with("0,1,search", "0,2,search"), "s.csv: line 2: step 2 of ray 0 is out of order");
    EXPECT_EQ(with("search,0", "search,32"), "");
    for (const std::string level : {"-1", "33"}) {
        EXPECT_EQ(with("search,0", "search," + level),
                  "s.csv: line 2: \"" + level + "\" is not a whole number from 0 to 32");
    }
    // A step's subject, and additional columns of other names.
    const std::string known = "0,1,search,0,1,2,0,0.1,0.2,0.9,0.8,0.5,advance,0.2";
    EXPECT_EQ(refusal(kHeader + known + ",sphere,1,2,0.9,,,,\n"), "");
    EXPECT_EQ(refusal(kHeader + known + ",sphere,1,,0.9,,,,\n"), "s.csv: line 2: \"t\" is missing or is not a number");
    EXPECT_EQ(refusal(kHeader + known + ",cone,1,2,0.9,,,1.5,8\n"),
              "s.csv: line 2: \"index\" is missing or is not a whole number");
    EXPECT_NE(refusal(kHeader + known + ",ball,1,2,0.9,,,,\n").find("kind \"ball\" is unknown; known: texel, quad"),
              std::string::npos);
    EXPECT_EQ(refusal(std::string(kStepColumns) + ",mine,kind\n" + known + ",whatever,point\n"), "");
    EXPECT_NE(refusal(std::string(kStepColumns) + "s\n" + known + "\n"), "");
    EXPECT_NE(refusal("[\n{\"ray\": 0,\n\"number\": 1},\n3]").find("line 2: \"lambda_in\" is missing"),
              std::string::npos)
        << refusal("[\n{\"ray\": 0,\n\"number\": 1},\n3]");
    EXPECT_EQ(refusal("[\n oops"), "s.csv: line 2: this is not JSON");
    const std::string object =
        "{\"ray\": 0, \"number\": 1, \"lambda_in\": 0, \"lambda_out\": 0.5, \"value\": null, \"decision\": \"hit\", "
        "\"lambda_after\": 0.5}";
    EXPECT_EQ(refusal("[" + object + "]"), "");
    for (const std::string index : {"-9223372036854775808", "9223372036854775808", "18446744073709551615"}) {
        EXPECT_NE(refusal("[{\"k\": " + index + ", " + object.substr(1) + "]").find("line 1: \"k\" is missing"),
                  std::string::npos)
            << index;
    }
    EXPECT_NE(refusal("[{\"deep\": " + std::string(200, '[') + std::string(200, ']') + ", " + object.substr(1) + "]")
                  .find("line 1: lists and objects are nested more than 100 levels deep"),
              std::string::npos);
    EXPECT_NE(refusal("[\n" + object + ",\n\n7]").find("line"), std::string::npos);
    EXPECT_NE(refusal("[\n" + object + ",\n" + object + "]").find("line 3: step 1 of ray 0 is out of order"),
              std::string::npos);
    // A texel outside the picture.
    const HeightField field(constantHeights(8, 8, 0.5F), Surface::Columns);
    std::vector<Step> steps = parseSteps(kFewColumns + good, "s.csv", 1).steps;
    EXPECT_NO_THROW(placeSteps(steps, {0, 0, 1, 1}, field, "s.csv", 0));
    steps[0].i = 8;
    try {
        placeSteps(steps, {0, 0, 1, 1}, field, "s.csv", 0);
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "s.csv: ray 0, step 1: level 0 of a picture of 8 x 8 has no texel (8,2)");
    }
}

// Columns that are none of ours are kept with their steps, whatever the order of rays and columns.
TEST(StepFiles, FurtherColumnsAreKept) {
    const auto row = [](int ray, int number) {
        return std::to_string(ray) + "," + std::to_string(number) + ",search,0,1,2,0,0.1,0.2,0.9,0.8,0.5,test,0.2,";
    };
    const std::string text = std::string(kStepColumns) + ",mine,kind,two words\n" + row(1, 1) + "0.25,point,x\n" +
                             row(1, 2) + ",point,y\n" + row(0, 1) + "3,point,\n";
    std::vector<FurtherColumn> further;
    EXPECT_EQ(parseSteps(text, "s.csv", 2, &further).steps.size(), 3U);
    const std::vector<FurtherColumn> kept{{"mine", {"3", "0.25", ""}}, {"two words", {"", "x", "y"}}};
    EXPECT_EQ(further, kept);
    const auto object = [](int ray, int number, const char* more) {
        return "{\"ray\": " + std::to_string(ray) + ", \"number\": " + std::to_string(number) +
               ", \"lambda_in\": 0, \"lambda_out\": 0.5, \"value\": 0, \"decision\": \"test\", \"lambda_after\": 0.5" +
               more + "}";
    };
    const std::string objects = "[" + object(1, 1, ", \"mine\": 0.25, \"two words\": \"x\"") + "," +
                                object(1, 2, ", \"two words\": \"y\"") + "," + object(0, 1, ", \"mine\": 3") + "]";
    parseSteps(objects, "s.json", 2, &further);
    EXPECT_EQ(further, kept);
    EXPECT_EQ(columnNumbers(further[1]), std::nullopt);
    ASSERT_TRUE(columnNumbers(further[0]));
    EXPECT_EQ((*columnNumbers(further[0]))[1], 0.25);
    EXPECT_TRUE(std::isnan((*columnNumbers(further[0]))[2]));
}

}  // namespace
}  // namespace relief::test
