#include "images/tiled_pages.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <nlohmann/json.hpp>

namespace relief {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "reliefscope pyramid";
constexpr const char* kChecksumKind = "checksums";
constexpr std::size_t kHexDigits = 16;

// As text, since JSON numbers have only 53 bits.
std::string hexText(std::uint64_t value) {
    std::string digits(kHexDigits, '0');
    for (std::size_t i = 0; i < kHexDigits; ++i) digits[i] = "0123456789abcdef"[value >> (60 - 4 * i) & 15U];
    return digits;
}

std::string checksumPage(const TiledLayout& layout, std::uint64_t checksum) {
    return Json{{"format", kFormat},
                {"version", kTiledFileVersion},
                {"kind", kChecksumKind},
                {"size", {TiledLayout::kChecksumWidth, layout.checksumHeight()}},
                {"field", {layout.width, layout.height}},
                {"checksum", hexText(checksum)}}
        .dump();
}

std::string levelPage(const TiledLayout& layout, const TilePage& page) {
    return pyramidPage(kTiledFileVersion, page.kind, page.level, layout.levels, {page.width, page.height},
                       {layout.width, layout.height})
        .dump();
}

int bitsOf(NumberType type) {
    return type == NumberType::UInt8 ? 8 : type == NumberType::UInt16 ? 16 : 32;
}

// The page without its offsets.
TiffPage tiffPage(const TiledLayout& layout, const TilePage& page) {
    return {.width = static_cast<std::uint32_t>(page.width),
            .height = static_cast<std::uint32_t>(page.height),
            .bits = bitsOf(page.type),
            .floats = page.type == NumberType::Float,
            .reduced = page.level > 0,
            .tiled = true,
            .description = levelPage(layout, page),
            .offsets = {}};
}

TiffPage tiffChecksums(const TiledLayout& layout, std::uint64_t checksum) {
    return {.width = TiledLayout::kChecksumWidth,
            .height = static_cast<std::uint32_t>(layout.checksumHeight()),
            .bits = 32,
            .floats = false,
            .reduced = false,
            .tiled = false,
            .description = checksumPage(layout, checksum),
            .offsets = {layout.checksums}};
}

std::vector<TiffPage> tiffPages(const TiledLayout& layout, std::uint64_t checksum) {
    std::vector<TiffPage> pages;
    for (const TilePage& page : layout.pages) {
        TiffPage& tiff = pages.emplace_back(tiffPage(layout, page));
        tiff.offsets.reserve(static_cast<std::size_t>(page.tilesAcross()) * static_cast<std::size_t>(page.tilesDown()));
        for (int y = 0; y < page.tilesDown(); ++y) {
            for (int x = 0; x < page.tilesAcross(); ++x) tiff.offsets.push_back(page.tileOffset(x, y));
        }
    }
    pages.push_back(tiffChecksums(layout, checksum));
    return pages;
}

std::optional<NumberType> typeOf(const TiffPage& page) {
    for (const NumberType type : {NumberType::UInt8, NumberType::UInt16, NumberType::Float}) {
        if (page.bits == bitsOf(type) && page.floats == (type == NumberType::Float)) return type;
    }
    return std::nullopt;
}

Json described(const TiffPage& page) {
    Json json = Json::parse(page.description, nullptr, false);
    const bool ours = json.is_object() && json.value("format", Json()) == kFormat &&
                      json.value("version", Json()) == kTiledFileVersion;
    return ours ? json : Json::object();
}

// Returns true if the value of this name is this text; it may be missing or of another kind.
bool says(const Json& json, const char* name, const char* text) {
    return json.value(name, Json()) == text;
}

// Returns true if the page is that of the layout. Its text may be worded otherwise.
bool isPage(const TiffDirectories::Found& found, const TiledLayout& layout, const TilePage& page) {
    const Json json = described(found.page);
    const auto tiles = static_cast<std::uint64_t>(page.tilesAcross()) * static_cast<std::uint64_t>(page.tilesDown());
    TiffPage expected = tiffPage(layout, page);
    expected.description = found.page.description;
    expected.offsets = {page.first, page.tileOffset(page.tilesAcross() - 1, page.tilesDown() - 1)};
    return found.page == expected && found.tiles == tiles && says(json, "kind", tileKindName(page.kind)) &&
           json.value("level", Json()) == page.level;
}

std::optional<std::uint64_t> checksumOf(const TiffDirectories::Found& found, const TiledLayout& layout) {
    const Json json = described(found.page);
    TiffPage expected = tiffChecksums(layout, 0);
    expected.description = found.page.description;
    expected.offsets.push_back(layout.checksums);
    const Json value = json.value("checksum", Json());
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    std::uint64_t checksum = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), checksum, 16);
    if (found.page != expected || !says(json, "kind", kChecksumKind) || text.size() != kHexDigits ||
        error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return checksum;
}

}  // namespace

