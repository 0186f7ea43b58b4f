// Written files read back equal; after a failed write the old file is unchanged and no temporary file remains.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <limits>
#include <thread>

#include "../../small_disk.h"
#include "images/system_error.h"
#include "relief/files.h"
#include "relief/reliefs.h"
#include "temporary_folder.h"

namespace relief {
namespace {

using test::SmallDisk;
using testing::bytesOf;
using testing::faultOf;
using testing::TemporaryFolder;

FloatImage back(const std::string& path) {
    Work work(1);
    return readHeight(path, {}, work).heights;
}

TEST(Writing, HeightsReadBackTheSame) {
    const TemporaryFolder folder;
    const FloatImage relief = makeRelief("fractal", 61, 33, 4);
    for (const char* name : {"h.png", "h.tif", "h.TIFF", "h.exr"}) {
        writeHeight(folder / name, relief);
        EXPECT_EQ(back(folder / name), relief) << name;
    }
    FloatImage odd(3, 1);
    odd(0, 0) = 1e-40F;
    odd(1, 0) = 0.123456789F;
    for (const char* name : {"f.tif", "f.exr"}) {
        writeHeight(folder / name, odd, true);
        EXPECT_EQ(back(folder / name), odd) << name;
        EXPECT_EQ(readImageInfo(folder / name).type, "float");
    }
    EXPECT_EQ(readImageInfo(folder / "h.png").type, "uint16");
    EXPECT_EQ(folder.files(), 6);
}

TEST(Writing, SixteenBitsClampAndRound) {
    const TemporaryFolder folder;
    FloatImage odd(5, 1);
    odd(0, 0) = -3;
    odd(1, 0) = 7;
    odd(2, 0) = std::numeric_limits<float>::quiet_NaN();
    odd(3, 0) = 0.5F;
    odd(4, 0) = std::numeric_limits<float>::infinity();
    writeHeight(folder / "o.png", odd);
    const FloatImage read = back(folder / "o.png");
    EXPECT_EQ(read(0, 0), 0);
    EXPECT_EQ(read(1, 0), 1);
    EXPECT_EQ(read(2, 0), 0);
    EXPECT_EQ(read(3, 0), static_cast<float>(32768 / 65535.0));
    EXPECT_EQ(read(4, 0), 1);
}

TEST(Writing, ColoursByTheFormat) {
    const TemporaryFolder folder;
    Work work(1);
    ColorImage image(2, 1, Color(0.25F, 2, -1));
    image(1, 0) = Color(std::numeric_limits<float>::quiet_NaN(), 0.5F, 1);
    for (const char* name : {"c.png", "c.bmp", "c.tga", "c.ppm", "c.tif"}) {
        writeColor(folder / name, image);
        EXPECT_EQ(readImageInfo(folder / name).type, "uint8") << name;
        const ColorImage read = readColor(folder / name, work);
        EXPECT_NEAR(read(0, 0).r, 0.25F, 0.002) << name;
        EXPECT_EQ(read(0, 0).g, 1) << name;
        EXPECT_EQ(read(0, 0).b, 0) << name;
        EXPECT_EQ(read(1, 0).r, 0) << name;
    }
    image(1, 0).r = 3;
    writeColor(folder / "c.exr", image);
    EXPECT_EQ(readColor(folder / "c.exr", work), image);
    writeColor(folder / "c.hdr", image);
    EXPECT_NEAR(readColor(folder / "c.hdr", work)(1, 0).r, 3, 0.02);
    writeColor(folder / "c.jpg", ColorImage(16, 16, Color(0.5F)));
    EXPECT_NEAR(readColor(folder / "c.jpg", work)(5, 5).g, 0.5F, 0.01);
}

TEST(Writing, PlanesKeepNamesAndNumbers) {
    const TemporaryFolder folder;
    Work work(1);
    FloatImage depth(3, 2, -5), error(3, 2, 1e10F);
    depth(2, 1) = 100;
    const std::string path = folder / "planes.exr";
    writePlanes(path, {{"depth.Z", depth}, {"error.V", error}});
    const ImageInfo info = readImageInfo(path);
    EXPECT_EQ(info.channels, (std::vector<std::string>{"depth.Z", "error.V"}));
    EXPECT_EQ(info.type, "float");
    HeightReadOptions options;
    options.channel = "depth.Z";
    EXPECT_EQ(readHeight(path, options, work).fileHigh, 100);
    EXPECT_EQ(faultOf([&] {
                  writePlanes(folder / "p.png", {{"Z", depth}});
              }),
              folder / "p.png" + std::string(": \"png\" cannot hold these numbers; use exr"));
}

TEST(Writing, RefusesFormatsThatItDoesNotWrite) {
    const TemporaryFolder folder;
    const ColorImage image(2, 2);
    const std::string known = "; supported: png, exr, tif, tiff, jpg, jpeg, hdr, bmp, tga, ppm";
    EXPECT_EQ(faultOf([&] { writeColor(folder / "a.xyz", image); }),
              folder / "a.xyz" + std::string(": cannot write pictures as \"xyz\"") + known);
    EXPECT_EQ(faultOf([&] { writeColor(folder / "a", image); }),
              folder / "a" + std::string(": cannot write pictures as \"\"") + known);
    EXPECT_EQ(faultOf([&] { writeHeight(folder / "a.jpg", FloatImage(1, 1)); }),
              folder / "a.jpg" + std::string(": \"jpg\" cannot hold these numbers; use png, exr, tif, tiff"));
    EXPECT_EQ(faultOf([&] { writeHeight(folder / "a.png", FloatImage(1, 1), true); }),
              folder / "a.png" + std::string(": \"png\" cannot hold these numbers; use exr, tif, tiff"));
    EXPECT_EQ(faultOf([&] { writeColor(folder / "a.png", ColorImage()); }),
              folder / "a.png" + std::string(": the picture has no pixels (0 x 0)"));
    EXPECT_EQ(folder.files(), 0);
}

// A picture that its format cannot hold is an error and leaves no file. JPEG holds 65,500 pixels per side, TGA 65,535.
TEST(Writing, RefusesPicturesThatAFormatCannotHold) {
    const TemporaryFolder folder;
    const ColorImage wide(70'000, 1);
    for (const char* name : {"a.jpg", "a.tga"}) {
        EXPECT_NE(faultOf([&] { writeColor(folder / name, wide); }), "") << name;
        EXPECT_EQ(folder.files(), 0) << name;
    }
}

TEST(Writing, NowhereToWrite) {
    const TemporaryFolder folder;
    const ColorImage image(2, 2);
    EXPECT_EQ(faultOf([&] { writeColor(folder / "no/a.png", image); }),
              folder / "no/a.png" + (": there is no folder \"" + folder / "no" + "\""));
    EXPECT_EQ(faultOf([&] { writeTextFile(folder / "no/a.csv", "x"); }),
              folder / "no/a.csv" + (": there is no folder \"" + folder / "no" + "\""));
    std::filesystem::create_directory(folder / "d.png");
    EXPECT_EQ(faultOf([&] { writeColor(folder / "d.png", image); }),
              folder / "d.png" + std::string(": is a directory, not a file"));
    EXPECT_EQ(faultOf([&] { writeTextFile(folder / "d.png", "x"); }),
              folder / "d.png" + std::string(": is a directory, not a file"));
    EXPECT_THROW(writeTextFile("", "x"), WorkError);
    const std::string pipe = folder / "p.png";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(faultOf([&] { writeColor(pipe, image); }), pipe + ": is not an ordinary file");
}

TEST(Writing, NoPermission) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
    const TemporaryFolder folder;
    const std::string path = folder.with("kept.txt", "old");
    ::chmod(path.c_str(), 0444);
    EXPECT_EQ(faultOf([&] { writeTextFile(path, "new"); }), path + ": no permission to write it");
    EXPECT_EQ(bytesOf(path), "old");
}

// In every format the old file stays complete, nothing is left behind, and nothing is printed.
TEST(Writing, FullDiskKeepsTheOldFile) {
    const TemporaryFolder folder;
    const ColorImage image(200, 200, Color(0.3F, 0.1F, 0.9F));
    FloatImage rough(300, 300);
    for (std::size_t i = 0; i < rough.size(); ++i) rough.pixels()[i] = static_cast<float>(i * 7919 % 65536) / 65535;
    int files = 0;
    for (const char* extension : {"png", "exr", "tif", "jpg", "hdr", "bmp", "tga", "ppm"}) {
        const std::string path = folder.with(std::string("old.") + extension, "the old content");
        ++files;
        ::testing::internal::CaptureStderr();
        {
            const SmallDisk disk(200);
            EXPECT_EQ(faultOf([&] { writeColor(path, image); }), path + ": cannot be written: File too large");
            EXPECT_THROW(writeColor(path, image), WorkError);
        }
        EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << extension;
        EXPECT_EQ(bytesOf(path), "the old content");
        EXPECT_EQ(folder.files(), files);
    }
    const std::string text = folder.with("old.txt", "the old content");
    const SmallDisk disk(10000);
    EXPECT_THROW(writeHeight(folder / "old.exr", rough), WorkError);
    EXPECT_THROW(writePlanes(folder / "old.exr", {{"Z", rough}}), WorkError);
    EXPECT_EQ(faultOf([&] { writeTextFile(text, std::string(20000, 'x')); }),
              text + ": cannot be written: File too large");
    EXPECT_EQ(bytesOf(text), "the old content");
    EXPECT_EQ(folder.files(), files + 1);
}

TEST(Writing, DevicesAndPipesAreWrittenInPlace) {
    if (std::filesystem::exists("/dev/full")) {
        EXPECT_EQ(faultOf([] { writeTextFile("/dev/full", "x"); }), "/dev/full: no space left on the disk");
        EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
    }
    const TemporaryFolder folder;
    const std::string pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::string got;
    std::thread reader([&] { got = readTextFile(pipe); });
    writeTextFile(pipe, "through the pipe");
    reader.join();
    EXPECT_EQ(got, "through the pipe");
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(Writing, KeepsPermissionsAndWritesThroughLinks) {
    const TemporaryFolder folder;
    const std::string path = folder.with("real.txt", "old");
    ::chmod(path.c_str(), 0640);
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    writeTextFile(folder / "link.txt", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(bytesOf(path), "new");
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640U);
    std::filesystem::create_symlink(folder / "later.txt", folder / "dangling.txt");
    writeTextFile(folder / "dangling.txt", "there now");
    EXPECT_EQ(bytesOf(folder / "later.txt"), "there now");
    // A link to a link: each names its target relative to its own folder.
    std::filesystem::create_directory(folder / "runs");
    std::filesystem::create_symlink("7.txt", folder / "runs/current.txt");
    std::filesystem::create_symlink("runs/current.txt", folder / "latest.txt");
    writeTextFile(folder / "latest.txt", "seventh");
    EXPECT_EQ(bytesOf(folder / "runs/7.txt"), "seventh");
    EXPECT_FALSE(std::filesystem::exists(folder / "7.txt"));
    std::filesystem::remove_all(folder / "runs");
    std::filesystem::remove(folder / "latest.txt");
    std::filesystem::create_symlink("loop.txt", folder / "loop.txt");
    EXPECT_THROW(writeTextFile(folder / "loop.txt", "x"), WorkError);
    EXPECT_EQ(folder.files(), 5);
}

TEST(Writing, AtomicFileWithoutCommitLeavesNothing) {
    const TemporaryFolder folder;
    const std::string path = folder.with("a.png", "old");
    {
        const AtomicFile file(path);
        EXPECT_TRUE(file.temporaryPath().ends_with(".png"));
        EXPECT_EQ(std::filesystem::path(file.temporaryPath()).parent_path(), std::filesystem::path(path).parent_path());
        EXPECT_EQ(folder.files(), 2);
    }
    EXPECT_EQ(bytesOf(path), "old");
    EXPECT_EQ(folder.files(), 1);
    AtomicFile gone(path);
    std::filesystem::remove(gone.temporaryPath());
    EXPECT_THROW(gone.commit(), WorkError);
    EXPECT_EQ(bytesOf(path), "old");
}

TEST(Writing, LongAndCyrillicNames) {
    const TemporaryFolder folder;
    // A name of 250 bytes: a temporary name made by appending to it would be too long.
    const std::string path = folder / (std::string(246, 'n') + ".csv");
    writeTextFile(path, "x");
    EXPECT_EQ(readTextFile(path), "x");
    writeTextFile(folder / "звіт за рік.csv", "а,б\n");
    EXPECT_EQ(readTextFile(folder / "звіт за рік.csv"), "а,б\n");
}

TEST(Writing, AFullDiskAndAFullQuotaAreNoSpace) {
    for (const int error : {ENOSPC, EDQUOT}) {
        EXPECT_EQ(systemMessage(error, FileAccess::Write).id, MessageId::DiskFull) << error;
    }
    EXPECT_EQ(systemMessage(EROFS, FileAccess::Write).id, MessageId::FileSystemReadOnly);
}

TEST(Writing, TextFilesAsBytes) {
    const TemporaryFolder folder;
    std::string bytes("\0\r\n\xff", 4);
    bytes += std::string(300000, 'y');
    writeTextFile(folder / "t", bytes);
    EXPECT_EQ(readTextFile(folder / "t"), bytes);
    writeTextFile(folder / "t", "");
    EXPECT_EQ(readTextFile(folder / "t"), "");
    EXPECT_EQ(faultOf([&] { readTextFile(folder / "none"); }), folder / "none" + std::string(": no such file"));
    EXPECT_EQ(faultOf([&] { readTextFile(folder / ""); }), folder / "" + std::string(": is a directory, not a file"));
}

}  // namespace
}  // namespace relief
