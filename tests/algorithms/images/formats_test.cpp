// Special features of picture formats: palettes, few bits, unusual chunks, alpha, channels of several types.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "file_bytes.h"
#include "images/picture_bytes.h"
#include "images/picture_input.h"
#include "picture_files.h"
#include "relief/files.h"
#include "temporary_folder.h"

namespace relief {
namespace {

using testing::bigEndian;
using testing::bytesOf;
using testing::faultOf;
using testing::littleEndian;
using testing::png;
using testing::pngChunk;
using testing::TemporaryFolder;
using testing::tiffEntry;
using testing::writeRaw;

HeightImage heights(const std::string& path, const HeightReadOptions& options = {}) {
    Work work(2);
    return readHeight(path, options, work);
}

std::vector<float> values(const HeightImage& image) {
    return {image.heights.pixels().begin(), image.heights.pixels().end()};
}

ColorImage colors(const std::string& path) {
    Work work(2);
    return readColor(path, work);
}

// Two-bit indices 3 2 1 0, only three of which have a colour: the missing one is black.
TEST(Formats, PalettePng) {
    const TemporaryFolder folder;
    const std::string rows("\0\xe4", 2);
    const std::string palette = pngChunk("PLTE", "\x0a\x14\x1e\x64\x6e\x78\xc8\xd2\xdc");
    const std::string path = folder.with("p.png", png(4, 1, 2, 3, rows, palette));
    const HeightImage image = heights(path);
    EXPECT_EQ(values(image), (std::vector<float>{0, static_cast<float>(200 / 255.0), static_cast<float>(100 / 255.0),
                                                 static_cast<float>(10 / 255.0)}));
    EXPECT_EQ(image.channel, "R");
    EXPECT_EQ(colors(path)(1, 0).b, linearFromSrgb(static_cast<float>(220 / 255.0)));
    // A transparency chunk adds an alpha channel, by which the colours are not multiplied.
    const std::string clear = palette + pngChunk("tRNS", "\xff\x80");
    EXPECT_EQ(heights(folder.with("t.png", png(4, 1, 2, 3, rows, clear))).heights(2, 0), image.heights(2, 0));
}

// Adobe's segment specifies the colour coding and is kept; other metadata are dropped before libjpeg reads them.
TEST(Formats, JpegKeepsAdobesSegmentAndDropsMetadata) {
    const auto segment = [](unsigned char marker, const std::string& data) {
        return std::string{'\xff', static_cast<char>(marker)} +
               bigEndian(static_cast<std::uint32_t>(data.size()) + 2).substr(2) + data;
    };
    const std::string start("\xff\xd8", 2), scan = segment(0xda, "s") + "pixels";
    const std::string jfif = segment(0xe0, "JFIF"), adobe = segment(0xee, "Adobe");
    const std::string all =
        start + jfif + segment(0xe1, "Exif") + adobe + segment(0xed, "Photoshop") + segment(0xfe, "comment") + scan;
    const auto clean = cleanJpeg({reinterpret_cast<const unsigned char*>(all.data()), all.size()});
    EXPECT_EQ(std::string(clean.begin(), clean.end()), start + jfif + adobe + scan);
}

// Metadata that end within the file are dropped; a segment that would extend beyond it stays, so that libjpeg rejects
// it.
TEST(Formats, JpegWithASegmentBeyondItsEndIsLeftAlone) {
    const auto cleaned = [](const std::string& file) {
        const auto clean = cleanJpeg({reinterpret_cast<const unsigned char*>(file.data()), file.size()});
        return std::string(clean.begin(), clean.end());
    };
    const std::string start("\xff\xd8", 2), exif("\xff\xe1\0\6Exif", 8);
    EXPECT_EQ(cleaned(start + exif), start);
    for (std::size_t length = 0; length < exif.size(); ++length) {
        const std::string cut = start + exif.substr(0, length);
        EXPECT_EQ(cleaned(cut), cut) << length;
    }
}

TEST(Formats, FewBitsSpanTheFullRange) {
    const TemporaryFolder folder;
    const HeightImage image = heights(folder.with("g.png", png(4, 1, 2, 0, std::string("\0\x1b", 2))));
    EXPECT_EQ(values(image),
              (std::vector<float>{0, static_cast<float>(85 / 255.0), static_cast<float>(170 / 255.0), 1}));
}

// None of these chunks affects the pixels, and no warning is printed.
TEST(Formats, PngWithOddAncillaryChunks) {
    const TemporaryFolder folder;
    std::string wrongSum = pngChunk("tEXt", "a comment");
    wrongSum.back() = static_cast<char>(wrongSum.back() + 1);
    const std::string odd = pngChunk("iCCP", "broken") + pngChunk("gAMA", bigEndian(0)) + pngChunk("tRNS", "abc") +
                            pngChunk("zzZz", "?") + pngChunk("sRGB", "\x7f") + wrongSum;
    const std::string path = folder.with("odd.png", png(1, 1, 8, 0, std::string("\0\x80", 2), odd));
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(heights(path).heights(0, 0), static_cast<float>(128 / 255.0));
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

// An 8-bit BMP of two colours, rows bottom-up.
TEST(Formats, PaletteBmp) {
    const TemporaryFolder folder;
    const std::string pixels = std::string("\1\0\0\0", 4) + std::string("\0\1\0\0", 4);
    const std::string bytes = "BM" + littleEndian(14 + 40 + 8 + 8, 4) + littleEndian(0, 4) +
                              littleEndian(14 + 40 + 8, 4) + littleEndian(40, 4) + littleEndian(2, 4) +
                              littleEndian(2, 4) + littleEndian(1, 2) + littleEndian(8, 2) + littleEndian(0, 4) +
                              littleEndian(8, 4) + littleEndian(0, 8) + littleEndian(2, 4) + littleEndian(2, 4) +
                              std::string("\x0a\x14\x1e\0\x64\x6e\x78\0", 8) + pixels;
    const HeightImage image = heights(folder.with("p.bmp", bytes));
    const float low = static_cast<float>(30 / 255.0);
    const float high = static_cast<float>(120 / 255.0);
    EXPECT_EQ(values(image), (std::vector<float>{low, high, high, low}));
}

TEST(Formats, PaletteTiff) {
    const TemporaryFolder folder;
    std::string bytes = "II" + littleEndian(42, 2) + littleEndian(8, 4) + littleEndian(9, 2);
    const std::uint32_t map = 8 + 2 + 9 * 12 + 4;
    const std::uint32_t strip = map + 3 * 256 * 2;
    bytes += tiffEntry(256, 3, 1, 2) + tiffEntry(257, 3, 1, 1) + tiffEntry(258, 3, 1, 8) + tiffEntry(259, 3, 1, 1) +
             tiffEntry(262, 3, 1, 3) + tiffEntry(273, 4, 1, strip) + tiffEntry(278, 3, 1, 1) + tiffEntry(279, 4, 1, 2) +
             tiffEntry(320, 3, 768, map) + littleEndian(0, 4);
    for (std::uint32_t channel = 0; channel < 3; ++channel)
        for (std::uint32_t i = 0; i < 256; ++i) bytes += littleEndian((channel * 50 + i % 100) * 257, 2);
    bytes += "\x0a\x14";
    const HeightImage image = heights(folder.with("p.tif", bytes));
    EXPECT_EQ(values(image), (std::vector<float>{static_cast<float>(10 / 255.0), static_cast<float>(20 / 255.0)}));
    EXPECT_EQ(image.info.channels.size(), 3U);
    // The same file without its last bytes.
    const std::string cut = folder.with("cut.tif", bytes.substr(0, bytes.size() - 2));
    EXPECT_TRUE(faultOf([&] { heights(cut); }).starts_with(cut + ": is damaged or cut short"));
}

TEST(Formats, PaletteGif) {
    const TemporaryFolder folder;
    const std::string path = writeRaw<std::uint8_t>(folder / "p.gif", 2, 1, 3, {10, 20, 30, 200, 210, 220});
    const HeightImage image = heights(path);
    EXPECT_NEAR(image.heights(0, 0), 10 / 255.0, 0.02);
    EXPECT_NEAR(image.heights(1, 0), 200 / 255.0, 0.02);
}

// A colour profile whose only tag has such a large offset that the end of the tag overflows to a small number:
// OpenImageIO 2.4 would read there.
std::string brokenProfile() {
    std::string profile(128, '\0');
    profile.replace(0, 4, bigEndian(144));
    profile.replace(36, 4, "acsp");
    return profile + bigEndian(1) + "cprt" + bigEndian(0xffffff00U) + bigEndian(0x110);
}

TEST(Formats, BrokenColourProfilesAreNotFollowed) {
    const TemporaryFolder folder;
    const std::string profile = brokenProfile();
    const auto size = static_cast<std::uint32_t>(profile.size());
    const std::uint32_t data = 8 + 2 + 9 * 12 + 4;
    std::string tiff = "II" + littleEndian(42, 2) + littleEndian(8, 4) + littleEndian(9, 2);
    tiff += tiffEntry(256, 3, 1, 2) + tiffEntry(257, 3, 1, 1) + tiffEntry(258, 3, 1, 8) + tiffEntry(259, 3, 1, 1) +
            tiffEntry(262, 3, 1, 1) + tiffEntry(273, 4, 1, data) + tiffEntry(278, 3, 1, 1) + tiffEntry(279, 4, 1, 2) +
            tiffEntry(34675, 7, size, data + 2) + littleEndian(0, 4) + "\x33\x66" + profile;
    EXPECT_EQ(values(heights(folder.with("p.tif", tiff))), (std::vector<float>{0.2F, 0.4F}));
    // Also where the file is read from the disk by rows.
    PictureInput rows(folder / "p.tif", kDefaultMaxPixels, PictureAccess::Rows);
    std::array<std::byte, 2> codes{};
    rows.readRows(0, 0, 1, codes.data());
    EXPECT_EQ(codes, (std::array<std::byte, 2>{std::byte{0x33}, std::byte{0x66}}));

    const std::string plain =
        bytesOf(writeRaw<std::uint8_t>(folder / "plain.jpg", 8, 8, 1, std::vector<std::uint8_t>(64, 77)));
    const std::string segment = std::string("ICC_PROFILE\0\1\1", 14) + profile;
    const std::string length = bigEndian(static_cast<std::uint32_t>(segment.size() + 2)).substr(2);
    const std::string jpeg = folder.with("p.jpg", plain.substr(0, 2) + "\xff\xe2" + length + segment + plain.substr(2));
    EXPECT_EQ(heights(jpeg).heights, heights(folder / "plain.jpg").heights);
}

TEST(Formats, ChannelsByTheirNamesInExr) {
    const TemporaryFolder folder;
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::FLOAT);
    // Luminance with its colour differences is read as a grey picture.
    spec.channelnames = {"BY", "RY", "Y"};
    EXPECT_EQ(colors(writeRaw<float>(folder / "yc.exr", spec, {0.1F, 0.2F, 0.75F}))(0, 0), Color(0.75F, 0.75F, 0.75F));
    spec.channelnames = {"Z", "X", "Y"};
    Work work(1);
    const std::string normals = writeRaw<float>(folder / "n.exr", spec, {1, 0.5F, 0.5F});
    EXPECT_EQ(readNormals(normals, work)(0, 0), glm::vec3(0, 0, 1));
}

TEST(Formats, GreyJpegInThreeChannelsGivesTheFirst) {
    const TemporaryFolder folder;
    const HeightImage image =
        heights(writeRaw<std::uint8_t>(folder / "g.jpg", 8, 8, 3, std::vector<std::uint8_t>(192, 100)));
    EXPECT_EQ(image.channel, "R");
    EXPECT_NEAR(image.heights(3, 3), 100 / 255.0, 0.01);
}

TEST(Formats, ChannelsOfDifferentTypes) {
    const TemporaryFolder folder;
    OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::FLOAT);
    spec.channelformats = {OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::HALF};
    const std::string path = writeRaw<float>(folder / "mixed.exr", spec, {0.5F, 0.1F, 0.25F, 1, 2, 3});
    const ColorImage image = colors(path);
    EXPECT_EQ(image(0, 0), Color(0.5F, 0.1F, 0.25F));
    EXPECT_EQ(image(1, 0), Color(1, 2, 3));
    HeightReadOptions options;
    options.channel = "B";
    EXPECT_EQ(heights(path, options).fileHigh, 3);
}

// OpenImageIO would multiply by alpha: 200 * 10 / 255 = 8.
TEST(Formats, AlphaMultipliesNothing) {
    const TemporaryFolder folder;
    OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    for (const char* name : {"a.png", "a.tif"}) {
        const std::string path = writeRaw<std::uint8_t>(folder / name, spec, {200, 100, 50, 10});
        HeightReadOptions options;
        EXPECT_EQ(heights(path, options).heights(0, 0), static_cast<float>(200 / 255.0)) << name;
        options.channel = "A";
        EXPECT_EQ(heights(path, options).heights(0, 0), static_cast<float>(10 / 255.0)) << name;
        EXPECT_EQ(colors(path)(0, 0).g, linearFromSrgb(static_cast<float>(100 / 255.0))) << name;
    }
}

}  // namespace
}  // namespace relief
