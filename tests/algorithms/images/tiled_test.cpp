// Height maps larger than memory: what TiledWriter writes and TiledHeights reads is, bit for bit, what readHeight() and
// Pyramid hold in memory.
#include <fcntl.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>
#include <stop_token>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "images/file_descriptor.h"
#include "images/page_watch.h"
#include "images/pyramid.h"
#include "images/tiled_heights.h"
#include "images/tiled_pages.h"
#include "images/tiled_writer.h"
#include "picture_files.h"
#include "temporary_folder.h"

namespace relief::testing {
namespace {

struct Size {
    int width, height;
};
// Less than a tile, and not whole tiles, in either direction; more than a group of tiles.
const std::vector<Size> kSizes{{1, 1}, {63, 65}, {200, 130}, {257, 64}, {1, 300}};

// Uncorrelated numbers over the whole range of the type; floats in [0, 1].
template <class Number>
std::vector<Number> noise(Size size, int channels = 1) {
    std::mt19937 random(static_cast<unsigned>(size.width * 1000 + size.height));
    std::vector<Number> numbers(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                                static_cast<std::size_t>(channels));
    for (Number& number : numbers) {
        if constexpr (std::is_floating_point_v<Number>)
            number = static_cast<Number>(random()) / static_cast<Number>(std::mt19937::max());
        else
            number = static_cast<Number>(random());
    }
    return numbers;
}

template <class Number>
std::string noisePicture(const std::string& path, Size size) {
    return writeRaw(path, size.width, size.height, 1, noise<Number>(size));
}

// Tiles a picture; returns the notes.
std::vector<Message> tile(const std::string& from, const std::string& to, const HeightReadOptions& options = {},
                          const TiledWriting& how = {}, int threads = 0) {
    Work work(threads);
    const auto rows = pictureHeightRows(from, options);
    TiledWriter(*rows, to, how).write(work);
    return rows->notes();
}

HeightImage read(const std::string& path, const HeightReadOptions& options = {}) {
    Work work;
    return readHeight(path, options, work);
}

constexpr std::size_t kPlenty = std::size_t{1} << 30;

// Expects that every texel of every level of the file has the bits of the pyramids of the heights.
void expectPyramids(const TiledHeights& tiled, const FloatImage& heights) {
    ASSERT_EQ(tiled.width(), heights.width());
    ASSERT_EQ(tiled.height(), heights.height());
    Work work;
    const std::vector<std::pair<TileKind, PyramidKind>> kinds{
        {TileKind::Max, PyramidKind::Max}, {TileKind::Min, PyramidKind::Min}, {TileKind::Mean, PyramidKind::Mean}};
    for (const auto& [kind, pyramidKind] : kinds) {
        const Pyramid pyramid(pyramidKind, heights, work);
        ASSERT_EQ(tiled.levels(), pyramid.levels());
        for (int l = 0; l < pyramid.levels(); ++l) {
            const FloatImage& level = pyramid.level(l);
            ASSERT_EQ(tiled.width(l), level.width());
            ASSERT_EQ(tiled.height(l), level.height());
            for (int y = 0; y < level.height(); ++y) {
                for (int x = 0; x < level.width(); ++x)
                    ASSERT_EQ(tiled.value(kind, l, x, y), level(x, y))
                        << tileKindName(kind) << " level " << l << " texel " << x << ", " << y;
            }
            if (kind != TileKind::Max) continue;
            for (int y = 1; y < level.height(); ++y) {
                for (int x = 1; x < level.width(); ++x)
                    ASSERT_EQ(tiled.highest(l, x - 1, x, y - 1, y),
                              std::max({level(x - 1, y - 1), level(x, y - 1), level(x - 1, y), level(x, y)}))
                        << "level " << l << " up to texel " << x << ", " << y;
            }
        }
    }
}

TEST(Tiled, EveryLevelHasTheBitsOfThePyramidInMemory) {
    const TemporaryFolder folder;
    for (const Size size : kSizes) {
        for (const auto& [type, picture] :
             {std::pair(NumberType::UInt8, noisePicture<std::uint8_t>(folder / "8.tif", size)),
              std::pair(NumberType::UInt16, noisePicture<std::uint16_t>(folder / "16.tif", size)),
              std::pair(NumberType::Float, noisePicture<float>(folder / "32.tif", size))}) {
            SCOPED_TRACE(picture + ", " + std::to_string(size.width) + " x " + std::to_string(size.height));
            tile(picture, folder / "t.tif");
            const auto tiled = TiledHeights::open(folder / "t.tif", kPlenty);
            EXPECT_EQ(tiled->type(), type);
            expectPyramids(*tiled, read(picture).heights);
        }
    }
}

TEST(Tiled, EveryCodeHasTheBitsOfTheHeightInMemory) {
    const TemporaryFolder folder;
    std::vector<std::uint16_t> codes(65536);
    for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<std::uint16_t>(i);
    const std::string picture = writeRaw(folder / "all.png", 256, 256, 1, codes);
    std::vector<std::uint8_t> bytes(256);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i);
    for (const std::string& file : {picture, writeRaw(folder / "bytes.png", 16, 16, 1, bytes)}) {
        tile(file, folder / "t.tif");
        const auto tiled = TiledHeights::open(folder / "t.tif", kPlenty);
        const FloatImage heights = read(file).heights;
        for (int y = 0; y < heights.height(); ++y) {
            for (int x = 0; x < heights.width(); ++x) {
                ASSERT_EQ(tiled->height(x, y), heights(x, y)) << file << ", code " << heights.width() * y + x;
            }
        }
    }
}

TEST(Tiled, ReadsWhatReadHeightReads) {
    const TemporaryFolder folder;
    const Size size{130, 150};
    OIIO::ImageSpec inTiles(size.width, size.height, 3, OIIO::TypeDesc::FLOAT);
    inTiles.tile_width = 48;
    inTiles.tile_height = 80;
    inTiles.x = 5;
    inTiles.y = -7;
    std::vector<float> wide = noise<float>(size);
    for (float& value : wide) value = 700 * value - 200;
    std::vector<std::int16_t> steps = noise<std::int16_t>(size);
    struct Case {
        std::string picture;
        HeightReadOptions options;
    };
    HeightReadOptions channel, inverted, bounds, codes, full;
    channel.channel = "G";
    inverted.invert = true;
    bounds.range = {HeightRange::Kind::Bounds, 0.25, 0.5};
    codes.range = {HeightRange::Kind::Bounds, 100, 200};
    full.range = {HeightRange::Kind::Full};
    const std::vector<Case> cases{
        {writeRaw(folder / "wide.exr", size.width, size.height, 1, wide), {}},
        {writeRaw(folder / "wide.tif", size.width, size.height, 1, wide), bounds},
        {writeRaw(folder / "tiles.exr", inTiles, noise<float>(size, 3)), channel},
        {writeRaw(folder / "color.png", size.width, size.height, 3, noise<std::uint8_t>(size, 3)), channel},
        {writeRaw(folder / "grey.jpg", size.width, size.height, 1, noise<std::uint8_t>(size)), inverted},
        {writeRaw(folder / "grey.bmp", size.width, size.height, 1, noise<std::uint8_t>(size)), codes},
        {writeRaw(folder / "signed.tif", size.width, size.height, 1, steps), {}},
        {writeRaw(folder / "unit.exr", size.width, size.height, 1, noise<float>(size)), full},
        {writeRaw(folder / "double.tif", size.width, size.height, 1, noise<double>(size)), {}},
        {writeRaw(folder / "flat.exr", size.width, size.height, 1, std::vector<float>(130 * 150, 3.5F)), inverted},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.picture);
        const std::vector<Message> notes = tile(one.picture, folder / "t.tif", one.options);
        const HeightImage image = read(one.picture, one.options);
        expectPyramids(*TiledHeights::open(folder / "t.tif", kPlenty), image.heights);
        ASSERT_EQ(notes.size(), image.notes.size());
        for (std::size_t i = 0; i < notes.size(); ++i) EXPECT_EQ(sentence(notes[i]), sentence(image.notes[i]));
    }
}