const char* tileKindName(TileKind kind) {
    switch (kind) {
        case TileKind::Max:
            return "max";
        case TileKind::Min:
            return "min";
        case TileKind::Mean:
            return "mean";
        case TileKind::Height:
            break;
    }
    return "height";
}

Json pyramidPage(int version, TileKind kind, int level, int levels, std::pair<int, int> size,
                 std::pair<int, int> field) {
    const std::string side = std::to_string(std::int64_t{1} << level);
    const std::string what = std::string(tileKindName(kind)) + (kind == TileKind::Mean ? "" : "imum");
    const std::string texels = level == 0 ? "texel (i, j) is the height at its centre (i + 1/2, j + 1/2); rows top-down"
                                          : "texel (i, j) is the " + what + " of the " + side + " x " + side +
                                                " heights of level 0 that begin at (" + side + " i, " + side +
                                                " j), or of those that exist in the last column and row; rows top-down";
    return {{"format", kFormat},
            {"version", version},
            {"kind", tileKindName(kind)},
            {"level", level},
            {"levels", levels},
            {"size", {size.first, size.second}},
            {"field", {field.first, field.second}},
            {"unit", "height, share of the slab: 0 its bottom, 1 the polygon"},
            {"texels", texels}};
}

TiledLayout tiledLayout(int width, int height, NumberType type) {
    // The head's size does not depend on where the tiles begin.
    const std::size_t head = tiffHeadBytes(tiffPages(TiledLayout::of(width, height, type, 0), 0));
    return TiledLayout::of(width, height, type, (head + kGroupBytes - 1) / kGroupBytes * kGroupBytes);
}

std::vector<std::byte> tiledHead(const TiledLayout& layout, std::uint64_t checksum) {
    return tiffHead(tiffPages(layout, checksum));
}

std::optional<TiledHead> readTiledHead(int descriptor) {
    TiffDirectories directories(descriptor);
    auto found = directories.next();
    if (!found) return std::nullopt;
    const auto type = typeOf(found->page);
    const std::uint64_t first = found->page.offsets.front();
    if (!type || first % kGroupBytes != 0 || first > INT64_MAX / 2 || found->page.width < 1 || found->page.height < 1 ||
        std::max(found->page.width, found->page.height) > kMostTiledSide)
        return std::nullopt;
    TiledHead head;
    head.layout =
        TiledLayout::of(static_cast<int>(found->page.width), static_cast<int>(found->page.height), *type, first);
    for (const TilePage& page : head.layout.pages) {
        if (page.level > 0) found = directories.next();
        if (!found || !isPage(*found, head.layout, page)) return std::nullopt;
    }
    found = directories.next();
    const auto checksum = found ? checksumOf(*found, head.layout) : std::nullopt;
    if (!checksum) return std::nullopt;
    head.checksum = *checksum;
    return head;
}

bool beginsTiled(int descriptor) {
    const auto found = TiffDirectories(descriptor).next();
    return found && says(described(found->page), "kind", tileKindName(TileKind::Height));
}

}  // namespace relief
