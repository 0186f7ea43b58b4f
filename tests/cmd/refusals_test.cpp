// Pictures that cannot be height maps, names that no file can have, and outputs that would replace an input: each is
// refused with one line that names the file.
#include <cmath>
#include <limits>

#include "command_test.h"

namespace relief::test {

class RefusalTest : public CommandTest {
  protected:
    // Every command that reads a height map refuses it and leaves no file.
    void expectUnreadable(const std::string& picture, const std::vector<std::string>& parts) const {
        std::vector<std::string> all = parts;
        all.push_back("relief: " + picture + ": ");
        const auto before = files();
        expectRefusal({"info", picture}, 2, all);
        expectRefusal({"render", "--height", picture, "-o", path("out.png")}, 2, all);
        expectRefusal({"trace", "--height", picture, "--pixel", "1,1", "-o", path("hits.csv")}, 2, all);
        EXPECT_EQ(files(), before);
    }
};
INSTANTIATE_TEST_SUITE_P(Places, RefusalTest, testing::ValuesIn(places()), placeName);

TEST_P(RefusalTest, Missing) {
    expectUnreadable(path("немає.png"), {"no such file"});
}

TEST_P(RefusalTest, Directory) {
    std::filesystem::create_directory(path("folder.png"));
    expectUnreadable(path("folder.png"), {"directory"});
}

TEST_P(RefusalTest, Empty) {
    expectUnreadable(write("empty.png", ""), {"empty"});
}

TEST_P(RefusalTest, NotAnImage) {
    expectUnreadable(write("letter.png", "Dear picture, you are a letter.\n"), {});
    expectUnreadable(write("letter.txt", "Dear picture, you are a letter.\n"), {});
    expectUnreadable(write("letter", "no ending at all\n"), {});
    expectUnreadable(write("noise.exr", std::string("\x76\x2f\x31\x01 and then nothing that makes sense")), {});
}

TEST_P(RefusalTest, TruncatedPng) {
    makeRelief("fractal", "whole.png");
    const std::string bytes = read("whole.png");
    for (const std::size_t kept : {std::size_t{7}, std::size_t{20}, std::size_t{40}, bytes.size() / 2}) {
        expectUnreadable(write("cut.png", bytes.substr(0, kept)), {});
    }
}

TEST_P(RefusalTest, TruncatedJpeg) {
    const std::string height = makeRelief("bricks", "bricks.png");
    runFine({"render", "--height", height, "--size", "160x120", "-o", path("whole.jpg")});
    const std::string bytes = read("whole.jpg");
    for (const std::size_t kept : {std::size_t{3}, std::size_t{100}, bytes.size() / 2}) {
        expectUnreadable(write("cut.jpg", bytes.substr(0, kept)), {});
    }
}

TEST_P(RefusalTest, NotFinite) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    expectUnreadable(write("nan.exr", exrBytes(3, 2, {0, 0.5F, 1, 0, 0.25F, nan})), {"2", "1"});
    expectUnreadable(write("inf.exr", exrBytes(3, 2, {0, inf, 1, 0, -inf, nan})), {"1", "0"});
}

TEST_P(RefusalTest, FloatsAreTakenOrStretchedWithAMessage) {
    runFine({"info", write("unit.exr", exrBytes(2, 1, {0.25F, 0.75F}))});
    const Result stretched = run(
        {"render", "--height", write("metres.exr", exrBytes(2, 1, {100, 300})), "--size", "8x8", "-o", path("x.png")});
    EXPECT_EQ(stretched.status, 0);
    EXPECT_EQ(lines(stretched.err).size(), 1U) << stretched.err;
    EXPECT_NE(stretched.err.find("300"), std::string::npos) << stretched.err;
    runFine({"render", "--height", path("metres.exr"), "--size", "8x8", "-o", path("x.png"), "--quiet"});
    expectRefusal({"info", path("metres.exr"), "--range", "full"}, 2, {"metres.exr"});
    runFine({"info", path("metres.exr"), "--range", "0,1000"});
}