// The file's first picture is the map itself, so that readHeight() reads it too, and tiles it again.
TEST(Tiled, ReadsItsOwnFiles) {
    const TemporaryFolder folder;
    const std::string picture = noisePicture<std::uint16_t>(folder / "a.png", {200, 130});
    tile(picture, folder / "t.tif");
    EXPECT_EQ(read(folder / "t.tif").heights, read(picture).heights);
    tile(folder / "t.tif", folder / "u.tif");
    EXPECT_EQ(bytesOf(folder / "t.tif"), bytesOf(folder / "u.tif"));
}

TEST(Tiled, OpenImageIoReadsEveryPage) {
    const TemporaryFolder folder;
    const Size size{200, 130};
    for (const std::string& picture :
         {noisePicture<std::uint16_t>(folder / "16.tif", size), noisePicture<std::uint8_t>(folder / "8.tif", size),
          noisePicture<float>(folder / "32.tif", size)}) {
        tile(picture, folder / "t.tif");
        const auto tiled = TiledHeights::open(folder / "t.tif", kPlenty);
        const auto input = OIIO::ImageInput::open(folder / "t.tif");
        ASSERT_TRUE(input) << OIIO::geterror();
        int subimage = 0;
        for (const TilePage& page : tiled->layout().pages) {
            ASSERT_TRUE(input->seek_subimage(subimage, 0)) << input->geterror();
            const OIIO::ImageSpec spec = input->spec();
            EXPECT_EQ(spec.width, page.width);
            EXPECT_EQ(spec.height, page.height);
            EXPECT_EQ(spec.tile_width, kTileSide);
            EXPECT_EQ(spec.format.size() * kTileTexels, page.tileBytes());
            const auto json = nlohmann::json::parse(std::string(spec.get_string_attribute("ImageDescription")));
            EXPECT_EQ(json.at("kind"), tileKindName(page.kind));
            EXPECT_EQ(json.at("level"), page.level);
            EXPECT_EQ(json.at("field"), nlohmann::json({size.width, size.height}));
            std::vector<float> texels(static_cast<std::size_t>(page.width * page.height));
            // OpenImageIO multiplies codes by the rounded reciprocal.
            const float tolerance = page.type == NumberType::Float ? 0 : 1e-7F;
            ASSERT_TRUE(input->read_image(subimage, 0, 0, 1, OIIO::TypeDesc::FLOAT, texels.data()));
            for (int y = 0; y < page.height; ++y) {
                for (int x = 0; x < page.width; ++x)
                    ASSERT_NEAR(texels[static_cast<std::size_t>(y * page.width + x)],
                                tiled->value(page.kind, page.level, x, y), tolerance);
            }
            ++subimage;
        }
        ASSERT_TRUE(input->seek_subimage(subimage, 0)) << input->geterror();
        std::vector<std::uint32_t> sums(input->spec().image_pixels());
        EXPECT_TRUE(input->read_image(subimage, 0, 0, 1, OIIO::TypeDesc::UINT32, sums.data())) << input->geterror();
        EXPECT_NE(sums[0], 0U);
        EXPECT_FALSE(input->seek_subimage(subimage + 1, 0));
    }
}

