// Several pictures by one command: lists of scenarios and camera paths, each picture equal to that of a single command.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "command_test.h"

namespace relief::test {

class RenderManyTest : public CommandTest {
  protected:
    std::string scenario(const std::string& name, const std::string& relief, int elevation) const {
        const std::string recipe = R"({"name": ")" + relief + R"(", "width": 32, "height": 32})";
        return write(name, R"({"reliefscope": 1, "pictures": {"recipe": )" + recipe +
                               R"(}, "size": [60, 40], "camera": {"elevation": )" + std::to_string(elevation) + "}}");
    }
    std::vector<std::string> named(const std::string& folder) const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(path(folder))) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }
    std::vector<std::string> pathOf(const std::string& folder, const std::string& frames) const {
        return {"render",
                "--relief",
                "bricks:64x64",
                "--size",
                "60x40",
                "--camera",
                "elevation=60,azimuth=0,distance=1.5",
                "--to",
                "elevation=20,azimuth=90",
                "--frames",
                frames,
                "-o",
                path(folder)};
    }
};

INSTANTIATE_TEST_SUITE_P(Places, RenderManyTest, testing::ValuesIn(places()), placeName);

// Data of one picture do not affect the next: flat ground before uneven ground, another addressing.
TEST_P(RenderManyTest, EachIsAsIfItWereAlone) {
    const auto map = [&](const std::string& name, bool flat) {
        std::string text = "P2 16 16 255\n";
        for (int n = 0; n < 16 * 16; ++n) text += std::to_string(flat ? 128 : n * 37 % 251) + "\n";
        return write(name, text);
    };
    map("flat.pgm", true);
    map("rough.pgm", false);
    std::vector<std::string> names, all{"render"};
    for (const auto& [heights, address] : std::vector<std::pair<std::string, std::string>>{
             {"flat", "repeat"}, {"rough", "repeat"}, {"rough", "clamp"}, {"flat", "clamp"}}) {
        names.push_back(heights + "-" + address);
        all.push_back(write(names.back() + ".json",
                            R"({"reliefscope": 1, "pictures": {"height": ")" + heights +
                                R"(.pgm", "range": "0,255"}, "relief": {"depth": 0.2, "address": ")" + address +
                                R"("}, "filter": "trilinear", "size": [60, 40], "shadows": true,
                "camera": {"elevation": 20}})"));
    }
    all.insert(all.end(), {"-o", path("many")});
    runFine(all);
    for (std::size_t n = 0; n < names.size(); ++n) {
        runFine({"render", all[n + 1], "-o", path("alone.png")});
        EXPECT_EQ(read("many/" + names[n] + ".png"), read("alone.png")) << names[n];
    }
    EXPECT_NE(read("many/rough-repeat.png"), read("many/rough-clamp.png"));
    EXPECT_NE(read("many/rough-clamp.png"), read("many/flat-clamp.png"));
}

TEST_P(RenderManyTest, AListOfScenarios) {
    const std::string first = scenario("one.json", "bricks", 50);
    const std::string second = scenario("two.json", "hills", 30);
    runFine({"render", first, second, "--tracer", "exact", "-o", path("many")});
    EXPECT_EQ(named("many"), (std::vector<std::string>{"one.png", "two.png"}));
    runFine({"render", second, "--tracer", "exact", "-o", path("two.png")});
    EXPECT_EQ(read("many/two.png"), read("two.png"));
    EXPECT_NE(read("many/one.png"), read("two.png"));
    runFine({"render", first, second, "--layers", "depth,steps", "-o", path("layers")});
    EXPECT_EQ(named("layers"), (std::vector<std::string>{"one.exr", "two.exr"}));
    runFine({"render", second, "--layers", "depth,steps", "-o", path("two.exr")});
    EXPECT_TRUE(withoutDate(read("layers/two.exr")) == withoutDate(read("two.exr")));
}

TEST_P(RenderManyTest, APathOfTheCamera) {
    runFine(pathOf("path", "5"));
    EXPECT_EQ(named("path"), (std::vector<std::string>{"frame_00000.png", "frame_00001.png", "frame_00002.png",
                                                       "frame_00003.png", "frame_00004.png"}));
    // The ends and the middle.
    const std::pair<const char*, const char*> some[] = {
        {"path/frame_00000.png", "elevation=60,azimuth=0,distance=1.5"},
        {"path/frame_00002.png", "elevation=40,azimuth=45,distance=1.5"},
        {"path/frame_00004.png", "elevation=20,azimuth=90,distance=1.5"}};
    for (const auto& [name, camera] : some) {
        runFine({"render", "--relief", "bricks:64x64", "--size", "60x40", "--camera", camera, "-o", path("f.png")});
        EXPECT_EQ(read(name), read("f.png")) << name;
    }
}

// Each picture of a sweep is that of a single command with the value.
TEST_P(RenderManyTest, ASweepOfAnOption) {
    const std::vector<std::string> one{"render", "--relief", "bricks:64x64", "--size", "60x40", "--tracer", "layers"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), one.begin(), one.end());
        return more;
    };
    runFine(with({"--sweep", "layers=2..8", "--frames", "3", "-o", path("sweep")}));
    EXPECT_EQ(named("sweep"), (std::vector<std::string>{"frame_00000.png", "frame_00001.png", "frame_00002.png"}));
    runFine(with({"--set", "layers=5", "-o", path("five.png")}));
    EXPECT_EQ(read("sweep/frame_00001.png"), read("five.png"));
    runFine(with(
        {"--sweep", "light-azimuth=0,120", "--light", "azimuth=7", "--layers", "color,depth", "-o", path("light")}));
    EXPECT_EQ(named("light"), (std::vector<std::string>{"frame_00000.exr", "frame_00001.exr"}));
    runFine(with({"--light", "azimuth=120", "--layers", "color,depth", "-o", path("light.exr")}));
    EXPECT_TRUE(withoutDate(read("light/frame_00001.exr")) == withoutDate(read("light.exr")));
    expectRefusal(with({"--sweep", "layer=2..8", "-o", path("none")}), 2, {"--sweep", "did you mean \"layers\"?"});
    expectRefusal(with({"--sweep", "layers=2..8", "--to", "azimuth=3", "--frames", "3", "-o", path("none")}), 2,
                  {"--sweep", "--to"});
    expectRefusal(with({"--sweep", "layers=2..8", "-o", path("none.png")}), 2, {"--sweep", path("none.png")});
}

