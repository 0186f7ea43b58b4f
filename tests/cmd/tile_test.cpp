// relief tile: what it writes is tested with the library; here what the user sees.
#include <filesystem>

#include <nlohmann/json.hpp>

#include "command_test.h"

namespace relief::test {

class TileTest : public CommandTest {};
INSTANTIATE_TEST_SUITE_P(Places, TileTest, testing::ValuesIn(places()), placeName);

TEST_P(TileTest, InfoDescribesWhatTileWrites) {
    const std::string hills = makeRelief("hills", "hills.png", {"--size", "200x130"});
    EXPECT_EQ(runFine({"tile", hills, "-o", path("tiled.tif")}), "");
    EXPECT_EQ(files(), (std::vector<std::string>{"hills.png", "tiled.tif"}));
    const std::string size = std::to_string(std::filesystem::file_size(path("tiled.tif")));
    const std::string text = runFine({"info", path("tiled.tif")});
    const auto row = [&](const std::string& label, const std::string& value) {
        EXPECT_NE(text.find("\n  " + label + std::string(24 - label.size(), ' ') + value), std::string::npos) << text;
    };
    row("format", "tiled pyramid, which tools read by tiles\n");
    row("size, texels", "200 x 130\n");
    row("type", "uint16\n");
    row("pages",
        "26: the heights, 8 levels each of maxima, minima and means, the checksums; tiles of 64 x 64 texels\n");
    row("bytes", size + "\n");

    const auto tiled = nlohmann::json::parse(runFine({"info", path("tiled.tif"), "--json"}));
    const auto whole = nlohmann::json::parse(runFine({"info", hills, "--json"}));
    EXPECT_EQ(tiled.at("kind"), "tiled");
    EXPECT_EQ(tiled.at("width"), 200);
    EXPECT_EQ(tiled.at("levels"), 9);
    EXPECT_EQ(tiled.at("heights"), whole.at("heights"));
    EXPECT_NEAR(tiled.at("mean_height").get<double>(), whole.at("mean_height").get<double>(), 1e-6);
    EXPECT_NE(runFine({"info", path("tiled.tif"), "--language", "uk"}).find("піраміда з плиток"), std::string::npos);

    // The same heights by the other spelling.
    runFine({"tile", "--height", hills, "-o", path("again.tif"), "--threads", "1"});
    EXPECT_TRUE(read("again.tif") == read("tiled.tif"));
    // Nothing but the coarsest level is read.
    std::filesystem::resize_file(path("tiled.tif"), 1000);
    expectRefusal({"info", path("tiled.tif")}, 2, {"tiled.tif"});
}

TEST_P(TileTest, MakeWritesTheSameFile) {
    runFine({"tile", makeRelief("hills", "hills.png", {"--size", "200x130"}), "-o", path("tiled.tif")});
    EXPECT_EQ(runFine({"make", "hills:200x130", "--tiled", "-o", path("made.tif")}), "");
    EXPECT_TRUE(read("made.tif") == read("tiled.tif"));
    // What is too large for other files is written in tiles anyway.
    runFine({"make", "fractal", "--size", "40000x3", "-o", path("wide.tif")});
    const auto wide = nlohmann::json::parse(runFine({"info", path("wide.tif"), "--json"}));
    EXPECT_EQ(wide.at("kind"), "tiled");
    EXPECT_EQ(wide.at("width"), 40000);
    EXPECT_EQ(wide.at("type"), "uint16");
    expectRefusal({"make", "hills", "--tiled", "-o", path("a.png")}, 2, {"a.png", "tif"});
    expectRefusal({"make", "hills", "--resume", "-o", path("a.png")}, 2, {"--resume", "--tiled"});
    expectRefusal({"make", "drawn:2x2:0,1,1,0", "--tiled", "-o", path("a.tif")}, 2, {"--tiled"});
    EXPECT_EQ(files(), (std::vector<std::string>{"hills.png", "made.tif", "tiled.tif", "wide.tif"}));
}

TEST_P(TileTest, ConversionsAreSaid) {
    const std::string picture = write("a.exr", exrBytes(3, 1, {-1, 0, 3}));
    const Result stretched = run({"tile", picture, "-o", path("t.tif")});
    EXPECT_EQ(stretched.status, 0);
    EXPECT_EQ(stretched.err, "relief: " + picture + ": heights from -1 to 3 were stretched to [0, 1]\n");
    const Result clamped = run({"tile", picture, "-o", path("t.tif"), "--range", "0,2", "--invert"});
    EXPECT_EQ(clamped.err, "relief: " + picture + ": 2 heights outside 0 to 2 were clamped\n");
    runFine({"tile", picture, "-o", path("t.tif"), "--quiet"});
}

TEST_P(TileTest, Refusals) {
    const std::string picture = write("a.exr", exrBytes(2, 1, {0, 1}));
    const std::string output = path("t.tif");
    expectRefusal({"tile", "-o", output}, 2, {"FILE"});
    expectRefusal({"tile", picture}, 2, {"--output"});
    expectRefusal({"tile", picture, "-o", path("t.png")}, 2, {"t.png"});
    expectRefusal({"tile", picture, "--height", picture, "-o", output}, 2, {"--height"});
    expectRefusal({"tile", picture, "-o", output, "--resume", "--anew"}, 2, {"--anew", "--resume"});
    expectRefusal({"tile", picture, "-o", output, "--max-pixels", "1"}, 2, {"--max-pixels"});
    expectRefusal({"tile", path("none.png"), "-o", output}, 2, {"none.png"});
    expectRefusal({"tile", write("text.tif", "no picture"), "-o", output}, 2, {"text.tif"});
    expectRefusal({"tile", picture, "-o", path("no/t.tif")}, 1, {"no/t.tif", "there is no folder"});
    expectRefusal({"tile", picture, "-o", output}, 1, {"t.tif"}, {.largestFile = 1000});
    EXPECT_EQ(files(), (std::vector<std::string>{"a.exr", "text.tif"}));
}

TEST_P(TileTest, AnInterruptedRunOfMakeGoesOn) {
    // Its heights are stretched between the lowest and the highest, which the part of the run has found.
    const std::vector<std::string> make{"make", "fractal:2048x4096", "--tiled", "-o", path("t.tif")};
    runFine({"make", "fractal:2048x4096", "--tiled", "-o", path("whole.tif")});
    RunSetup setup;
    setup.interruptAfterMilliseconds = 60'000;
    setup.interruptWhen = [&] { return std::filesystem::exists(path("t.tif.part")); };
    EXPECT_EQ(run(make, setup).status, 130);
    std::vector<std::string> resumed = make;
    resumed.emplace_back("--resume");
    EXPECT_EQ(run(resumed).status, 0);
    EXPECT_TRUE(read("t.tif") == read("whole.tif"));
}

TEST_P(TileTest, AnInterruptedRunGoesOn) {
    const std::string checker = makeRelief("checker", "checker.tif", {"--size", "2048x4096"});
    runFine({"tile", checker, "-o", path("whole.tif")});
    const std::string output = path("t.tif");
    RunSetup setup;
    setup.interruptAfterMilliseconds = 60'000;
    setup.interruptWhen = [&] { return std::filesystem::exists(output + ".part"); };
    const Result stopped = run({"tile", checker, "-o", output}, setup);
    EXPECT_EQ(stopped.status, 130);
    EXPECT_EQ(stopped.err.find("relief: " + output + ".part: stopped: "), 0U) << stopped.err;
    EXPECT_NE(stopped.err.find(
                  " of 64 parts are done and kept in this file; run the same command with --resume to continue\n"),
              std::string::npos)
        << stopped.err;
    EXPECT_FALSE(std::filesystem::exists(output));
    expectRefusal({"tile", checker, "-o", output}, 2, {"t.tif.part", "--resume", "--anew"});
    const Result resumed = run({"tile", checker, "-o", output, "--resume"});
    EXPECT_EQ(resumed.status, 0);
    EXPECT_NE(resumed.err.find(" of 64 parts are already done\n"), std::string::npos) << resumed.err;
    EXPECT_TRUE(read("t.tif") == read("whole.tif"));
    EXPECT_EQ(files(), (std::vector<std::string>{"checker.tif", "t.tif", "whole.tif"}));
}

// On file systems of their own that are too small by more or less, and grow before the run goes on.
TEST_P(TileTest, AFullDiskKeepsWhatIsDone) {
    const std::string hills = makeRelief("hills", "hills.exr", {"--size", "512"});
    runFine({"tile", hills, "-o", path("whole.tif")});
    const std::string disk = path("disk");
    std::filesystem::create_directory(disk);
    RunSetup mounting;
    mounting.launcher = {"unshare", "--map-root-user", "--mount"};
    mounting.program = "mount";
    if (run({"-t", "tmpfs", "none", disk}, mounting).status != 0) GTEST_SKIP() << "file systems cannot be mounted here";
    const std::string script = R"(
        mount -t tmpfs -o size=$2 none "$3" || exit 9
        "$1" tile "$4" -o "$3/t.tif"; status=$?
        mount -o remount,size=64m "$3" || exit 9
        "$1" tile "$4" -o "$3/t.tif" --resume --quiet && cmp "$3/t.tif" "$5" && exit $status)";
    for (const char* size : {"1500k", "2500k"}) {
        RunSetup setup;
        setup.launcher = {"unshare", "--map-root-user", "--mount", "bash", "-c", script, "bash"};
        const Result result = run({size, disk, hills, path("whole.tif")}, setup);
        EXPECT_EQ(result.status, 1) << size;
        EXPECT_EQ(result.err.find("relief: " + disk + "/t.tif: no space left on the disk; "), 0U) << result.err;
        EXPECT_NE(result.err.find(" of 8 parts are done and kept in " + disk + "/t.tif.part; "), std::string::npos);
        EXPECT_EQ(lines(result.err).size(), 1U) << result.err;
        EXPECT_EQ(result.out, "");
    }
}

}  // namespace relief::test