TEST(Tiled, BytesDoNotDependOnThreads) {
    const TemporaryFolder folder;
    const std::string picture = noisePicture<float>(folder / "a.tif", {257, 300});
    tile(picture, folder / "1.tif", {}, {}, 1);
    tile(picture, folder / "4.tif", {}, {}, 4);
    EXPECT_EQ(bytesOf(folder / "1.tif"), bytesOf(folder / "4.tif"));
}

// Resident bytes of the process's mapping of a file.
std::size_t mappedBytes(const std::string& path) {
    std::ifstream maps("/proc/self/smaps");
    std::size_t bytes = 0;
    bool here = false;
    for (std::string line; std::getline(maps, line);) {
        if (line.find('-') < line.find(' ')) here = line.ends_with(path);
        if (here && line.starts_with("Rss:")) bytes += std::stoul(line.substr(4)) * 1024;
    }
    return bytes;
}

TEST(Tiled, ResidentMemoryStaysWithinTheBound) {
    const TemporaryFolder folder;
    const Size size{1024, 1024};
    for (const std::string& picture :
         {noisePicture<std::uint8_t>(folder / "8.tif", size), noisePicture<float>(folder / "32.tif", size)}) {
        tile(picture, folder / "t.tif");
        constexpr std::size_t kBound = 400'000;
        const auto tiled = TiledHeights::open(folder / "t.tif", kBound);
        const FloatImage heights = read(picture).heights;
        EXPECT_GT(heights.bytes(), 4 * kBound);
        std::mt19937 random(1);
        std::size_t most = 0;
        for (int i = 0; i < 4'000; ++i) {
            const int x = static_cast<int>(random() % 1024), y = static_cast<int>(random() % 1024);
            ASSERT_EQ(tiled->height(x, y), heights(x, y));
            ASSERT_GE(tiled->maximum(1, x / 2, y / 2), heights(x, y));
            ASSERT_LE(tiled->residentBytes(), kBound);
            if (i % 100 != 0) continue;
            most = std::max(most, mappedBytes(folder / "t.tif"));
            ASSERT_LE(most, kBound);
        }
        EXPECT_GT(most, kBound / 4) << "the mapping was not found, or the bound is not used";
        const TileStatistics statistics = tiled->statistics();
        EXPECT_GT(statistics.evictions, 100U);
        EXPECT_EQ(statistics.misses, statistics.tilesRead);
        EXPECT_GT(statistics.bytesRead, statistics.tilesRead * kLeastTileBytes - 1);
    }
}

