// relief export rays and relief diagnose: the files of a view, and what is said of a tracer's answers to its rays.
#include <nlohmann/json.hpp>

#include "command_test.h"
#include "relief/files.h"
#include "relief/work.h"
#include "scenario/scenario.h"

namespace relief::test {

class DiagnoseTest : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        height_ = makeRelief("bricks", "height.png", {"--size", "64x48"});
        runFine({"export", "rays", height_, "--scene", "wall", "--size", "40x30", "-o", path("rays.csv")});
    }
    // Traces the view's rays in place of somebody's tracer.
    std::string hits(const std::vector<std::string>& with, const std::string& name = "hits.csv") const {
        std::vector<std::string> all{"trace", height_, "--rays", path("rays.csv"), "-o", path(name)};
        all.insert(all.end(), with.begin(), with.end());
        runFine(all);
        return path(name);
    }
    Result diagnosis(const std::vector<std::string>& with) const {
        std::vector<std::string> all{"diagnose", "--rays", path("rays.csv")};
        all.insert(all.end(), with.begin(), with.end());
        return run(all);
    }
    std::string height_;
};
INSTANTIATE_TEST_SUITE_P(Places, DiagnoseTest, testing::ValuesIn(places()), placeName);

// Each row is the ray of the pixel that the file beside it names, and that file is a scenario of the same view.
TEST_P(DiagnoseTest, RaysOfAViewAreThoseOfItsPixels) {
    const auto rays = lines(read("rays.csv"));
    const auto beside = nlohmann::json::parse(read("rays.json"));
    ASSERT_EQ(beside["format"], "reliefscope rays");
    ASSERT_GT(rays.size(), 100U);
    ASSERT_EQ(beside["rays"].size(), rays.size() - 1);
    EXPECT_EQ(rays[0], "s0,t0,a,b");
    for (const std::size_t r : {std::size_t{0}, rays.size() / 2, rays.size() - 2}) {
        const auto& pixel = beside["rays"][r];
        const std::string name = std::to_string(pixel[0].get<int>()) + "," + std::to_string(pixel[1].get<int>());
        EXPECT_EQ(runFine({"trace", path("rays.json"), "--pixel", name}),
                  runFine({"trace", height_, "--ray", rays[r + 1]}));
    }
    // The matrices: the point of a ray at lambda, put into the world and through the camera, is seen at its pixel.
    const auto& camera = beside["camera"];
    const std::size_t r = rays.size() / 3;
    const auto ray = fields(rays[r + 1]);
    const double lambda = 0.25;
    const double point[4] = {std::stod(ray[0]) + lambda * std::stod(ray[2]),
                             std::stod(ray[1]) + lambda * std::stod(ray[3]), lambda, 1};
    const auto times = [](const nlohmann::json& matrix, const double(&v)[4], double(&out)[4]) {
        for (std::size_t row = 0; row < 4; ++row) {
            out[row] = 0;
            for (std::size_t k = 0; k < 4; ++k) out[row] += matrix[row][k].get<double>() * v[k];
        }
    };
    double world[4], seen[4];
    times(beside["polygons"][beside["rays"][r][2].get<std::size_t>()]["world_matrix"], point, world);
    times(camera["view_matrix"], world, seen);
    const auto at = [&](std::size_t k) { return camera["focal_pixels"][k].get<double>() * seen[k] / -seen[2]; };
    EXPECT_NEAR(camera["principal_pixel"][0].get<double>() + at(0), beside["rays"][r][0].get<double>() + 0.5, 1e-6);
    EXPECT_NEAR(camera["principal_pixel"][1].get<double>() - at(1), beside["rays"][r][1].get<double>() + 0.5, 1e-6);
}

TEST_P(DiagnoseTest, FaultsAreNamedOneALine) {
    Result result = diagnosis({height_, "--hits", hits({"--tracer", "layers:layers=12"}), "--picture", path("e.png"),
                               "-o", path("worst.json")});
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_TRUE(result.out.starts_with("stair-steps: ")) << result.out;
    Work work(1);
    const ColorImage picture = readColor(path("e.png"), work);
    EXPECT_EQ(picture.width(), 40);
    EXPECT_EQ(picture.height(), 30);
    // The scenario shows the worst ray in the same view.
    const Scenario worst = loadScenario(path("worst.json"));
    ASSERT_TRUE(worst.pixel);
    EXPECT_EQ(worst.width, 40);
    EXPECT_EQ(worst.scene, SceneKind::Wall);
    ASSERT_FALSE(worst.bookmarks.empty());
    EXPECT_EQ(worst.bookmarks[0].name, "stair-steps");
    EXPECT_EQ(worst.bookmarks[0].pixel, *worst.pixel);
    // Without a height map, that of the view; as JSON.
    result = diagnosis({"--hits", hits({"--invert"}), "--json"});
    EXPECT_EQ(result.status, 1) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["verdict"], "faults");
    ASSERT_EQ(json["faults"].size(), 1U) << result.out;
    EXPECT_EQ(json["faults"][0]["fault"], "inverted-heights");
    EXPECT_EQ(json["rays"], lines(read("rays.csv")).size() - 1);
}

