#include "images/picture_layout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <numeric>
#include <string_view>
#include <utility>

#include "images/big_tiff.h"
#include "images/picture_bands.h"

namespace relief {

namespace {

// From this file size on a TIFF needs 64-bit offsets.
constexpr std::uint64_t kBigTiff = std::uint64_t{1} << 32;
constexpr std::uint64_t kAlignment = 4096;                  // of the first tile, bytes
constexpr std::size_t kRgb = 3;                             // bytes of a pixel of a TIFF
constexpr std::size_t kRowHead = 2 * sizeof(std::int32_t);  // of an EXR's row: its number and the bytes that follow

std::size_t tilesAlong(int texels) {
    return static_cast<std::size_t>((texels + kTileMask) / kTileSide);
}

// Puts values of OpenEXR's header, low byte first.
class ExrHead {
  public:
    template <class Number>
    ExrHead& put(Number number) {
        const auto* const from = reinterpret_cast<const std::byte*>(&number);
        bytes_.insert(bytes_.end(), from, from + sizeof number);
        return *this;
    }
    // A name or a type, with its end.
    ExrHead& put(const std::string& text) {
        letters(text);
        return put(char{0});
    }
    ExrHead& letters(std::string_view text) {
        const auto* const from = reinterpret_cast<const std::byte*>(text.data());
        bytes_.insert(bytes_.end(), from, from + text.size());
        return *this;
    }
    ExrHead& attribute(const std::string& name, const std::string& type, std::size_t bytes) {
        return put(name).put(type).put(static_cast<std::int32_t>(bytes));
    }
    void box(const std::string& name, int x0, int y0, int x1, int y1) {
        attribute(name, "box2i", 4 * sizeof(std::int32_t)).put(x0).put(y0).put(x1).put(y1);
    }
    std::size_t size() const { return bytes_.size(); }
    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    std::vector<std::byte> bytes_;
};

// The header of an OpenEXR file, without the table of rows that follows it. order: the channels by their names.
ExrHead exrHeader(const PlacedPicture& picture, const std::vector<std::size_t>& order) {
    constexpr std::int32_t kMagic = 20000630, kVersion = 2, kFloat = 2;
    ExrHead head;
    head.put(kMagic).put(kVersion);
    std::size_t list = 1;
    for (const std::string& name : picture.channels) list += name.size() + 1 + 4 * sizeof(std::int32_t);
    head.attribute("channels", "chlist", list);
    for (const std::size_t c : order) {
        // The type; perceptually linear: no, and three unused bytes; every column and every row has a number.
        head.put(picture.channels[c]).put(kFloat).put(std::int32_t{0}).put(std::int32_t{1}).put(std::int32_t{1});
    }
    head.put(char{0});
    head.attribute("compression", "compression", 1).put(char{0});
    head.box("dataWindow", 0, picture.begin, picture.width - 1, picture.end - 1);
    head.box("displayWindow", 0, 0, picture.width - 1, picture.height - 1);
    head.attribute("lineOrder", "lineOrder", 1).put(char{0});
    head.attribute("pixelAspectRatio", "float", sizeof(float)).put(1.0F);
    head.attribute("screenWindowCenter", "v2f", 2 * sizeof(float)).put(0.0F).put(0.0F);
    head.attribute("screenWindowWidth", "float", sizeof(float)).put(1.0F);
    const std::string& text = picture.text;
    if (!text.empty()) head.attribute(std::string(kBandAttribute), "string", text.size()).letters(text);
    head.put(char{0});
    return head;
}

// The page without the offsets of its tiles, of which only the number counts for the size of the head.
TiffPage tiffPage(const PlacedPicture& picture, std::size_t tiles) {
    TiffPage page;
    page.width = static_cast<std::uint32_t>(picture.width);
    page.height = static_cast<std::uint32_t>(picture.end - picture.begin);
    page.channels = static_cast<int>(kRgb);
    page.description = picture.text;
    page.offsets.resize(tiles);
    return page;
}

}  // namespace

PictureLayout::PictureLayout(PlacedPicture picture) : picture_(std::move(picture)), order_(picture_.channels.size()) {
    assert(picture_.width > 0 && picture_.begin < picture_.end && picture_.end <= picture_.height);
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    const int rows = picture_.end - picture_.begin;
    if (picture_.exr) {
        std::sort(order_.begin(), order_.end(),
                  [&](std::size_t a, std::size_t b) { return picture_.channels[a] < picture_.channels[b]; });
        first_ = exrHeader(picture_, order_).size() + static_cast<std::size_t>(rows) * sizeof(std::uint64_t);
        return;
    }
    assert(picture_.channels.size() == kRgb);
    const std::size_t tiles = tilesAlong(picture_.width) * tilesAlong(rows);
    for (const TiffForm form : {TiffForm::Classic, TiffForm::Big}) {
        big_ = form == TiffForm::Big;
        first_ = (tiffHeadBytes({tiffPage(picture_, tiles)}, form) + kAlignment - 1) / kAlignment * kAlignment;
        if (fileBytes() < kBigTiff) return;
    }
}

std::size_t PictureLayout::rowNumbers() const {
    return static_cast<std::size_t>(picture_.width) * picture_.channels.size() *
           (picture_.exr ? sizeof(float) : sizeof(std::uint8_t));
}

std::uint64_t PictureLayout::place(int row) const {
    const int rows = row - picture_.begin;
    assert(rows % kGroup == 0 || row == picture_.end);
    if (picture_.exr) return first_ + static_cast<std::uint64_t>(rows) * (kRowHead + rowNumbers());
    return first_ + static_cast<std::uint64_t>(tilesAlong(rows)) * tilesAlong(picture_.width) * kTileTexels * kRgb;
}

std::vector<std::byte> PictureLayout::tiffHead() const {
    TiffPage page = tiffPage(picture_, tilesAlong(picture_.width) * tilesAlong(picture_.end - picture_.begin));
    for (std::size_t i = 0; i < page.offsets.size(); ++i) page.offsets[i] = first_ + i * kTileTexels * kRgb;
    std::vector<std::byte> head = relief::tiffHead({page}, big_ ? TiffForm::Big : TiffForm::Classic);
    head.resize(first_);
    return head;
}

std::vector<std::byte> PictureLayout::exrHead() const {
    ExrHead head = exrHeader(picture_, order_);
    for (int row = 0; row < picture_.end - picture_.begin; ++row)
        head.put(first_ + static_cast<std::uint64_t>(row) * (kRowHead + rowNumbers()));
    return head.take();
}

std::vector<std::byte> PictureLayout::head() const {
    return picture_.exr ? exrHead() : tiffHead();
}

std::vector<std::byte> PictureLayout::encoded(int first, int count, const std::byte* numbers) const {
    std::vector<std::byte> bytes(place(first + count) - place(first));
    std::byte* to = bytes.data();
    const auto width = static_cast<std::size_t>(picture_.width), channels = picture_.channels.size();
    for (int y = 0; picture_.exr && y < count; ++y, numbers += rowNumbers()) {
        const std::array<std::int32_t, 2> row{first + y, static_cast<std::int32_t>(rowNumbers())};
        std::memcpy(to, row.data(), sizeof row);
        to += sizeof row;
        for (const std::size_t c : order_) {
            for (std::size_t x = 0; x < width; ++x, to += sizeof(float))
                std::memcpy(to, numbers + (x * channels + c) * sizeof(float), sizeof(float));
        }
    }
    if (picture_.exr) return bytes;
    // Tiles are filled up with zeros.
    for (int y = 0; y < count; ++y, numbers += rowNumbers()) {
        const std::size_t tiles = static_cast<std::size_t>(y / kTileSide) * tilesAlong(picture_.width);
        for (std::size_t x = 0; x < width; x += kTileSide) {
            const std::size_t texel =
                (tiles + x / kTileSide) * kTileTexels + static_cast<std::size_t>(y % kTileSide) * kTileSide;
            std::memcpy(to + texel * kRgb, numbers + x * kRgb, std::min<std::size_t>(kTileSide, width - x) * kRgb);
        }
    }
    return bytes;
}

}  // namespace relief
