// Pictures larger than memory: relief render --tiled writes the pixels of one piece, in parts, over interruptions and
// full disks.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numeric>

#include "command_test.h"
#include "images/picture_input.h"
#include "relief/files.h"

namespace relief::test {

class RenderTiledTest : public CommandTest {
  protected:
    std::string size_ = "70x275";

    std::vector<std::string> render(const std::string& output, const std::vector<std::string>& more) const {
        std::vector<std::string> all{"render",  "--relief", "bricks:48x32", "--size", size_,
                                     "--scene", "cube",     "--shadows",    "-o",     path(output)};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    // Renders all parts and joins them; returns the joined file's bytes.
    std::string merged(int of, const std::string& ending, std::vector<std::string> look) const {
        std::vector<std::string> merge{"merge", "-o", path("merged" + ending)};
        for (int part = of; part >= 1; --part) {
            const std::string name = "part" + std::to_string(part) + ending;
            look.insert(look.end(), {"--part", std::to_string(part) + "/" + std::to_string(of)});
            runFine(render(name, look));
            look.resize(look.size() - 2);
            merge.push_back(path(name));
        }
        runFine(merge);
        return read("merged" + ending);
    }
    ColorImage picture(const std::string& name) const {
        Work work(1);
        return readColor(path(name), work);
    }
    // The bits of all planes by their names.
    std::map<std::string, std::string> planes(const std::string& name) const {
        Work work(1);
        PictureInput input(path(name), 1 << 20);
        std::vector<int> channels(input.info().channels.size());
        std::iota(channels.begin(), channels.end(), 0);
        const RawPlanes raw = input.read(channels, work, 0);
        std::map<std::string, std::string> all;
        const auto pixels = static_cast<std::size_t>(input.info().width * input.info().height);
        for (std::size_t c = 0; c < channels.size(); ++c) {
            for (std::size_t i = 0; i < pixels; ++i) {
                const std::byte* const number = raw.planes[c].first + i * raw.planes[c].stride * sizeof(float);
                all[input.info().channels[c]].append(reinterpret_cast<const char*>(number), sizeof(float));
            }
        }
        return all;
    }
};
INSTANTIATE_TEST_SUITE_P(Places, RenderTiledTest, testing::ValuesIn(places()), placeName);

// The grid filter reads hits above and below, and gaussian pixels read samples there.
TEST_P(RenderTiledTest, ThePixelsAreThoseOfOnePiece) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> looks{
        {".tif", {"--filter", "elliptical-visible", "--filter-set", "form=grid"}},
        {".exr", {"--supersample", "2", "--pixel-model", "gaussian", "--mapping", "incremental"}}};
    for (const auto& [ending, look] : looks) {
        auto tiled = look;
        tiled.push_back("--tiled");
        runFine(render("whole" + ending, look));
        runFine(render("tiled" + ending, tiled));
        EXPECT_TRUE(picture("tiled" + ending) == picture("whole" + ending)) << ending;
        EXPECT_TRUE(merged(3, ending, tiled) == read("tiled" + ending)) << ending;
    }
    const std::vector<std::string> layers{"--layers", "color,depth,uv,normal,steps,outcome,error,footprint,hidden",
                                          "--filter", "elliptical-visible"};
    auto tiled = layers;
    tiled.push_back("--tiled");
    runFine(render("whole.exr", layers));
    runFine(render("tiled.exr", tiled));
    EXPECT_TRUE(merged(2, ".exr", tiled) == read("tiled.exr"));
    EXPECT_TRUE(planes("tiled.exr") == planes("whole.exr"));
}

TEST_P(RenderTiledTest, AnInterruptedRunGoesOn) {
    const std::vector<std::string> look{"--tiled", "--supersample", "6", "--threads", "1"};
    runFine(render("whole.tif", look));
    // What is kept stands next to the target of a link, which may be on another file system.
    std::filesystem::create_directory(path("far"));
    std::filesystem::create_symlink("far/t.tif", path("t.tif"));
    const std::string output = path("far/t.tif");
    // After the first block.
    const RunSetup setup = interruptedWhen(
        [&] { return std::filesystem::exists(output + ".part") && lines(read("far/t.tif.part")).size() > 1; });
    const Result stopped = run(render("t.tif", look), setup);
    expectKept(stopped, output + ".part", 5);
    EXPECT_TRUE(std::filesystem::exists(output + ".rows"));
    EXPECT_EQ(files(), (std::vector<std::string>{"far", "t.tif", "whole.tif"}));
    expectRefusal(render("t.tif", look), 2, {"t.tif.part", "--resume", "--anew"});
    expectRefusal(render("t.tif", {"--tiled", "--resume"}), 2, {"t.tif.part", "another command"});
    auto more = look;
    more.push_back("--resume");
    const Result resumed = run(render("t.tif", more));
    EXPECT_EQ(resumed.status, 0);
    EXPECT_NE(resumed.err.find(" of 5 parts are already done\n"), std::string::npos) << resumed.err;
    EXPECT_TRUE(std::filesystem::is_symlink(path("t.tif")));
    EXPECT_TRUE(read("far/t.tif") == read("whole.tif"));
    EXPECT_FALSE(std::filesystem::exists(output + ".part") || std::filesystem::exists(output + ".rows"));
}

// What is lost or damaged of FILE.rows is made again.
TEST_P(RenderTiledTest, DamagedRowsAreMadeAgain) {
    const std::vector<std::string> look{"--tiled", "--supersample", "6", "--threads", "1"};
    runFine(render("whole.tif", look));
    const RunSetup setup = interruptedWhen(
        [&] { return std::filesystem::exists(path("t.tif.part")) && lines(read("t.tif.part")).size() > 2; });
    auto more = look;
    more.push_back("--resume");
    for (const bool lost : {false, true}) {
        EXPECT_EQ(run(render("t.tif", look), setup).status, 130);
        std::string rows = read("t.tif.rows");
        rows[5000] = static_cast<char>(rows[5000] + 1);
        lost ? static_cast<void>(std::filesystem::remove(path("t.tif.rows")))
             : static_cast<void>(write("t.tif.rows", rows));
        EXPECT_EQ(run(render("t.tif", more)).status, 0);
        EXPECT_TRUE(read("t.tif") == read("whole.tif")) << lost;
        EXPECT_EQ(files(), (std::vector<std::string>{"t.tif", "whole.tif"}));
        std::filesystem::remove(path("t.tif"));
    }
}

TEST_P(RenderTiledTest, Refusals) {
    expectRefusal(render("t.png", {"--tiled"}), 2, {"t.png", ".tif", ".exr"});
    expectRefusal(render("t.tif", {"--tiled", "--report", "-"}), 2, {"--report", "--tiled"});
    expectRefusal(render("frames", {"--tiled", "--frames", "2", "--to", "elevation=60"}), 2, {"--tiled", "--frames"});
    expectRefusal(render("t.tif", {"--tiled", "--part", "1/6"}), 2, {"--part", "6 parts", "5 rows of tiles"});
    expectRefusal(render("t.tif", {"--resume"}), 2, {"--resume", "--tiled"});
    expectRefusal(render("no/t.tif", {"--tiled"}), 1, {"no/t.tif", "there is no folder"});
    RunSetup small;
    small.largestFile = 1000;
    expectRefusal(render("t.tif", {"--tiled"}), 1, {"t.tif", "the picture takes "}, small);
    size_ = "65537x8";
    expectRefusal(render("t.tif", {}), 2, {"--size", "65536"});
    size_ = "65536x8";
    expectRefusal(render("t.jpg", {}), 2, {"t.jpg", ".png, .tif, .exr"});
    EXPECT_TRUE(files().empty());
    // A part is whole or it is refused.
    size_ = "30x150";
    runFine(render("1.tif", {"--tiled", "--part", "1/2"}));
    runFine(render("2.tif", {"--tiled", "--part", "2/2"}));
    const std::string bytes = read("1.tif"), tiled = "\"tiled\":true";
    std::string other = bytes;
    write("1.tif", other.replace(other.find(tiled), tiled.size(), "\"tiled\":1   "));
    expectRefusal({"merge", path("1.tif"), path("2.tif"), "-o", path("m.tif")}, 2, {"1.tif: is damaged or cut short"});
    write("1.tif", bytes.substr(0, bytes.size() - 100));
    expectRefusal({"merge", path("1.tif"), path("2.tif"), "-o", path("m.tif")}, 2, {"1.tif: is damaged or cut short"});
    expectRefusal({"merge", path("1.tif"), path("2.tif"), "-o", path("m.exr")}, 2, {"m.exr", ".tif"});
    EXPECT_EQ(files(), (std::vector<std::string>{"1.tif", "2.tif"}));
}

// In less memory than PNG needs, whose refusal names what needs little.
TEST_P(RenderTiledTest, MemoryIsBounded) {
    RunSetup small;
    small.addressSpace = std::int64_t{1200} << 20U;
    std::vector<std::string> look{"--tracer", "flat", "--filter", "nearest", "--threads", "2"};
    size_ = "65536x1200";
    expectRefusal(render("t.png", look), 2, {"--size 65536x1200: ", "GB of memory are needed", ".tif", "--tiled"},
                  small);
    if (std::getenv("RELIEF_LONG") == nullptr) size_ = "65536x66";
    look.push_back("--tiled");
    runFine(render("t.tif", look), small);
    EXPECT_GT(std::filesystem::file_size(path("t.tif")), 65536U * 66 * 3);
}

// Above 2^26 pixels without --tiled; parts and one piece.
TEST_P(RenderTiledTest, LargePicturesAreTiledByThemselves) {
    if (std::getenv("RELIEF_LONG") == nullptr) GTEST_SKIP() << "with RELIEF_LONG";
    const std::vector<std::string> look{"--filter", "elliptical"};
    size_ = "8200x8300";
    auto whole = look;
    whole.insert(whole.end(), {"--report", path("whole.json")});
    runFine(render("whole.tif", whole));
    const std::string bytes = merged(2, ".tif", look);
    EXPECT_TRUE(picture("merged.tif") == picture("whole.tif"));
    runFine(render("tiled.tif", look));
    EXPECT_TRUE(read("tiled.tif") == bytes);
    // Formats without tiles keep their own form.
    runFine(render("x.jpg", {"--tracer", "flat", "--filter", "nearest"}));
    EXPECT_EQ(read("x.jpg").substr(0, 2), "\xFF\xD8");
    EXPECT_EQ(picture("x.jpg").width(), 8200);
}

// A disk that is too small is refused before anything is rendered, and left as it was.
TEST_P(RenderTiledTest, AFullDisk) {
    const std::string disk = path("disk");
    std::filesystem::create_directory(disk);
    RunSetup mounting;
    mounting.launcher = {"unshare", "--map-root-user", "--mount"};
    mounting.program = "mount";
    if (run({"-t", "tmpfs", "none", disk}, mounting).status != 0) GTEST_SKIP() << "file systems cannot be mounted here";
    const std::string script = R"sh(
        mount -t tmpfs -o size=40k none "$2" || exit 9
        "$1" render --relief bricks:48x32 --size 70x275 --tiled -o "$2/t.tif"; status=$?
        [ "$(ls "$2")" = "" ] || exit 8
        mount -o remount,size=64m "$2" || exit 9
        "$1" render --relief bricks:48x32 --size 70x275 --tiled -o "$2/t.tif" --resume --quiet && exit $status)sh";
    RunSetup setup;
    setup.launcher = {"unshare", "--map-root-user", "--mount", "bash", "-c", script, "bash"};
    const Result result = run({disk}, setup);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "relief: " + disk + "/t.tif: no space left on the disk; the picture takes 0.000127 GB\n");
}

}  // namespace relief::test