TEST_P(DiagnoseTest, TheStatusTellsHealthyAndUnknown) {
    Result result = diagnosis({height_, "--hits", hits({"--tracer", "cone"}), "-o", path("none.json")});
    EXPECT_EQ(result.status, 0) << result.err << result.out;
    EXPECT_TRUE(result.out.starts_with("no fault: "));
    EXPECT_EQ(read("none.json"), "");
    std::string nonsense = "outcome,lambda,mine\n";
    std::uint32_t state = 1;
    for (std::size_t r = 1; r < lines(read("rays.csv")).size(); ++r) {
        state = state * 1664525U + 1013904223U;
        nonsense += "hit," + std::to_string((state >> 8U) % 1000) + "e-3,x\n";
    }
    result = diagnosis({height_, "--hits", write("nonsense.csv", nonsense)});
    EXPECT_EQ(result.status, 3) << result.err << result.out;
    EXPECT_TRUE(result.out.starts_with("unknown: ")) << result.out;
    result = diagnosis({height_, "--hits", path("nonsense.csv"), "--language", "uk"});
    EXPECT_TRUE(result.out.starts_with("unknown: ")) << result.out;
    EXPECT_NE(result.out.find("променів"), std::string::npos);
}

TEST_P(DiagnoseTest, StepsAreReadWithoutHits) {
    hits({"--tracer", "layers:layers=12", "--steps", path("steps.csv")});
    const Result result = diagnosis({height_, "--steps", path("steps.csv"), "-o", path("worst.json")});
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_TRUE(result.out.starts_with("stair-steps: ")) << result.out;
    EXPECT_TRUE(loadScenario(path("worst.json")).other);
}

TEST_P(DiagnoseTest, WrongFilesAreRefused) {
    const std::string good = hits({});
    const auto refuse = [&](const std::vector<std::string>& with, const std::vector<std::string>& parts) {
        std::vector<std::string> all{"diagnose", height_};
        all.insert(all.end(), with.begin(), with.end());
        expectRefusal(all, 2, parts);
    };
    refuse({"--hits", good}, {"--rays"});
    refuse({"--rays", path("rays.csv")}, {"--hits", "--steps"});
    refuse({"--rays", path("rays.csv"), "--hits", write("few.csv", "outcome,lambda\nhit,0.5\n")},
           {"few.csv", "1", "rays.csv"});
    refuse({"--rays", path("rays.csv"), "--hits", write("head.csv", "lambda\n0.5\n")},
           {"head.csv", "line 1", "outcome,lambda"});
    refuse({"--rays", write("one.csv", "s0,t0,a,b\n1,2,3,4\n"), "--hits", write("x.csv", "outcome,lambda\nhit,1.5\n")},
           {"x.csv", "line 2", "lambda"});
    refuse({"--rays", path("one.csv"), "--hits", write("y.csv", "outcome,lambda\nfound,0.5\n")},
           {"y.csv", "line 2", "found"});
    refuse({"--rays", path("one.csv"), "--hits", write("z.csv", "outcome,lambda,s\nhit,0.5\n")}, {"z.csv", "line 2"});
    refuse({"--rays", write("none.csv", "s0,t0,a,b\n"), "--hits", good}, {"none.csv"});
    refuse({"--rays", path("one.csv"), "--hits", good, "--picture", path("e.gif")}, {"e.gif"});
    // The file beside the rays belongs to others.
    write("rays2.csv", "s0,t0,a,b\n1,2,3,4\n");
    write("rays2.json", read("rays.json"));
    refuse({"--rays", path("rays2.csv"), "--hits", write("h.csv", "outcome,lambda\nhit,0.5\n")},
           {"rays2.json", "rays2.csv"});
    refuse({"--rays", path("rays.csv"), "--hits", good, "-o", path("rays.json")}, {"rays.json: would be overwritten"});
    expectRefusal({"export", "rays", height_}, 2, {"--output"});
    expectRefusal({"export", "rays", height_, "-o", path("r.txt")}, 2, {"r.txt"});
    expectRefusal({"export", "rays", height_, "--eye", "0,-1,0", "--target", "0,-2,0", "-o", path("r.csv")}, 2,
                  {"--camera"});
}

// FILE.json next to the rays replaces an earlier view and no other file, whose name only happens to be the same.
TEST_P(DiagnoseTest, TheViewReplacesNoOtherFile) {
    write("wall.json", R"({"reliefscope": 1, "pictures": {"height": "height.png"}, "size": [40, 30]})");
    write("notes.json", "{}");
    const auto before = files();
    for (const auto& [input, name] : {std::pair(path("wall.json"), "wall"), std::pair(height_, "notes")}) {
        const std::string json = std::string(name) + ".json", bytes = read(json);
        expectRefusal({"export", "rays", input, "-o", path(std::string(name) + ".csv")}, 2,
                      {path(json) + ": would be overwritten by --output " + path(name)});
        EXPECT_EQ(read(json), bytes);
    }
    EXPECT_EQ(files(), before);
    const std::string view = read("rays.json");
    runFine({"export", "rays", height_, "--scene", "wall", "--size", "20x15", "-o", path("rays.csv")});
    EXPECT_NE(read("rays.json"), view);
}

}  // namespace relief::test