// Tiles that are used again and again stay; others go.
TEST(Tiled, KeepsWhatIsUsed) {
    const TemporaryFolder folder;
    tile(noisePicture<float>(folder / "a.tif", {1024, 1024}), folder / "t.tif");
    const auto tiled = TiledHeights::open(folder / "t.tif", 10 * kGroupBytes);
    const auto before = [&] { return tiled->statistics().tilesRead; };
    static_cast<void>(tiled->height(0, 0));
    const auto first = before();
    EXPECT_EQ(first, 1U);
    for (int y = 64; y < 1024; y += 64) {
        for (int x = 0; x < 1024; x += 64) {
            static_cast<void>(tiled->height(x, y));
            const auto read = before();
            static_cast<void>(tiled->height(1, 1));
            ASSERT_EQ(before(), read) << "the tile in use was dropped at " << x << ", " << y;
        }
    }
    EXPECT_GT(tiled->statistics().evictions, 10U);
}

TEST(Tiled, ManyReadersShareATinyBound) {
    const TemporaryFolder folder;
    const std::string picture = noisePicture<std::uint16_t>(folder / "a.tif", {640, 640});
    tile(picture, folder / "t.tif");
    const FloatImage heights = read(picture).heights;
    for (const std::size_t bound : {std::size_t{0}, std::size_t{300'000}}) {
        const auto tiled = TiledHeights::open(folder / "t.tif", bound);
        std::atomic<int> wrong{0};
        std::vector<std::jthread> readers;
        for (unsigned n = 0; n < 4; ++n) {
            readers.emplace_back([&, n] {
                std::mt19937 random(n);
                for (int i = 0; i < 5'000; ++i) {
                    const int x = static_cast<int>(random() % 640), y = static_cast<int>(random() % 640);
                    if (tiled->height(x, y) != heights(x, y)) ++wrong;
                    if (tiled->minimum(1, x / 2, y / 2) > heights(x, y)) ++wrong;
                }
            });
        }
        readers.clear();
        EXPECT_EQ(wrong, 0);
        EXPECT_LE(tiled->residentBytes(), std::max<std::size_t>(bound, 150'000));
        EXPECT_GT(tiled->statistics().evictions, 100U);
    }
}

TEST(Tiled, PrefetchChangesNothing) {
    const TemporaryFolder folder;
    tile(noisePicture<std::uint8_t>(folder / "a.tif", {640, 640}), folder / "t.tif");
    const auto tiled = TiledHeights::open(folder / "t.tif", kPlenty);
    const std::vector<TileRange> ranges{{TileKind::Height, 0, -5, -5, 9999, 9999}, {TileKind::Mean, 3, 10, 10, 20, 20}};
    tiled->prefetch(ranges);
    EXPECT_EQ(tiled->statistics().tilesRead, 0U);
    EXPECT_EQ(mappedBytes(folder / "t.tif"), 0U);
}

void flipByte(const std::string& path, std::uint64_t at) {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekg(static_cast<std::streamoff>(at));
    const int byte = file.get();
    file.seekp(static_cast<std::streamoff>(at));
    file.put(static_cast<char>(byte ^ 0x10));
}

TEST(Tiled, DamageIsFound) {
    const TemporaryFolder folder;
    const std::string path = folder / "t.tif";
    tile(noisePicture<std::uint16_t>(folder / "a.tif", {300, 200}), path);
    const TiledLayout layout = TiledHeights::open(path, kPlenty)->layout();
    EXPECT_EQ(std::filesystem::file_size(path), layout.fileBytes);
    const TilePage& page = layout.page(TileKind::Min, 1);

    flipByte(path, page.tileOffset(2, 1) + 5);
    const auto tiled = TiledHeights::open(path, kPlenty);
    EXPECT_EQ(tiled->minimum(1, 127, 64), tiled->minimum(1, 127, 64));
    EXPECT_EQ(faultOf([&] { static_cast<void>(tiled->minimum(1, 128, 64)); }),
              path + ": is damaged: wrong checksum of tile (2, 1) of the page min, level 1");
    flipByte(path, page.tileOffset(2, 1) + 5);
    EXPECT_EQ(faultOf([&] { static_cast<void>(tiled->minimum(1, 128, 64)); }), "");

    flipByte(path, layout.checksums + 17);
    EXPECT_EQ(faultOf([&] { TiledHeights::open(path, kPlenty); }),
              path + ": is damaged: wrong checksum of the table of checksums");
    flipByte(path, layout.checksums + 17);

    std::filesystem::resize_file(path, layout.fileBytes - 1);
    EXPECT_EQ(faultOf([&] { TiledHeights::open(path, kPlenty); }),
              path + ": is cut short: " + std::to_string(layout.fileBytes - 1) + " of " +
                  std::to_string(layout.fileBytes) + " bytes are there");
    EXPECT_TRUE(TiledHeights::isTiled(path));

    // A byte of a directory: another size of page, another type, another place.
    std::filesystem::resize_file(path, layout.fileBytes);
    int refused = 0;
    for (std::uint64_t at = 16; at < 400; at += 3) {
        flipByte(path, at);
        refused += faultOf([&] { TiledHeights::open(path, kPlenty); }).empty() ? 0 : 1;
        flipByte(path, at);
    }
    EXPECT_GT(refused, 60);
}

// A page that the file no longer has reads as zeros, and the range is marked; other ranges are not.
TEST(PageWatch, PagesThatAreGoneAreZeros) {
    const TemporaryFolder folder;
    const std::string path = folder / "pages";
    constexpr std::size_t kPage = 4096, kBytes = 8 * kPage;
    std::ofstream(path) << std::string(kBytes, 'x');
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    const auto mapped = [&] {
        return static_cast<char*>(::mmap(nullptr, kBytes, PROT_READ, MAP_PRIVATE, file.number(), 0));
    };
    char *const first = mapped(), *const second = mapped();
    {
        const PageWatch watch(first, kBytes), other(second, kBytes);
        EXPECT_EQ(first[kPage], 'x');
        std::filesystem::resize_file(path, 2 * kPage);
        EXPECT_FALSE(watch.lost());
        EXPECT_EQ(const_cast<volatile char*>(first)[5 * kPage + 7], 0);
        EXPECT_TRUE(watch.lost());
        EXPECT_FALSE(other.lost());
        EXPECT_EQ(first[kPage], 'x');
    }
    EXPECT_FALSE(PageWatch(second, kBytes).lost()) << "a range that is used again is not marked";
    struct sigaction handler {};
    ::sigaction(SIGBUS, nullptr, &handler);
    EXPECT_NE(handler.sa_flags & SA_ONSTACK, 0) << "threads may have too small a stack, and another for handlers";
    ::munmap(first, kBytes);
    ::munmap(second, kBytes);
}

// Another program shortens the file after a tile was read. What was read is right, or requireWhole() says that it may
// not be.
TEST(Tiled, AFileThatIsCutWhileItIsOpenIsNoCrash) {
    const TemporaryFolder folder;
    const std::string path = folder / "t.tif";
    tile(noisePicture<std::uint16_t>(folder / "a.tif", {300, 200}), path);
    const auto tiled = TiledHeights::open(path, kPlenty);
    const float first = tiled->height(0, 0);
    tiled->requireWhole();
    const std::uint64_t cut = tiled->layout().pages.front().first;
    std::filesystem::resize_file(path, cut);
    const float again = tiled->height(0, 0);
    const std::string fault = faultOf([&] { tiled->requireWhole(); });
    EXPECT_TRUE(fault.empty() ? again == first : fault.starts_with(path + ": is cut short: ")) << fault;
    EXPECT_TRUE(faultOf([&] { static_cast<void>(tiled->height(299, 199)); }).starts_with(path + ": is "));
    // Another file is not affected, nor is one that is replaced by renaming: the old one stays open.
    const std::string other = folder / "o.tif";
    tile(noisePicture<std::uint16_t>(folder / "b.tif", {300, 200}), other);
    const auto kept = TiledHeights::open(other, kPlenty);
    tile(noisePicture<std::uint16_t>(folder / "c.tif", {63, 65}), folder / "n.tif");
    std::filesystem::rename(folder / "n.tif", other);
    EXPECT_EQ(kept->height(0, 0), first);
    kept->requireWhole();
}

#ifndef __SANITIZE_THREAD__  // it allows no new threads after a fork
TEST(Tiled, OtherBusErrorsEndTheProcess) {
    EXPECT_EXIT(
        {
            const TemporaryFolder folder;
            tile(noisePicture<std::uint16_t>(folder / "a.tif", {300, 200}), folder / "t.tif");
            const auto tiled = TiledHeights::open(folder / "t.tif", kPlenty);
            ::raise(SIGBUS);
        },
        ::testing::KilledBySignal(SIGBUS), "");
}
#endif

TEST(Tiled, OtherFilesAreRefused) {
    const TemporaryFolder folder;
    const std::string picture = noisePicture<std::uint16_t>(folder / "a.tif", {300, 200});
    EXPECT_FALSE(TiledHeights::isTiled(picture));
    EXPECT_FALSE(TiledHeights::isTiled(folder / "none.tif"));
    EXPECT_EQ(faultOf([&] { TiledHeights::open(picture, 0); }),
              picture + ": is not a tiled pyramid as relief tile writes it");
    EXPECT_EQ(faultOf([&] { TiledHeights::open(folder / "none.tif", 0); }), folder / "none.tif: no such file");
    EXPECT_NE(faultOf([&] { TiledHeights::open(folder / "", 0); }), "");
}

TEST(Tiled, ReadErrorsNameTheTexel) {
    const TemporaryFolder folder;
    std::vector<float> heights(100 * 200, 0.5F);
    heights[150 * 100 + 7] = std::numeric_limits<float>::quiet_NaN();
    const std::string picture = writeRaw(folder / "a.exr", 100, 200, 1, heights);
    EXPECT_EQ(faultOf([&] { tile(picture, folder / "t.tif"); }), picture + ": the height at (7, 150) is nan");
    EXPECT_EQ(folder.files(), 1) << "FILE.part is left behind";
    heights[150 * 100 + 7] = 2;
    writeRaw(picture, 100, 200, 1, heights);
    EXPECT_EQ(faultOf([&] { tile(picture, folder / "t.tif", {.range = {HeightRange::Kind::Full}}); }),
              faultOf([&] { read(picture, {.range = {HeightRange::Kind::Full}}); }));
}

TEST(Tiled, DamagedPicturesAreRefused) {
    const TemporaryFolder folder;
    const Size size{150, 200};
    for (const std::string& picture :
         {noisePicture<std::uint16_t>(folder / "a.tif", size), noisePicture<std::uint16_t>(folder / "a.png", size),
          noisePicture<float>(folder / "a.exr", size), noisePicture<std::uint8_t>(folder / "a.jpg", size),
          noisePicture<std::uint8_t>(folder / "a.bmp", size)}) {
        // The middle of a TIFF file is missing: its directory stands at the end.
        std::string bytes = bytesOf(picture);
        bytes.erase(bytes.size() / 2, bytes.size() / 3);
        folder.with(std::filesystem::path(picture).filename(), bytes);
        const std::string fault = faultOf([&] { tile(picture, folder / "t.tif"); });
        EXPECT_EQ(fault.substr(0, picture.size() + 13), picture + ": is damaged ") << fault;
        std::filesystem::remove(folder / "t.tif.part");
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "t.tif"));
}

// Heights of a picture that do something before a band is read.
class WatchedRows final : public HeightRows {
  public:
    WatchedRows(const std::string& path, const HeightReadOptions& options, std::function<void(int firstRow)> before)
        : rows_(pictureHeightRows(path, options)), before_(std::move(before)) {}
    int width() const override { return rows_->width(); }
    int height() const override { return rows_->height(); }
    NumberType type() const override { return rows_->type(); }
    std::string identity() const override { return rows_->identity(); }
    std::string learned() const override { return rows_->learned(); }
    void restore(const std::string& learned) override { rows_->restore(learned); }
    void prepare(Work& work) override { rows_->prepare(work); }
    void read(int first, int count, std::byte* rows, Work& work) override {
        before_(first);
        rows_->read(first, count, rows, work);
    }
    std::vector<Message> notes() const override { return rows_->notes(); }

  private:
    std::unique_ptr<HeightRows> rows_;
    std::function<void(int)> before_;
};

TEST(Tiled, ResumedRunsGiveTheSameBytes) {
    const TemporaryFolder folder;
    const Size size{150, 700};
    std::vector<float> wide = noise<float>(size);
    for (float& value : wide) value = 7 * value - 2;
    const std::string picture = writeRaw(folder / "a.exr", size.width, size.height, 1, wide);
    const HeightReadOptions options{.range = {HeightRange::Kind::Bounds, 0, 4}};
    for (const HeightReadOptions& reading : {HeightReadOptions{}, options}) {
        const std::vector<Message> notes = tile(picture, folder / "whole.tif", reading);
        const std::string path = folder / "t.tif";
        std::int64_t kept = 0;
        int runs = 0;
        std::vector<Message> resumedNotes;
        // Every run ends in its third band.
        for (bool done = false; !done; ++runs) {
            ASSERT_LT(runs, 20);
            std::stop_source stop;
            Work work(2, stop.get_token());
            int reads = 0;
            WatchedRows rows(picture, reading, [&](int) {
                if (++reads == 3) stop.request_stop();
            });
            TiledWriter writer(rows, path, {.earlier = EarlierRun::Resume});
            EXPECT_EQ(writer.earlierBands(), kept);
            try {
                writer.write(work);
                done = true;
                resumedNotes = rows.notes();
            } catch (const Cancelled&) {
                EXPECT_FALSE(std::filesystem::exists(path));
                EXPECT_TRUE(std::filesystem::exists(writer.partPath()));
                EXPECT_GT(writer.keptBands(), kept);
                kept = writer.keptBands();
            }
        }
        EXPECT_GT(runs, 3);
        EXPECT_EQ(bytesOf(path), bytesOf(folder / "whole.tif"));
        EXPECT_FALSE(std::filesystem::exists(path + ".part"));
        ASSERT_EQ(resumedNotes.size(), notes.size());
        for (std::size_t i = 0; i < notes.size(); ++i) EXPECT_EQ(sentence(resumedNotes[i]), sentence(notes[i]));
        std::filesystem::remove(path);
    }
}

// A process that is killed leaves FILE.part as it stood at some moment.
TEST(Tiled, ResumesFromAnyMoment) {
    const TemporaryFolder folder;
    const std::string picture = noisePicture<std::uint16_t>(folder / "a.tif", {300, 700});
    std::vector<std::string> left;
    Work work;
    WatchedRows rows(picture, {}, [&](int first) {
        const std::string copy = folder / ("killed" + std::to_string(first) + ".tif");
        std::filesystem::copy_file(folder / "whole.tif.part", copy + ".part");
        left.push_back(copy);
    });
    TiledWriter(rows, folder / "whole.tif", {.keepEverySeconds = 0}).write(work);
    ASSERT_EQ(left.size(), 11U);
    int goneOn = 0;
    for (const std::string& copy : left) {
        const auto again = pictureHeightRows(picture, {});
        TiledWriter writer(*again, copy, {.earlier = EarlierRun::Resume});
        goneOn += writer.earlierBands() > 0 ? 1 : 0;
        writer.write(work);
        EXPECT_EQ(bytesOf(copy), bytesOf(folder / "whole.tif")) << copy;
    }
    EXPECT_GE(goneOn, 8);
}

TEST(Tiled, AFailureKeepsWhatIsDone) {
    const TemporaryFolder folder;
    const std::string picture = noisePicture<std::uint16_t>(folder / "a.tif", {100, 300});
    tile(picture, folder / "whole.tif");
    const std::string path = folder / "t.tif";
    Work work;
    WatchedRows rows(picture, {}, [&](int first) {
        if (first == 192) throw WorkError(picture, Message(MessageId::DiskFull));
    });
    EXPECT_EQ(faultOf([&] { TiledWriter(rows, path, {}).write(work); }),
              picture + ": no space left on the disk; 3 of 5 parts are done and kept in " + path +
                  ".part; run the same command with --resume to continue");
    EXPECT_EQ(faultOf([&] { tile(picture, path); }), path + ".part: " + sentence(Message(MessageId::SweepThere)));
    EXPECT_EQ(faultOf([&] { tile(picture, path, {.invert = true}, {.earlier = EarlierRun::Resume}); }),
              path + ".part: " + sentence(Message(MessageId::SweepOther)));
    EXPECT_TRUE(std::filesystem::exists(path + ".part"));
    tile(picture, path, {}, {.earlier = EarlierRun::Resume});
    EXPECT_EQ(bytesOf(path), bytesOf(folder / "whole.tif"));

    EXPECT_NE(faultOf([&] { TiledWriter(rows, path, {}).write(work); }), "");
    tile(picture, path, {}, {.earlier = EarlierRun::Replace});
    EXPECT_EQ(bytesOf(path), bytesOf(folder / "whole.tif"));
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

// What is done stands next to the target of a link, which may be on another file system.
TEST(Tiled, ALinkStays) {
    const TemporaryFolder folder, far;
    const std::string picture = noisePicture<std::uint16_t>(folder / "a.tif", {100, 300});
    tile(picture, folder / "whole.tif");
    const std::string target = far.with("t.tif", "old"), path = folder / "link.tif";
    std::filesystem::permissions(target, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    std::filesystem::create_symlink(target, path);
    Work work;
    WatchedRows rows(picture, {}, [&](int first) {
        if (first == 192) throw WorkError(picture, Message(MessageId::DiskFull));
    });
    EXPECT_NE(faultOf([&] { TiledWriter(rows, path, {}).write(work); }).find(" kept in " + target + ".part; "),
              std::string::npos);
    tile(picture, path, {}, {.earlier = EarlierRun::Resume});
    EXPECT_TRUE(std::filesystem::is_symlink(path));
    EXPECT_EQ(bytesOf(target), bytesOf(folder / "whole.tif"));
    EXPECT_EQ(std::filesystem::status(target).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    EXPECT_EQ(far.files(), 1);
}

TEST(Tiled, OutputsThatCannotBeWrittenAreRefusedAtOnce) {
    const TemporaryFolder folder;
    const std::string picture = noisePicture<std::uint8_t>(folder / "a.tif", {10, 10});
    EXPECT_EQ(faultOf([&] { tile(picture, folder / "no/t.tif"); }),
              folder / "no/t.tif: there is no folder \"" + folder / "no" + "\"");
    EXPECT_EQ(folder.files(), 1);
}

}  // namespace
}  // namespace relief::testing