// Frames of two paths, or of two maps, must not be mixed in one folder.
TEST_P(RenderManyTest, AnotherPathIsNotResumed) {
    auto stopped = pathOf("path", "400");
    const std::string map = makeRelief("bricks:64x64", "map.png");
    stopped[1] = "--height";
    stopped[2] = map;
    const RunSetup setup = interruptedWhen([&] { return std::filesystem::exists(path("path/frame_00002.png")); });
    ASSERT_EQ(run(stopped, setup).status, 130);
    ASSERT_TRUE(std::filesystem::exists(path("path/pictures.part")));
    const auto refused = [&](const std::string& from, const std::string& to) {
        auto other = stopped;
        *std::find(other.begin(), other.end(), from) = to;
        other.push_back("--resume");
        expectRefusal(other, 2, {path("path/pictures.part"), "--anew"});
    };
    refused("elevation=20,azimuth=90", "elevation=20,azimuth=80");
    refused("400", "399");
    const auto time = std::filesystem::last_write_time(map);
    std::filesystem::last_write_time(map, time + std::chrono::seconds(1));
    refused(map, map);
    std::filesystem::last_write_time(map, time);
    stopped.push_back("--resume");
    EXPECT_EQ(run(stopped).status, 0);
}

// Runs shared by several processes are tested in MpiTest.
TEST_P(RenderManyTest, KilledItResumesToTheSamePictures) {
    runFine(pathOf("whole", "40"));
    auto arguments = pathOf("killed", "40");
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char*> pointers{const_cast<char*>(RELIEF_PROGRAM)};
        for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
        pointers.push_back(nullptr);
        execv(RELIEF_PROGRAM, pointers.data());
        _exit(127);
    }
    const auto begun = std::chrono::steady_clock::now();
    while (!std::filesystem::exists(path("killed/frame_00003.png"))) {
        ASSERT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(60));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it must not have finished";
    EXPECT_TRUE(std::filesystem::exists(path("killed/pictures.part")));
    arguments.push_back("--resume");
    const Result last = run(arguments);
    EXPECT_EQ(last.status, 0) << last.err;
    EXPECT_NE(last.err.find("of 40"), std::string::npos) << last.err;
    // The killed process may have left a temporary file.
    for (const std::string& name : named("whole")) EXPECT_EQ(read("killed/" + name), read("whole/" + name)) << name;
    EXPECT_FALSE(std::filesystem::exists(path("killed/pictures.part")));
    // If all is done, there is nothing to resume.
    auto again = pathOf("whole", "40");
    again.push_back("--resume");
    EXPECT_EQ(run(again).status, 0);
}

TEST_P(RenderManyTest, OnePictureIsNoRunToResume) {
    for (const char* flag : {"--resume", "--anew"}) {
        expectRefusal({"render", "--relief", "bricks:64x64", "-o", path("f.png"), flag}, 2,
                      {flag, "--tiled", "--frames"});
    }
    EXPECT_TRUE(files().empty());
}

TEST_P(RenderManyTest, AnEarlierRunIsNotDiscardedUnasked) {
    std::filesystem::create_directory(path("path"));
    write("path/pictures.part", "kept");
    const auto with = [&](const char* flag) {
        auto all = pathOf("path", "2");
        all.push_back(flag);
        return all;
    };
    expectRefusal(pathOf("path", "2"), 2, {path("path/pictures.part"), "--resume", "--anew"});
    expectRefusal(with("--resume"), 2, {path("path/pictures.part"), "--anew"});
    EXPECT_EQ(read("path/pictures.part"), "kept");
    runFine(with("--anew"));
    EXPECT_EQ(named("path"), (std::vector<std::string>{"frame_00000.png", "frame_00001.png"}));
}

TEST_P(RenderManyTest, WrongRequestsAreRefused) {
    const std::string one = scenario("one.json", "bricks", 50);
    expectRefusal({"render", one, one, "-o", path("many")}, 2, {one, "more than once"});
    expectRefusal({"render", one, path("none.json"), "-o", path("many")}, 2, {path("none.json")});
    expectRefusal({"render", one, "--to", "elevation=3", "-o", path("many")}, 2, {"--to", "--frames"});
    expectRefusal({"render", one, "--frames", "0", "-o", path("many")}, 2, {"--frames"});
    expectRefusal({"render", one, "--frames", "3", "--to", "height=3", "-o", path("many")}, 2, {"--to", "\"height\""});
    expectRefusal({"render", one, "--eye", "0,1,1", "--target", "0,0,0", "--frames", "3", "--to", "elevation=3", "-o",
                   path("many")},
                  2, {"--to", "--eye"});
    expectRefusal({"render", one, "--frames", "3", "--report", "-", "-o", path("many")}, 2, {"--report"});
    expectRefusal({"render", one, "--frames", "3", "-o", one}, 2, {"--frames", one});
    expectRefusal({"render", one, "--frames", "3", "-o", write("taken", "x")}, 1, {path("taken")});
}

}  // namespace relief::test
