// The result of reading valid files: exact numbers, channels, ranges, colours.
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

#include "picture_files.h"
#include "relief/files.h"
#include "temporary_folder.h"

namespace relief {
namespace {

using testing::faultOf;
using testing::TemporaryFolder;
using testing::writeRaw;

constexpr const char* kDatasets = RELIEF_DATASETS;

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

TEST(Reading, SixteenBitPngIsExact) {
    const TemporaryFolder folder;
    std::vector<std::uint16_t> numbers(65536);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::uint16_t>(i);
    for (const char* name : {"all.png", "all.tif"}) {
        const HeightImage image = heights(writeRaw(folder / name, 256, 256, 1, numbers));
        for (std::size_t i = 0; i < numbers.size(); ++i)
            ASSERT_EQ(image.heights.pixels()[i], static_cast<float>(static_cast<double>(i) / 65535.0));
        EXPECT_EQ(image.info.type, "uint16");
        EXPECT_EQ(image.fileLow, 0);
        EXPECT_EQ(image.fileHigh, 65535);
        EXPECT_EQ(image.channel, "Y");
        EXPECT_TRUE(image.notes.empty());
    }
}

TEST(Reading, IntegersByTheirFullRange) {
    const TemporaryFolder folder;
    const HeightImage bytes = heights(writeRaw<std::uint8_t>(folder / "b.png", 2, 2, 1, {0, 1, 200, 255}));
    EXPECT_EQ(values(bytes),
              (std::vector<float>{0, static_cast<float>(1 / 255.0), static_cast<float>(200 / 255.0), 1}));
    const HeightImage wide = heights(writeRaw<std::uint32_t>(folder / "w.tif", 3, 1, 1, {0, 3000000000U, 4294967295U}));
    EXPECT_EQ(values(wide), (std::vector<float>{0, static_cast<float>(3000000000.0 / 4294967295.0), 1}));
    EXPECT_EQ(wide.info.type, "uint");
    EXPECT_EQ(wide.fileHigh, 4294967295.0);
}

TEST(Reading, SignedIntegersClampNegativesWithANote) {
    const TemporaryFolder folder;
    const HeightImage image = heights(writeRaw<std::int16_t>(folder / "s.tif", 4, 1, 1, {-7, 0, 16384, 32767}));
    EXPECT_EQ(values(image), (std::vector<float>{0, 0, static_cast<float>(16384 / 32767.0), 1}));
    ASSERT_EQ(image.notes.size(), 1U);
    EXPECT_EQ(sentence(image.notes[0]), "1 negative heights (lowest -7) were set to 0");
}

TEST(Reading, FloatsInsideStayAndOthersAreStretched) {
    const TemporaryFolder folder;
    for (const char* name : {"in.exr", "in.tif"}) {
        const HeightImage image = heights(writeRaw<float>(folder / name, 3, 1, 1, {0.1F, 1e-42F, 1}));
        EXPECT_EQ(values(image), (std::vector<float>{0.1F, 1e-42F, 1})) << name;
        EXPECT_TRUE(image.notes.empty());
    }
    for (const char* name : {"out.exr", "out.tif"}) {
        const HeightImage image = heights(writeRaw<float>(folder / name, 3, 1, 1, {-100, 300, 0.5F}));
        EXPECT_EQ(values(image), (std::vector<float>{0, 1, 0.25125F})) << name;
        ASSERT_EQ(image.notes.size(), 1U);
        EXPECT_EQ(sentence(image.notes[0]), "heights from -100 to 300 were stretched to [0, 1]");
        EXPECT_EQ(image.fileLow, -100);
    }
    const HeightImage flat = heights(writeRaw<float>(folder / "flat.exr", 2, 1, 1, {7.5F, 7.5F}));
    EXPECT_EQ(values(flat), (std::vector<float>{0, 0}));
    ASSERT_EQ(flat.notes.size(), 1U);
    EXPECT_EQ(sentence(flat.notes[0]), "all heights are 7.5; they were set to 0");
}

TEST(Reading, HalvesAndDoubles) {
    const TemporaryFolder folder;
    OIIO::ImageSpec half(2, 1, 1, OIIO::TypeDesc::HALF);
    const HeightImage image = heights(writeRaw<float>(folder / "h.exr", half, {0.25F, 0.333251953125F}));
    EXPECT_EQ(values(image), (std::vector<float>{0.25F, 0.333251953125F}));
    EXPECT_EQ(image.info.type, "half");
    const double most = std::numeric_limits<double>::max();
    const HeightImage wide = heights(writeRaw<double>(folder / "d.tif", 1, 3, 1, {-most, 0, most}));
    EXPECT_EQ(values(wide), (std::vector<float>{0, 0.5F, 1}));
    const double least = std::numeric_limits<double>::denorm_min();
    const HeightImage tiny = heights(writeRaw<double>(folder / "t.tif", 1, 2, 1, {-least, least}));
    EXPECT_EQ(values(tiny), (std::vector<float>{0, 1}));
    // OpenImageIO reads this as zeros without an error.
    const std::string row = writeRaw<double>(folder / "row.tif", 2, 1, 1, {0.25, 0.5});
    EXPECT_TRUE(faultOf([&] { heights(row); }).starts_with(row + ": 64-bit numbers in tiles or in a single row"));
}

TEST(Reading, RangeAndInvert) {
    const TemporaryFolder folder;
    const std::string path = writeRaw<float>(folder / "m.exr", 4, 1, 1, {0, 10, 15, 40});
    HeightReadOptions options;
    options.range = parseHeightRange("10,20");
    const HeightImage image = heights(path, options);
    EXPECT_EQ(values(image), (std::vector<float>{0, 0, 0.5F, 1}));
    ASSERT_EQ(image.notes.size(), 1U);
    EXPECT_EQ(sentence(image.notes[0]), "2 heights outside 10 to 20 were clamped");
    options.invert = true;
    EXPECT_EQ(values(heights(path, options)), (std::vector<float>{1, 1, 0.5F, 0}));
    options.range = parseHeightRange("full");
    EXPECT_EQ(faultOf([&] { heights(path, options); }),
              path + ": heights from 0 to 40 do not lie in [0, 1]; give --range auto or LO,HI");
    const std::string bytes = writeRaw<std::uint8_t>(folder / "b.png", 3, 1, 1, {50, 100, 150});
    options.invert = false;
    options.range = parseHeightRange("50,150");
    EXPECT_EQ(values(heights(bytes, options)), (std::vector<float>{0, 0.5F, 1}));
}

TEST(Reading, RangeAsText) {
    EXPECT_EQ(parseHeightRange("auto"), HeightRange{});
    for (const char* text : {"auto", "full", "0,1", "-2.5,1e+30", "0.1,0.2"})
        EXPECT_EQ(heightRangeText(parseHeightRange(text)), text);
    for (const char* text :
         {"", "1", "1,", ",1", "2,1", "1,1", "0;1", "0,1,2", "nan,1", "0,inf", "0,1 ", "Full", "a,b"})
        EXPECT_EQ(faultOf([&] { parseHeightRange(text); }),
                  "--range: \"" + std::string(text) + "\" is not a range: auto, full or LO,HI with LO < HI");
}

TEST(Reading, ChannelsByNumberAndName) {
    const TemporaryFolder folder;
    OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const std::string path = writeRaw<std::uint8_t>(folder / "c.png", spec, {10, 20, 30, 40});
    const auto channel = [&](const std::string& name) {
        HeightReadOptions options;
        options.channel = name;
        return std::lround(heights(path, options).heights(0, 0) * 255.0F);
    };
    EXPECT_EQ(channel(""), 10);
    EXPECT_EQ(channel("1"), 20);
    EXPECT_EQ(channel("b"), 30);
    EXPECT_EQ(channel("A"), 40);
    EXPECT_EQ(channel("Alpha"), 40);
    for (const char* name : {"4", "-1", "Y", "99999999999999999999", "aleph"})
        EXPECT_EQ(faultOf([&] { channel(name); }),
                  path + ": there is no channel \"" + name + "\"; channels: 0 R, 1 G, 2 B, 3 A");
}

TEST(Reading, NamedLayersOfExr) {
    const TemporaryFolder folder;
    const std::string path = folder / "layers.exr";
    writePlanes(path, {{"depth.Z", FloatImage(2, 1, 0.25F)}, {"color.R", FloatImage(2, 1, 0.75F)}});
    HeightReadOptions options;
    options.channel = "DEPTH.z";
    const HeightImage image = heights(path, options);
    EXPECT_EQ(values(image), (std::vector<float>{0.25F, 0.25F}));
    EXPECT_EQ(image.channel, "depth.Z");
}

TEST(Reading, GreyIsSpreadOverThreeChannels) {
    const TemporaryFolder folder;
    const ColorImage image = colors(writeRaw<std::uint8_t>(folder / "g.png", 2, 1, 1, {0, 128}));
    const float grey = linearFromSrgb(static_cast<float>(128 / 255.0));
    EXPECT_EQ(image(1, 0), Color(grey, grey, grey));
    OIIO::ImageSpec spec(1, 1, 2, OIIO::TypeDesc::UINT8);
    spec.channelnames = {"Y", "A"};
    spec.alpha_channel = 1;
    EXPECT_EQ(colors(writeRaw<std::uint8_t>(folder / "ga.png", spec, {255, 255}))(0, 0), Color(1, 1, 1));
}

TEST(Reading, LinearWhereTheFileSaysSoAndFloats) {
    const TemporaryFolder folder;
    OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "Linear");
    EXPECT_EQ(colors(writeRaw<std::uint8_t>(folder / "l.png", spec, {51, 102, 255}))(0, 0), Color(0.2F, 0.4F, 1));
    EXPECT_EQ(colors(writeRaw<float>(folder / "f.exr", 1, 1, 3, {0.2F, 4, -1}))(0, 0), Color(0.2F, 4, -1));
    const ColorImage sixteen = colors(writeRaw<std::uint16_t>(folder / "s.png", 1, 1, 3, {0, 32768, 65535}));
    EXPECT_EQ(sixteen(0, 0), Color(0, linearFromSrgb(static_cast<float>(32768 / 65535.0)), 1));
    const ColorImage wide = colors(writeRaw<std::uint32_t>(folder / "w.tif", 1, 1, 3, {0, 1U << 31, 4294967295U}));
    EXPECT_EQ(wide(0, 0), Color(0, linearFromSrgb(0.5F), 1));
}

TEST(Reading, EightBitColoursSurviveBothWays) {
    const TemporaryFolder folder;
    ColorImage image(256, 1);
    for (int i = 0; i < 256; ++i) {
        const float code = static_cast<float>(i) / 255.0F;
        image(i, 0) = Color(linearFromSrgb(code), linearFromSrgb(1 - code), 0);
        EXPECT_EQ(std::lround(srgbFromLinear(image(i, 0).r) * 255.0F), i);
    }
    writeColor(folder / "codes.png", image);
    HeightReadOptions options;
    const HeightImage codes = heights(folder / "codes.png", options);
    for (int i = 0; i < 256; ++i) EXPECT_EQ(std::lround(codes.heights(i, 0) * 255.0F), i);
    const ColorImage back = colors(folder / "codes.png");
    for (int i = 0; i < 256; ++i) EXPECT_NEAR(back(i, 0).r, image(i, 0).r, 1e-7) << i;
    EXPECT_NEAR(linearFromSrgb(0.5F), 0.21404114F, 1e-7);
    EXPECT_NEAR(srgbFromLinear(0.18F), 0.46135613F, 1e-7);
}

TEST(Reading, NormalsAreUnitAndNeverConverted) {
    const TemporaryFolder folder;
    Work work(1);
    const std::string path =
        writeRaw<std::uint8_t>(folder / "n.png", 3, 1, 3, {255, 128, 128, 128, 128, 255, 127, 128, 128});
    const Image<glm::vec3> normals = readNormals(path, work);
    EXPECT_NEAR(normals(0, 0).x, 1, 1e-4);
    EXPECT_NEAR(normals(1, 0).z, 1, 1e-4);
    EXPECT_EQ(normals(2, 0), glm::vec3(0, 0, 1));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(readNormals(writeRaw<float>(folder / "n.exr", 1, 1, 3, {nan, 0, 0}), work)(0, 0), glm::vec3(0, 0, 1));
    const std::string grey = writeRaw<std::uint8_t>(folder / "g.png", 1, 1, 1, {1});
    EXPECT_EQ(faultOf([&] { readNormals(grey, work); }),
              grey + ": a normal map needs three channels; this picture has 1");
}

TEST(Reading, InfoWithoutPixels) {
    const ImageInfo info = readImageInfo(std::string(kDatasets) + "/stone_wall_bricks102/color.jpg");
    EXPECT_EQ(info.format, "jpeg");
    EXPECT_EQ(info.width, 1024);
    EXPECT_EQ(info.height, 512);
    EXPECT_EQ(info.type, "uint8");
    EXPECT_EQ(info.channels, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(info.colorSpace, "sRGB");
}

TEST(Reading, DataSets) {
    const std::string base = kDatasets;
    const HeightImage metres = heights(base + "/terrain_srtm_east_africa/height_metres.exr");
    EXPECT_EQ(metres.heights.width(), 220);
    EXPECT_NEAR(metres.fileLow, 277, 1);
    EXPECT_NEAR(metres.fileHigh, 4503, 1);
    EXPECT_EQ(metres.notes.size(), 1U);
    HeightReadOptions options;
    options.range = parseHeightRange("277,4503");
    const HeightImage png = heights(base + "/terrain_srtm_east_africa/height_metres.png", options);
    float worst = 0;
    for (std::size_t i = 0; i < png.heights.size(); ++i)
        worst = std::max(worst, std::abs(png.heights.pixels()[i] - metres.heights.pixels()[i]));
    EXPECT_LT(worst, 2.0F / 4226.0F);
    EXPECT_EQ(heights(base + "/brick_tiles037/height.jpg").heights.size(), 2048U * 2048U);
    EXPECT_EQ(heights(base + "/gray_rocks/height.png").info.type, "uint16");
    EXPECT_EQ(colors(base + "/brick_tiles037/color.jpg").size(), 2048U * 2048U);
}

TEST(Reading, WrongExtensionAndCyrillicNameWithSpaces) {
    const TemporaryFolder folder;
    const std::string path = folder / "карта висот №1.png";
    writeHeight(path, FloatImage(3, 2, 0.5F));
    EXPECT_EQ(heights(path).heights(2, 1), static_cast<float>(32768 / 65535.0));
    std::filesystem::rename(path, folder / "насправді png.jpg");
    EXPECT_EQ(heights(folder / "насправді png.jpg").info.format, "png");
}

TEST(Reading, CanBeCancelled) {
    std::stop_source stop;
    stop.request_stop();
    Work work(2, stop.get_token());
    EXPECT_THROW(readHeight(std::string(kDatasets) + "/gray_rocks/height.png", {}, work), Cancelled);
    EXPECT_THROW(readColor(std::string(kDatasets) + "/gray_rocks/color.jpg", work), Cancelled);
}

TEST(Reading, EqualBitsForAnyThreadCount) {
    const std::string path = std::string(kDatasets) + "/terrain_srtm_east_africa/height_metres.exr";
    Work one(1), many(5);
    EXPECT_EQ(readHeight(path, {}, one).heights, readHeight(path, {}, many).heights);
    const std::string color = std::string(kDatasets) + "/stone_wall_bricks102/color.jpg";
    EXPECT_EQ(readColor(color, one), readColor(color, many));
}

TEST(Reading, UkrainianLocaleChangesNothing) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    if (std::setlocale(LC_ALL, "uk_UA.UTF-8") == nullptr) GTEST_SKIP() << "no uk_UA.UTF-8 here";
    const TemporaryFolder folder;
    EXPECT_EQ(heightRangeText(parseHeightRange("0.5,1.5")), "0.5,1.5");
    const HeightImage image = heights(writeRaw<float>(folder / "l.exr", 2, 1, 1, {-0.5F, 2.25F}));
    EXPECT_EQ(sentence(image.notes.at(0)), "heights from -0.5 to 2.25 were stretched to [0, 1]");
    for (const char* name : {"c.png", "c.exr", "c.hdr", "c.tif", "c.jpg", "c.bmp"}) {
        writeColor(folder / name, ColorImage(4, 4, Color(0.5F)));
        EXPECT_NEAR(colors(folder / name)(1, 1).g, 0.5F, 0.01) << name;
    }
    // The only format with a text header: its scale has a decimal point, whatever the locale.
    const std::string map = folder.with("m.pfm", std::string("Pf\n1 1\n-1.500000\n\0\0\0\x3f", 22));
    EXPECT_NO_THROW(heights(map));
    EXPECT_EQ(faultOf([&] { heights(folder / "none.png"); }), folder / "none.png" + std::string(": no such file"));
    std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace relief
