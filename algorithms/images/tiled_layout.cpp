#include "images/tiled_layout.h"

#include <array>
#include <bit>

#include "images/pyramid.h"

namespace relief {

static_assert(std::endian::native == std::endian::little, "tiles are mapped as they stand in the file");

std::pair<int, int> TilePage::tileAt(std::uint64_t offset) const {
    const auto across = static_cast<std::uint64_t>(groupsAcross);
    const std::uint64_t group = (offset - first) >> kGroupShift;
    const auto within = static_cast<int>((offset - first) % kGroupBytes >> tileBytesShift);
    return {(static_cast<int>(group % across) << acrossShift) + (within & ((1 << acrossShift) - 1)),
            (static_cast<int>(group / across) << downShift) + (within >> acrossShift)};
}

TiledLayout TiledLayout::of(int width, int height, NumberType type, std::uint64_t firstTile) {
    assert(type == NumberType::UInt8 || type == NumberType::UInt16 || type == NumberType::Float);
    assert(firstTile % kGroupBytes == 0);
    TiledLayout layout;
    layout.width = width;
    layout.height = height;
    layout.levels = Pyramid::levelCount(width, height);
    layout.type = type;
    layout.firstTile = firstTile;
    std::uint64_t at = firstTile;
    const auto add = [&](TileKind kind, int level) {
        TilePage page;
        page.kind = kind;
        page.type = kind == TileKind::Mean ? NumberType::Float : type;
        page.level = level;
        page.width = ((width - 1) >> level) + 1;
        page.height = ((height - 1) >> level) + 1;
        const int bytesShift = page.type == NumberType::UInt8 ? 0 : page.type == NumberType::UInt16 ? 1 : 2;
        page.tileBytesShift = 2 * kTileShift + bytesShift;
        page.acrossShift = bytesShift == 2 ? 1 : 2;
        page.downShift = bytesShift == 0 ? 2 : 1;
        page.groupsAcross = ((page.tilesAcross() - 1) >> page.acrossShift) + 1;
        page.groupsDown = ((page.tilesDown() - 1) >> page.downShift) + 1;
        page.first = at;
        page.firstPlace = layout.places;
        at += page.bytes();
        layout.places += page.places();
        layout.pages.push_back(page);
    };
    add(TileKind::Height, 0);
    for (const TileKind kind : {TileKind::Max, TileKind::Min, TileKind::Mean}) {
        for (int level = 1; level < layout.levels; ++level) add(kind, level);
    }
    layout.checksums = at;
    layout.fileBytes = at + layout.checksumBytes();
    return layout;
}

std::uint64_t tileChecksum(const std::byte* data, std::size_t bytes) {
    // FNV-1a on four interleaved sequences of 64-bit words, so that a processor can work on all four at a time; the
    // rotation lets the high bits of a word reach the low bits of the sum.
    constexpr std::uint64_t kPrime = 0x100000001b3, kBasis = 0xcbf29ce484222325;
    constexpr int kRotation = 29;
    std::array<std::uint64_t, 4> sums{kBasis, kBasis + 1, kBasis + 2, kBasis + 3};
    assert(bytes % sizeof sums == 0);
    for (std::size_t at = 0; at < bytes; at += sizeof sums) {
        std::array<std::uint64_t, 4> words{};
        std::memcpy(words.data(), data + at, sizeof words);
        for (std::size_t i = 0; i < words.size(); ++i) sums[i] = std::rotl(sums[i] ^ words[i], kRotation) * kPrime;
    }
    std::uint64_t sum = kBasis;
    for (const std::uint64_t one : sums) sum = std::rotl(sum ^ one, kRotation) * kPrime;
    return sum;
}

}  // namespace relief
