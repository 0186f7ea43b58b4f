// Malformed pictures are refused, each with one line that names the file and the fault, and without output on stderr.
#include <OpenImageIO/deepdata.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <limits>
#include <random>

#include "file_bytes.h"
#include "picture_files.h"
#include "relief/files.h"
#include "temporary_folder.h"

namespace relief {
namespace {

using testing::bigEndian;
using testing::bytesOf;
using testing::faultOf;
using testing::kPngSignature;
using testing::littleEndian;
using testing::png;
using testing::pngChunk;
using testing::pngHeader;
using testing::TemporaryFolder;
using testing::tiffEntry;
using testing::writeRaw;

// Returns the error line without the file's name. Checks that both readers give the same line, and the reader of the
// header as well if it refuses the file. Fails if anything was printed.
std::string refusal(const std::string& path, std::int64_t maxPixels = kDefaultMaxPixels) {
    ::testing::internal::CaptureStderr();
    ::testing::internal::CaptureStdout();
    Work work(2);
    HeightReadOptions options;
    options.maxPixels = maxPixels;
    const std::string info = faultOf([&] { readImageInfo(path, maxPixels); });
    const std::string height = faultOf([&] { readHeight(path, options, work); });
    const std::string color = faultOf([&] { readColor(path, work, maxPixels); });
    EXPECT_EQ(::testing::internal::GetCapturedStderr() + ::testing::internal::GetCapturedStdout(), "") << path;
    EXPECT_EQ(height, color);
    EXPECT_TRUE(info.empty() || info == height) << info;
    if (!height.starts_with(path + ": ")) return "NOT NAMED: " + height;
    return height.substr(path.size() + 2);
}

void expectDamaged(const std::string& path, const std::string& what = {}) {
    EXPECT_TRUE(refusal(path).starts_with("is damaged or cut short")) << path << ' ' << what << ' ' << refusal(path);
}

// Writes a picture of noise, so that any missing part is noticed.
std::string noisy(const std::string& path, int width = 61, int height = 47, int channels = 3) {
    std::mt19937 generator(1);
    std::vector<std::uint8_t> numbers(static_cast<std::size_t>(width * height * channels));
    for (std::uint8_t& number : numbers) number = static_cast<std::uint8_t>(generator());
    return writeRaw(path, width, height, channels, numbers);
}

// A header of an OpenEXR file whose attribute of an unknown type has the stated length, and four bytes of it.
std::string exrWithAttribute(std::uint32_t length, std::uint32_t flags) {
    using namespace std::string_literals;
    return "\x76\x2f\x31\x01"s + littleEndian(2 | flags, 4) + "a\0int\0"s + littleEndian(4, 4) + littleEndian(1, 4) +
           "b\0unknown\0"s + littleEndian(length, 4) + "1234";
}

// OpenEXR takes memory of the stated length before it reads: up to four gigabytes for a file of 50 bytes. The
// message of the library would follow that of this line.
TEST(Malformed, ExrAttributeLongerThanItsFile) {
    const TemporaryFolder folder;
    const std::string path = folder / "long.exr";
    for (const std::uint32_t flags : {0U, 0x1000U}) {
        for (const std::uint32_t length : {5U, 1929379840U, 0xffffffffU}) {
            writeTextFile(path, exrWithAttribute(length, flags));
            EXPECT_EQ(refusal(path), "is damaged or cut short") << length;
        }
    }
}

TEST(Malformed, NotThereOrNotAFile) {
    const TemporaryFolder folder;
    EXPECT_EQ(refusal(folder / "none.png"), "no such file");
    EXPECT_EQ(refusal(folder / ""), "is a directory, not a file");
    EXPECT_EQ(refusal(folder.with("empty.png", "")), "the file is empty");
    EXPECT_EQ(refusal("/dev/null"), "is not an ordinary file");
    const std::string pipe = folder / "pipe.png";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(refusal(pipe), "is not an ordinary file");
    EXPECT_EQ(refusal(folder.with("file", "x") + "/below.png"), "cannot be read: Not a directory");
}

TEST(Malformed, NoPermission) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const TemporaryFolder folder;
    const std::string path = noisy(folder / "secret.png");
    ::chmod(path.c_str(), 0);
    EXPECT_EQ(refusal(path), "no permission to read it");
}

TEST(Malformed, NotAPicture) {
    const TemporaryFolder folder;
    std::string random;
    std::mt19937 generator(5);
    for (int i = 0; i < 5000; ++i) random += static_cast<char>(generator() & 0xffU);
    for (const char* name :
         {"a.png", "a.jpg", "a.exr", "a.tif", "a.txt", "a", "a.mp4", "a.vdb", "a.null", "a.cr2", "a.dds"}) {
        EXPECT_EQ(refusal(folder.with(name, "just some text\n")), "is not a readable picture") << name;
        EXPECT_EQ(refusal(folder.with(name, random)), "is not a readable picture") << name;
    }
    // Formats without a signature are recognised by the file's name: their libraries must examine the content.
    for (const char* name : {"a.tga", "a.rla", "a.heic"}) {
        expectDamaged(folder.with(name, "just some text\n"), name);
        expectDamaged(folder.with(name, random), name);
    }
}

TEST(Malformed, OnlyASignature) {
    const TemporaryFolder folder;
    using namespace std::string_literals;
    for (const std::string& head :
         {kPngSignature, "\xff\xd8\xff"s, "II*\0"s, "MM\0*"s, "\x76\x2f\x31\x01"s, "#?RADIANCE\n"s, "GIF89a"s, "BM"s,
          "RIFF\0\0\0\0WEBP"s, "\0\0\0\x0cjP  \r\n\x87\n"s, "\xff\x4f\xff\x51"s, "8BPS"s, "P5\n"s, "SIMPLE  ="s})
        expectDamaged(folder.with("head.png", head), head);
}

// Files of every kind, truncated at many places: the missing part is never filled with grey.
TEST(Malformed, CutShort) {
    const TemporaryFolder folder;
    for (const char* extension : {"png", "jpg", "tif", "exr", "hdr", "bmp", "tga", "ppm", "webp", "jp2", "gif"}) {
        const std::string whole = bytesOf(noisy(folder / (std::string("whole.") + extension)));
        ASSERT_GT(whole.size(), 1000U);
        const std::string path = folder / (std::string("cut.") + extension);
        for (const double part : {0.02, 0.1, 0.35, 0.6, 0.8, 0.9}) {
            const auto size = static_cast<std::size_t>(static_cast<double>(whole.size()) * part);
            folder.with(std::string("cut.") + extension, whole.substr(0, size));
            expectDamaged(path, std::to_string(part));
        }
    }
}

TEST(Malformed, JpegWithoutItsLastBytes) {
    const TemporaryFolder folder;
    const std::string whole = bytesOf(noisy(folder / "whole.jpg"));
    for (const std::size_t lost : {2U, 3U, 10U, 100U})
        expectDamaged(folder.with("cut.jpg", whole.substr(0, whole.size() - lost)), std::to_string(lost));
}

TEST(Malformed, PngWithAFlippedByte) {
    const TemporaryFolder folder;
    const std::string whole = bytesOf(noisy(folder / "whole.png"));
    for (std::size_t at = 0; at < whole.size(); at += 97) {
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
        const std::string path = folder.with("flipped.png", bytes);
        const std::string line = refusal(path);
        EXPECT_TRUE(line.starts_with("is damaged") || line.starts_with("is not a readable picture") || at == 16)
            << at << line;
    }
}

TEST(Malformed, PngChunksOutOfOrder) {
    const TemporaryFolder folder;
    const std::string data = pngChunk("IDAT", testing::stored(std::string("\0\x80", 2)));
    const std::string end = pngChunk("IEND", {});
    const std::string palette = pngChunk("PLTE", "abc");
    for (const std::string& bytes :
         {data + pngHeader(1, 1, 8, 0) + end, pngHeader(1, 1, 8, 0) + end, pngHeader(1, 1, 8, 0) + data,
          pngHeader(1, 1, 8, 0) + pngHeader(1, 1, 8, 0) + data + end, pngHeader(1, 1, 8, 3) + data + end,
          pngHeader(1, 1, 8, 3) + palette + palette + data + end, pngHeader(1, 1, 3, 0) + data + end,
          pngHeader(1, 1, 8, 5) + data + end, pngHeader(1, 1, 4, 2) + data + end,
          pngHeader(1, 1, 8, 3) + pngChunk("PLTE", "ab") + data + end,
          pngHeader(1, 1, 8, 0) + pngChunk("CRIT", "?") + data + end,
          pngHeader(1, 1, 8, 0) + bigEndian(0xffffffffU) + "IDAT" + data})
        expectDamaged(folder.with("order.png", kPngSignature + bytes));
}

TEST(Malformed, ZeroSize) {
    const TemporaryFolder folder;
    EXPECT_EQ(refusal(folder.with("zero.png", png(0, 5, 8, 0, "x"))), "the picture has no pixels (0 x 5)");
    EXPECT_EQ(refusal(folder.with("zero.gif", "GIF89a" + littleEndian(3, 2) + littleEndian(0, 2) + "rest")),
              "the picture has no pixels (3 x 0)");
    EXPECT_NE(refusal(folder.with("zero.pgm", "P5\n0 4\n255\n")), "");
}

// Headers that declare unrealistic sizes are refused before memory is allocated for them.
TEST(Malformed, PixelBombs) {
    const TemporaryFolder folder;
    const std::string limit = " pixels are more than the limit of 268435456 (--max-pixels)";
    EXPECT_EQ(refusal(folder.with("bomb.png", png(60000, 60000, 16, 6, "x"))), "60000 x 60000" + limit);
    EXPECT_EQ(refusal(folder.with("most.png", png(0x7fffffffU, 0x7fffffffU, 16, 6, "x"))),
              "2147483647 x 2147483647" + limit);
    EXPECT_EQ(refusal(folder.with("bomb.gif", "GIF89a" + littleEndian(65535, 2) + littleEndian(65535, 2))),
              "65535 x 65535" + limit);
    EXPECT_EQ(refusal(folder.with("bomb.ppm", "P6\n100000 100000\n255\nabc")), "100000 x 100000" + limit);
    EXPECT_EQ(refusal(folder.with("long.png", png(1000001, 1, 8, 0, "x"))),
              "1000001 x 1 pixels: PNG files are read up to 1000000 pixels per side");
    const std::string codestream = std::string("\xff\x4f\xff\x51\0\x2f\0\0", 8) + bigEndian(70000) + bigEndian(80000) +
                                   bigEndian(10) + bigEndian(0) + std::string(40, '\1');
    EXPECT_EQ(refusal(folder.with("bomb.j2k", codestream)), "69990 x 80000" + limit);
    const std::string most = std::string("\xff\x4f\xff\x51\0\x2f\0\0", 8) + bigEndian(0xffffffffU) +
                             bigEndian(0xffffffffU) + std::string(48, '\0');
    EXPECT_EQ(refusal(folder.with("most.j2k", most)), "4294967295 x 4294967295" + limit);
    const std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 300000 +X 300000\n";
    EXPECT_EQ(refusal(folder.with("bomb.hdr", hdr)), "300000 x 300000" + limit);
    // Within the limit, but not in so small a file.
    const std::string tiny = png(16000, 16000, 8, 0, "x");
    EXPECT_EQ(refusal(folder.with("tiny.png", tiny)), "is damaged: " + std::to_string(tiny.size()) +
                                                          " bytes cannot hold the 16000 x 16000 pixels that it states");
    // The exact size as the limit, one pixel less, and a limit of zero.
    const std::string small = noisy(folder / "small.png", 20, 30);
    Work work(1);
    EXPECT_NO_THROW(readColor(small, work, 600));
    EXPECT_EQ(refusal(small, 599), "20 x 30 pixels are more than the limit of 599 (--max-pixels)");
    EXPECT_EQ(refusal(small, 0), "20 x 30 pixels are more than the limit of 0 (--max-pixels)");
    EXPECT_NO_THROW(readColor(small, work, std::numeric_limits<std::int64_t>::max()));
}

TEST(Malformed, HeightsThatAreNoNumbers) {
    const TemporaryFolder folder;
    Work work(3);
    const float infinity = std::numeric_limits<float>::infinity();
    std::vector<float> numbers(300 * 200, 0.5F);
    numbers[7 + 100 * 300] = std::numeric_limits<float>::quiet_NaN();
    numbers[8 + 150 * 300] = infinity;
    for (const char* name : {"nan.exr", "nan.tif"}) {
        const std::string path = writeRaw(folder / name, 300, 200, 1, numbers);
        EXPECT_EQ(faultOf([&] { readHeight(path, {}, work); }), path + ": the height at (7, 100) is nan");
    }
    numbers[299] = -infinity;
    const std::string path = writeRaw(folder / "inf.exr", 300, 200, 1, numbers);
    EXPECT_EQ(faultOf([&] { readHeight(path, {}, work); }), path + ": the height at (299, 0) is -inf");
    HeightReadOptions options;
    options.range = parseHeightRange("0,1");
    EXPECT_EQ(faultOf([&] { readHeight(path, options, work); }), path + ": the height at (299, 0) is -inf");
}

TEST(Malformed, Volume) {
    const TemporaryFolder folder;
    std::string bytes = "II" + littleEndian(42, 2) + littleEndian(8, 4) + littleEndian(9, 2);
    bytes += tiffEntry(256, 3, 1, 4) + tiffEntry(257, 3, 1, 4) + tiffEntry(258, 3, 1, 8) + tiffEntry(259, 3, 1, 1) +
             tiffEntry(262, 3, 1, 1) + tiffEntry(273, 4, 1, 8 + 2 + 9 * 12 + 4) + tiffEntry(278, 3, 1, 4) +
             tiffEntry(279, 4, 1, 48) + tiffEntry(32997, 4, 1, 3) + littleEndian(0, 4) + std::string(48, 'x');
    EXPECT_EQ(refusal(folder.with("volume.tif", bytes)), "is a volume of 3 layers, not a picture");
}

// Several samples per pixel, as renderers write them for compositing.
TEST(Malformed, DeepPicture) {
    const TemporaryFolder folder;
    const std::string path = folder / "deep.exr";
    OIIO::ImageSpec spec(2, 1, 1, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"Z"};
    spec.deep = true;
    OIIO::DeepData data;
    data.init(2, 1, OIIO::TypeDesc(OIIO::TypeDesc::FLOAT), spec.channelnames);
    data.set_samples(0, 2);
    const auto output = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(output && output->open(path, spec) && output->write_deep_image(data) && output->close());
    EXPECT_EQ(refusal(path), "is a deep picture (several samples per pixel), which is not supported");
}

TEST(Malformed, ExrWithMissingRows) {
    const TemporaryFolder folder;
    const std::string path = folder / "part.exr";
    {
        OIIO::ImageSpec spec(64, 64, 1, OIIO::TypeDesc::FLOAT);
        const auto output = OIIO::ImageOutput::create(path);
        ASSERT_TRUE(output && output->open(path, spec));
        const std::vector<float> numbers(64 * 64, 0.5F);
        ASSERT_TRUE(output->write_scanlines(0, 32, 0, OIIO::TypeDesc::FLOAT, numbers.data()));
        output->close();
    }
    expectDamaged(path);
}

// For any bytes the result is a picture or one line of error; never a crash (checked by the sanitizers), never output
// on stderr.
TEST(Malformed, FlippedBytesOfOtherFormats) {
    const TemporaryFolder folder;
    Work work(1);
    std::mt19937 generator(3);
    for (const char* extension : {"jpg", "tif", "hdr", "bmp", "tga", "ppm", "gif"}) {
        const std::string whole = bytesOf(noisy(folder / (std::string("whole.") + extension)));
        for (int i = 0; i < 60; ++i) {
            std::string bytes = whole;
            for (int flips = 0; flips < 4; ++flips)
                bytes[generator() % (i % 2 == 0 ? 64 : bytes.size())] = static_cast<char>(generator() & 0xffU);
            const std::string path = folder.with(std::string("flipped.") + extension, bytes);
            ::testing::internal::CaptureStderr();
            const std::string line = faultOf([&] { readColor(path, work, 1 << 22); });
            EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << path;
            EXPECT_TRUE(line.empty() || line.starts_with(path + ": ")) << line;
        }
    }
}

}  // namespace
}  // namespace relief