TEST_P(RefusalTest, TooManyPixels) {
    const std::string height = makeRelief("hills", "hills.png", {"--size", "20x30"});
    expectRefusal({"info", height, "--max-pixels", "599"}, 2, {height, "599"});
    runFine({"info", height, "--max-pixels", "600"});
    // A header that declares 3.6 billion pixels must not be trusted.
    expectUnreadable(write("bomb.png", pngHeaderBytes(60000, 60000)), {});
    expectUnreadable(write("none.png", pngHeaderBytes(0, 5)), {});
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // the sanitizers reserve terabytes
// Every command prints in one line how much memory it needs and how much is free, and leaves no file.
TEST_P(RefusalTest, MoreMemoryThanThereIs) {
    RunSetup small;
    small.addressSpace = std::int64_t{2} << 30U;
    const std::string height = makeRelief("hills", "hills.png", {"--size", "16"});
    const std::string wide = makeRelief("hills", "wide.png", {"--size", "1024"});
    // Most of the data is missing, so the file is refused before it is read; a shorter one could not hold the picture
    // in any format.
    const std::string huge = write("huge.pgm", "P5\n32000 32000\n255\n" + std::string(40'000, '\0'));
    const std::string many = "1024000000";
    const std::vector<std::string> parts{"GB of memory are needed", "GB are free"};
    const auto before = files();
    const auto refuse = [&](const std::vector<std::string>& arguments, const std::string& subject) {
        std::vector<std::string> all = parts;
        all.push_back("relief: " + subject);
        expectRefusal(arguments, 2, all, small);
        EXPECT_EQ(files(), before);
    };
    // The largest map that is made in memory takes 1 GiB.
    small.addressSpace = std::int64_t{1} << 30U;
    refuse({"make", "fractal", "--size", "16384", "-o", path("x.png")}, "fractal:16384x16384: ");
    small.addressSpace = std::int64_t{2} << 30U;
    refuse({"render", "--height", height, "--size", "32768x32768", "-o", path("x.png")}, "--size 32768x32768: ");
    refuse({"render", "--height", height, "--size", "12000x12000", "--supersample", "2", "-o", path("x.png")},
           "--size 12000x12000: ");
    refuse({"render", "--height", height, "--size", "8000x8000", "--layers", "uv,normal", "-o", path("x.exr")},
           "--size 8000x8000: ");
    refuse({"info", huge, "--max-pixels", many}, huge + ": ");
    refuse({"compare", huge, huge, "--max-pixels", many}, huge + ": ");
    for (const std::string command : {"render", "trace", "map", "recommend", "certify"}) {
        std::vector<std::string> arguments{command, "--height", huge, "--max-pixels", many};
        if (command == "map") arguments.insert(arguments.begin() + 1, "cone");
        if (command == "map") arguments.insert(arguments.end(), {"-o", path("x.tif")});
        if (command == "render") arguments.insert(arguments.end(), {"-o", path("x.png")});
        if (command == "certify") arguments.insert(arguments.end(), {"--map", height});
        if (command == "trace") arguments.insert(arguments.end(), {"--pixel", "1,1"});
        refuse(arguments, huge + ": ");
    }
    refuse({"map", "euclidean", "--height", wide, "--set", "layers=512", "-o", path("x.tif")}, "map euclidean: ");
}
#endif

TEST_P(RefusalTest, UnknownChannel) {
    const std::string height = makeRelief("hills", "hills.png", {"--size", "16"});
    expectRefusal({"info", height, "--channel", "Z"}, 2, {height, "Z"});
    expectRefusal({"info", height, "--channel", "7"}, 2, {height, "7"});
    runFine({"info", height, "--channel", "0"});
}

TEST_P(RefusalTest, WrongValues) {
    const std::string height = makeRelief("hills", "hills.png", {"--size", "16"});
    const auto refuse = [&](const std::vector<std::string>& more, const std::vector<std::string>& parts) {
        std::vector<std::string> arguments{"render", "--height", height, "-o", path("x.png")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expectRefusal(arguments, 2, parts);
    };
    refuse({"--tracer", "magic"}, {"magic", "max-pyramid"});
    refuse({"--filter", "magic"}, {"magic", "bilinear"});
    refuse({"--scene", "sea"}, {"sea", "floor"});
    refuse({"--address", "mirror"}, {"mirror", "repeat"});
    refuse({"--surface", "spline"}, {"spline", "columns"});
    refuse({"--set", "layers=64"}, {"--set", "layers"});
    refuse({"--set", "nonsense"}, {"--set", "nonsense"});
    refuse({"--relief-depth", "-1"}, {"--relief-depth"});
    refuse({"--relief-depth", "0,5"}, {"--relief-depth", "0,5"});
    refuse({"--relief-depth", "nan"}, {"--relief-depth"});
    refuse({"--size", "800x"}, {"--size", "800x600"});
    refuse({"--size", "8x8x8"}, {"--size", "512 for 512x512"});
    refuse({"--size", "0x600"}, {"--size"});
    refuse({"--size", "99999999999x600"}, {"--size"});
    refuse({"--camera", "elevation=91"}, {"--camera", "91"});
    refuse({"--camera", "height=3"}, {"--camera", "height"});
    refuse({"--camera", "elevation"}, {"--camera"});
    refuse({"--camera", "elevation=20", "--eye", "0,1,2"}, {"--camera", "--eye"});
    refuse({"--eye", "0,1,2"}, {"--target"});
    refuse({"--eye", "0,1,2", "--target", "0,1,2"}, {"--camera"});
    refuse({"--light", "ambient=2"}, {"--light", "2"});
    refuse({"--range", "5"}, {"--range"});
    refuse({"--threads", "-1"}, {"--threads"});
    refuse({"--max-pixels", "many"}, {"--max-pixels", "many"});
    refuse({"--layers", "color"}, {".exr"});
    refuse({"--relief", "bricks"}, {"--height", "--relief"});
    expectRefusal({"render", "-o", path("x.png")}, 2, {"--height"});
    expectRefusal({"make", "moon", "-o", path("x.png")}, 2, {"moon", "bricks"});
    expectRefusal({"make", "bricks", "--size", "0", "-o", path("x.png")}, 2, {"--size"});
    // Larger maps are written in tiles.
    expectRefusal({"make", "bricks", "--size", "32768x8193", "-o", path("x.png")}, 2, {"x.png", "tif"});
    expectRefusal({"make", "bricks:32769x1", "-o", path("x.exr")}, 2, {"x.exr", "tif"});
    expectRefusal({"make", "bricks:262145x1", "-o", path("x.tif")}, 2, {"262144"});
    expectRefusal({"render", "--relief", "pits:32768x32768", "-o", path("x.png")}, 2, {"--relief", "268435456"});
    expectRefusal({"make", "bricks", "--seed", "-1", "-o", path("x.png")}, 2, {"--seed"});
}

// The system refuses them where other names are only missing.
TEST_P(RefusalTest, NamesThatAreTooLong) {
    const std::string name = path(std::string(300, 'n'));
    for (const std::string& part : {name, name + ".csv"}) {
        expectRefusal({"merge", part, "-o", path("m.csv")}, 2, {"relief: " + part + ": ", "File name too long"});
    }
    const std::vector<std::string> many{"render", "--relief", "hills:16x16", "--frames", "2", "-o"};
    const auto to = [&](const std::string& folder) {
        std::vector<std::string> all = many;
        all.push_back(folder);
        return all;
    };
    expectRefusal(to(name), 1, {"relief: " + name + ": "});
    expectRefusal(to(name + ".png"), 2, {"relief: --frames: ", name});
    expectRefusal({"stress", "--cases", "1", "-o", name}, 1, {"relief: " + name + ": ", "there is no folder"});
    // One process of two, which needs a folder of its own for its bands.
    RunSetup setup;
    setup.variables = {{"OMPI_COMM_WORLD_SIZE", "2"}, {"OMPI_COMM_WORLD_RANK", "0"}, {"TMPDIR", path("none")}};
    expectRefusal({"render", "--relief", "hills:16x16", "-o", path("x.png")}, 1, {"relief: TMPDIR: "}, setup);
    EXPECT_TRUE(files().empty());
}

TEST_P(RefusalTest, OwnFilesAreNotOverwritten) {
    const std::string a = makeRelief("hills", "a.png", {"--size", "16"});
    const std::string b = makeRelief("bricks", "b.png", {"--size", "16"});
    const std::string tif = makeRelief("hills", "t.tif", {"--size", "16"});
    const std::string exr = write("c.exr", exrBytes(2, 2, {0, 1, 1, 0}));
    const std::string scene =
        write("a.json", R"({"reliefscope": 1, "pictures": {"height": "a.png"}, "size": [20, 10]})");
    const std::string rays = write("rays.csv", "s0,t0,a,b\n1,2,3,4\n");
    std::filesystem::create_symlink("a.png", path("link.png"));
    const auto bytesOfAll = [&] {
        std::vector<std::string> all = files();
        for (std::string& name : all) name += "\n" + read(name);
        return all;
    };
    const auto before = bytesOfAll();
    const auto refuse = [&](const std::vector<std::string>& arguments, const std::string& file) {
        expectRefusal(arguments, 2, {file + ": would be overwritten by --"});
        EXPECT_EQ(bytesOfAll(), before);
    };
    refuse({"render", a, b, "-o", path("")}, a);
    refuse({"render", scene, b, "-o", path("")}, a);
    refuse({"render", a, "--frames", "1", "--color", b, "-o", path("")}, a);
    refuse({"render", exr, b, "--layers", "depth", "-o", path("")}, exr);
    refuse({"render", a, "-o", path("link.png")}, a);
    refuse({"render", scene, "--color", b, "-o", b}, b);
    refuse({"render", tif, "--tiled", "-o", tif}, tif);
    refuse({"render", scene, "--report", scene, "-o", path("x.png")}, scene);
    refuse({"tile", tif, "-o", tif}, tif);
    refuse({"map", "cone", tif, "-o", tif}, tif);
    refuse({"map", "max-pyramid", tif, "-o", tif}, tif);
    refuse({"map", "normals", a, "-o", a}, a);
    refuse({"compare", a, b, "-o", b}, b);
    refuse({"trace", a, "--ray", "1,1,1,1", "-o", a}, a);
    refuse({"trace", a, "--rays", rays, "-o", rays}, rays);
    refuse({"trace", scene, "--ray", "1,1,1,1", "--steps", scene}, scene);
    refuse({"certify", scene, "-o", scene}, scene);
    refuse({"recommend", scene, "-o", scene}, scene);
    refuse({"recommend", a, "--check", "-o", a}, a);
}

}  // namespace relief::test
