// Pictures written row by row in any order: read back by OpenImageIO, joined, continued, refused.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <numeric>

#include "algorithms/images/temporary_folder.h"
#include "images/picture_input.h"
#include "images/placed_file.h"
#include "small_disk.h"

namespace relief::testing {
namespace {

constexpr int kGroup = PictureLayout::kGroup;

PlacedPicture picture(bool exr, int width, int height) {
    PlacedPicture made;
    made.exr = exr;
    made.width = width;
    made.height = made.end = height;
    made.channels = {"R", "G", "B"};
    if (exr) made.channels = {"R", "G", "B", "depth.Z"};
    return made;
}

// The numbers of all rows, all different from their neighbours.
std::vector<std::byte> numbersOf(const PictureLayout& layout) {
    const PlacedPicture& made = layout.picture();
    std::vector<std::byte> numbers(layout.rowNumbers() * static_cast<std::size_t>(made.height));
    if (made.exr) {
        for (std::size_t i = 0; i < numbers.size() / 4; ++i) {
            const float number = static_cast<float>(i) * 0.25F - 7;
            std::memcpy(numbers.data() + 4 * i, &number, 4);
        }
        return numbers;
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::byte>(i * 7 + i / 251);
    return numbers;
}

// Writes the groups of rows in the opposite order; returns their checksums.
std::vector<std::uint64_t> writeAll(PlacedFile& file, const std::vector<std::byte>& numbers) {
    const PlacedPicture& made = file.layout().picture();
    std::vector<std::uint64_t> checksums;
    const int groups = (made.end - made.begin + kGroup - 1) / kGroup;
    for (int group = groups - 1; group >= 0; --group) {
        const int first = made.begin + group * kGroup, count = std::min(kGroup, made.end - first);
        const std::byte* const from = numbers.data() + static_cast<std::size_t>(first) * file.layout().rowNumbers();
        checksums.push_back(file.write(first, file.layout().encoded(first, count, from)));
    }
    return checksums;
}

std::string writePlaced(const std::string& path, const PlacedPicture& made) {
    PlacedFile file(path, PictureLayout(made));
    file.open(false);
    writeAll(file, numbersOf(PictureLayout(picture(made.exr, made.width, made.height))));
    file.finish();
    return path;
}

// Widths and heights around the sides of tiles.
TEST(PlacedFile, readersReadWhatIsWritten) {
    const TemporaryFolder folder;
    for (const bool exr : {false, true}) {
        for (const auto& [width, height] :
             {std::pair(1, 1), std::pair(63, 65), std::pair(64, 64), std::pair(130, 200)}) {
            SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) + (exr ? " exr" : " tif"));
            const PictureLayout layout(picture(exr, width, height));
            const std::string path = writePlaced(folder / (exr ? "a.exr" : "a.tif"), layout.picture());
            EXPECT_EQ(std::filesystem::file_size(path), layout.fileBytes());
            PictureInput input(path, 1 << 20);
            EXPECT_EQ(input.info().width, width);
            EXPECT_EQ(input.info().height, height);
            EXPECT_EQ(input.info().channels, layout.picture().channels);
            EXPECT_EQ(input.info().type, exr ? "float" : "uint8");
            std::vector<int> channels(layout.picture().channels.size());
            std::iota(channels.begin(), channels.end(), 0);
            Work work(1);
            const RawPlanes raw = input.read(channels, work, 0);
            const std::vector<std::byte> numbers = numbersOf(layout);
            EXPECT_EQ(std::memcmp(raw.storage.front().get(), numbers.data(), numbers.size()), 0);
            EXPECT_EQ(folder.files(), exr ? 2 : 1);
        }
    }
}

// The parts are files of their own, with a text; together they are the whole file, byte by byte.
TEST(PlacedFile, partsAreJoined) {
    const TemporaryFolder folder;
    Work work(1);
    for (const bool exr : {false, true}) {
        const std::string ending = exr ? ".exr" : ".tif";
        PlacedPicture made = picture(exr, 90, 3 * kGroup + 5);
        const std::string whole = writePlaced(folder / ("whole" + ending), made);
        std::vector<PlacedPart> parts;
        const std::array ends{kGroup, 3 * kGroup, made.height};
        for (const int end : ends) {
            made.end = end;
            made.text = "{\"relief part\": " + std::to_string(end) + "}";
            const std::string path = writePlaced(folder / (std::to_string(end) + ending), made);
            EXPECT_EQ(PictureInput(path, 1 << 20, PictureAccess::Rows).bandText(), made.text);
            parts.push_back({path, PictureLayout(made)});
            made.begin = end;
        }
        const std::string joined = folder / ("joined" + ending);
        joinPlaced(parts, joined, work);
        EXPECT_TRUE(bytesOf(joined) == bytesOf(whole));
        const std::string bytes = bytesOf(parts[1].path);
        for (std::string wrong : {bytes.substr(0, bytes.size() - 1), bytes + "a", "a" + bytes.substr(1)}) {
            folder.with(std::to_string(ends[1]) + ending, wrong);
            EXPECT_EQ(faultOf([&] { joinPlaced(parts, joined, work); }), parts[1].path + ": is damaged or cut short");
        }
        EXPECT_TRUE(bytesOf(joined) == bytesOf(whole));
    }
}

TEST(PlacedFile, bigTiffFromFourGibibytesOn) {
    const auto version = [](const PictureLayout& layout) { return static_cast<int>(layout.head()[2]); };
    // 591 rows and columns of tiles are below, 592 above.
    for (const int tiles : {591, 592}) {
        const PictureLayout layout(picture(false, tiles * kGroup, tiles * kGroup));
        EXPECT_EQ(version(layout), tiles == 591 ? 42 : 43);
        EXPECT_EQ(layout.fileBytes() < std::uint64_t{1} << 32, tiles == 591);
    }
    const PictureLayout largest(picture(false, 1 << 16, 1 << 16));
    EXPECT_GT(largest.fileBytes(), 3 * (std::uint64_t{1} << 32));
}

// What an earlier run has left is recognised by its checksums.
TEST(PlacedFile, goesOn) {
    const TemporaryFolder folder;
    const std::string path = folder / "a.tif";
    const PictureLayout layout(picture(false, 70, 2 * kGroup + 1));
    const std::vector<std::byte> numbers = numbersOf(layout);
    std::vector<std::uint64_t> checksums;
    const std::string journal = folder.with("a.tif.part", "");
    {
        PlacedFile file(path, layout);
        file.open(false);
        checksums = writeAll(file, numbers);
    }
    EXPECT_TRUE(std::filesystem::exists(path + ".rows"));
    {
        PlacedFile file(path, layout);
        file.open(true);
        EXPECT_TRUE(file.holds(0, kGroup, checksums[2]));
        EXPECT_TRUE(file.holds(2 * kGroup, 1, checksums[0]));
        EXPECT_FALSE(file.holds(0, kGroup, checksums[1]));
        const std::byte other{99};
        const int descriptor = ::open((path + ".rows").c_str(), O_WRONLY);
        ASSERT_EQ(::pwrite(descriptor, &other, 1, static_cast<::off_t>(layout.place(kGroup))), 1);
        ::close(descriptor);
        EXPECT_FALSE(file.holds(kGroup, kGroup, checksums[1]));
        EXPECT_TRUE(file.holds(0, kGroup, checksums[2]));
        writeAll(file, numbers);
        file.finish();
    }
    std::filesystem::remove(journal);
    EXPECT_TRUE(bytesOf(path) == bytesOf(writePlaced(folder / "b.tif", layout.picture())));
    // Without a journal nothing would go on from the rows.
    {
        PlacedFile file(path, layout);
        file.open(false);
    }
    EXPECT_EQ(folder.files(), 2);
    EXPECT_EQ(faultOf([&] { PlacedFile(folder / "no/a.tif", layout); }).find(folder / "no/a.tif: "), 0U);
}

// The rows stand next to the target of a link, which may be on another file system.
TEST(PlacedFile, aLinkStays) {
    const TemporaryFolder folder, far;
    const std::string target = far.with("b.tif", "old"), path = folder / "a.tif";
    std::filesystem::permissions(target, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    std::filesystem::create_symlink(target, path);
    const PlacedPicture made = picture(false, 70, 65);
    {
        const std::string journal = far.with("b.tif.part", "");
        PlacedFile(path, PictureLayout(made)).open(false);
        EXPECT_TRUE(std::filesystem::exists(target + ".rows"));
        std::filesystem::remove(journal);
    }
    writePlaced(path, made);
    EXPECT_TRUE(std::filesystem::is_symlink(path));
    EXPECT_TRUE(bytesOf(target) == bytesOf(writePlaced(folder / "whole.tif", made)));
    EXPECT_EQ(std::filesystem::status(target).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    EXPECT_EQ(far.files(), 1);
}

TEST(PlacedFile, aFullDisk) {
    const TemporaryFolder folder;
    const PictureLayout layout(picture(false, 300, 300));
    const std::string path = folder / "a.tif";
    {
        const test::SmallDisk disk(1000);
        PlacedFile file(path, layout);
        const std::string fault = faultOf([&] { file.open(false); });
        EXPECT_EQ(fault, path + ": cannot be written: File too large; the picture takes 0.000311 GB");
    }
    EXPECT_EQ(folder.files(), 0);
    PlacedFile file(path, layout);
    file.open(false);
    const test::SmallDisk disk(1000);
    EXPECT_EQ(faultOf([&] { writeAll(file, numbersOf(layout)); }), path + ": cannot be written: File too large");
    EXPECT_THROW(writeAll(file, numbersOf(layout)), WorkError);
}

}  // namespace
}  // namespace relief::testing
