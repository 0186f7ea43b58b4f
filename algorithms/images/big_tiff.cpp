#include "images/big_tiff.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>

#include "images/file_descriptor.h"
#include "images/tiled_layout.h"

namespace relief {

namespace {

// Numbers of the TIFF specification.
enum Tag : std::uint16_t {
    kNewSubfileType = 254,
    kImageWidth = 256,
    kImageLength = 257,
    kBitsPerSample = 258,
    kCompression = 259,
    kPhotometric = 262,
    kImageDescription = 270,
    kStripOffsets = 273,
    kSamplesPerPixel = 277,
    kRowsPerStrip = 278,
    kStripByteCounts = 279,
    kPlanarConfiguration = 284,
    kTileWidth = 322,
    kTileLength = 323,
    kTileOffsets = 324,
    kTileByteCounts = 325,
    kSampleFormat = 339,
};
enum Type : std::uint16_t { kAscii = 2, kShort = 3, kLong = 4, kLong8 = 16 };
constexpr std::uint64_t kNoCompression = 1, kBlackIsZero = 1, kRgb = 2, kInterleaved = 1, kUnsigned = 1, kFloats = 3;

// "II" for little-endian, BigTIFF, bytes of an offset, 0.
constexpr std::array<std::uint16_t, 4> kSignature{0x4949, 43, 8, 0};
constexpr std::array<std::uint16_t, 2> kClassicSignature{0x4949, 42};
constexpr std::size_t kHeader = 16, kEntry = 20, kInline = 8;  // bytes
constexpr std::size_t kTiledEntries = 14, kStripEntries = 13;  // of a directory that tiffHead() writes
constexpr std::uint64_t kMostEntries = 64;                     // of a directory that is read
constexpr std::size_t kMostDescription = 1 << 16;              // bytes

std::size_t sizeOf(std::uint16_t type) {
    return type == kAscii ? 1 : type == kShort ? 2 : type == kLong ? 4 : type == kLong8 ? 8 : 0;
}

std::size_t aligned(std::size_t bytes) {
    return (bytes + 7) / 8 * 8;
}

// Sizes in bytes. number: size of an offset, of a count and of the value field of an entry.
struct FormSizes {
    std::size_t header, entries, entry, number;

    std::size_t directory() const { return aligned(entries + kTiledEntries * entry + number); }
    // Bytes of an array that does not fit into its entry.
    std::size_t outside(std::size_t count, std::size_t size) const {
        return count * size <= number ? 0 : aligned(count * size);
    }
    // Bytes of the page's arrays that stand behind all directories (the description follows its own directory).
    std::size_t arrays(const TiffPage& page) const {
        const std::size_t count = page.offsets.size();
        return 2 * outside(static_cast<std::size_t>(page.channels), 2) + outside(count, number) +
               (page.tiled ? outside(count, 4) : 0);
    }
};
constexpr FormSizes kBig{kHeader, 8, kEntry, kInline}, kClassic{8, 2, 12, 4};

const FormSizes& sizesOf(TiffForm form) {
    return form == TiffForm::Big ? kBig : kClassic;
}

class HeadWriter {
  public:
    HeadWriter(std::size_t bytes, const FormSizes& sizes) : bytes_(bytes), sizes_(sizes) {}

    template <class Number>
    void put(std::uint64_t at, Number number) {
        std::memcpy(bytes_.data() + at, &number, sizeof number);
    }
    // Writes a number of the form's size.
    void sized(std::uint64_t at, std::uint64_t number) { std::memcpy(bytes_.data() + at, &number, sizes_.number); }
    void begin(std::uint64_t directory, std::size_t entries) {
        put(directory, static_cast<std::uint16_t>(entries));  // below 2^16 in both forms; the rest is 0
        entry_ = directory + sizes_.entries;
    }
    void number(std::uint16_t tag, std::uint16_t type, std::uint64_t value) { sized(head(tag, type, 1), value); }
    // Writes an array whose numbers are given by of(i): into the entry, or at `at`, which it moves behind it.
    template <class Number, class Of>
    void array(std::uint16_t tag, std::uint16_t type, std::size_t count, std::uint64_t& at, const Of& of) {
        const std::uint64_t value = head(tag, type, count);
        const std::size_t beyond = sizes_.outside(count, sizeof(Number));
        const std::uint64_t to = beyond == 0 ? value : at;
        if (beyond != 0) sized(value, at);
        for (std::size_t i = 0; i < count; ++i) put(to + i * sizeof(Number), static_cast<Number>(of(i)));
        at += beyond;
    }
    // The offset of the next directory.
    void end(std::uint64_t next) { sized(entry_, next); }
    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    // Returns the place of the entry's value.
    std::uint64_t head(std::uint16_t tag, std::uint16_t type, std::uint64_t count) {
        put(entry_, tag);
        put(entry_ + 2, type);
        sized(entry_ + 4, count);
        return std::exchange(entry_, entry_ + sizes_.entry) + 4 + sizes_.number;
    }

    std::vector<std::byte> bytes_;
    const FormSizes& sizes_;
    std::uint64_t entry_ = 0;
};

}  // namespace

std::size_t tiffHeadBytes(const std::vector<TiffPage>& pages, TiffForm form) {
    const FormSizes& sizes = sizesOf(form);
    std::size_t bytes = sizes.header;
    for (const TiffPage& page : pages)
        bytes += sizes.directory() + sizes.outside(page.description.size() + 1, 1) + sizes.arrays(page);
    return bytes;
}

std::vector<std::byte> tiffHead(const std::vector<TiffPage>& pages, TiffForm form) {
    const FormSizes& sizes = sizesOf(form);
    const bool big = form == TiffForm::Big;
    HeadWriter head(tiffHeadBytes(pages, form), sizes);
    if (big)
        head.put(0, kSignature);
    else
        head.put(0, kClassicSignature);
    head.sized(sizes.header - sizes.number, sizes.header);
    // Directories with their descriptions come first, so that a reader finds them all at the beginning.
    std::uint64_t directory = sizes.header, arrays = sizes.header;
    for (const TiffPage& page : pages) arrays += sizes.directory() + sizes.outside(page.description.size() + 1, 1);
    const std::uint16_t offsets = big ? kLong8 : kLong;
    for (std::size_t p = 0; p < pages.size(); ++p) {
        const TiffPage& page = pages[p];
        assert(big || page.tiled);
        const auto channels = static_cast<std::size_t>(page.channels);
        const std::uint64_t bytes = static_cast<std::uint64_t>(page.bits) / 8 * channels;
        std::uint64_t text = directory + sizes.directory();
        head.begin(directory, page.tiled ? kTiledEntries : kStripEntries);
        head.number(kNewSubfileType, kLong, page.reduced ? 1 : 0);
        head.number(kImageWidth, kLong, page.width);
        head.number(kImageLength, kLong, page.height);
        head.array<std::uint16_t>(kBitsPerSample, kShort, channels, arrays, [&](std::size_t) { return page.bits; });
        head.number(kCompression, kShort, kNoCompression);
        head.number(kPhotometric, kShort, channels == 1 ? kBlackIsZero : kRgb);
        head.array<char>(kImageDescription, kAscii, page.description.size() + 1, text,
                         [&](std::size_t i) { return page.description.c_str()[i]; });
        const auto offset = [&](std::size_t i) { return page.offsets[i]; };
        if (!page.tiled) head.array<std::uint64_t>(kStripOffsets, kLong8, 1, arrays, offset);
        head.number(kSamplesPerPixel, kShort, channels);
        if (!page.tiled) {
            head.number(kRowsPerStrip, kLong, page.height);
            head.number(kStripByteCounts, kLong8, std::uint64_t{page.width} * page.height * bytes);
        }
        head.number(kPlanarConfiguration, kShort, kInterleaved);
        if (page.tiled) {
            head.number(kTileWidth, kShort, kTileSide);
            head.number(kTileLength, kShort, kTileSide);
            if (big)
                head.array<std::uint64_t>(kTileOffsets, offsets, page.offsets.size(), arrays, offset);
            else
                head.array<std::uint32_t>(kTileOffsets, offsets, page.offsets.size(), arrays, offset);
            head.array<std::uint32_t>(kTileByteCounts, kLong, page.offsets.size(), arrays,
                                      [&](std::size_t) { return kTileTexels * bytes; });
        }
        head.array<std::uint16_t>(kSampleFormat, kShort, channels, arrays,
                                  [&](std::size_t) { return page.floats ? kFloats : kUnsigned; });
        directory = text;
        head.end(p + 1 < pages.size() ? directory : 0);
    }
    return head.take();
}

struct TiffDirectories::Entry {
    std::uint16_t tag = 0, type = 0;
    std::uint64_t count = 0;
    std::array<std::byte, kInline> value{};

    // The first number; arrays that do not fit into the entry have none.
    std::uint64_t number() const {
        const std::size_t size = sizeOf(type);
        std::uint64_t number = 0;
        if (count >= 1 && size >= 1 && count <= kInline / size) std::memcpy(&number, value.data(), size);
        return number;
    }
};

TiffDirectories::TiffDirectories(int descriptor) : descriptor_(descriptor) {
    std::array<std::uint16_t, 4> signature{};
    std::uint64_t first = 0;
    const bool big = read(0, signature.data(), sizeof signature) && signature == kSignature;
    if (big && read(8, &first, sizeof first)) next_ = first;
}

bool TiffDirectories::read(std::uint64_t at, void* to, std::size_t count) const {
    // The offset may be anything.
    return readAt(descriptor_, static_cast<std::int64_t>(at), to, count) == static_cast<::ssize_t>(count);
}

// Returns false if the entry says that the page is not such as tiffHead() writes.
bool TiffDirectories::take(const Entry& entry, Found& found) const {
    TiffPage& page = found.page;
    const std::uint64_t number = entry.number();
    // The number of element i of an array of offsets.
    const auto offset = [&](std::uint64_t i) {
        if (entry.count == 1) return number;
        std::uint64_t at = 0, value = 0;
        std::memcpy(&at, entry.value.data(), sizeof at);
        return read(at + i * sizeof value, &value, sizeof value) ? value : 0;
    };
    switch (entry.tag) {
        case kNewSubfileType:
            page.reduced = (number & 1) != 0;
            return true;
        case kImageWidth:
            page.width = static_cast<std::uint32_t>(number);
            return number <= UINT32_MAX;
        case kImageLength:
            page.height = static_cast<std::uint32_t>(number);
            return number <= UINT32_MAX;
        case kBitsPerSample:
            page.bits = static_cast<int>(std::min<std::uint64_t>(number, 64));
            return entry.count == 1;
        case kCompression:
            return number == kNoCompression;
        case kSamplesPerPixel:
            return number == 1;
        case kTileWidth:
        case kTileLength:
            return number == kTileSide;
        case kSampleFormat:
            page.floats = number == kFloats;
            return number == kFloats || number == kUnsigned;
        case kImageDescription: {
            if (entry.type != kAscii || entry.count < 1 || entry.count > kMostDescription) return false;
            page.description.resize(entry.count - 1);
            if (entry.count <= kInline) {
                std::memcpy(page.description.data(), entry.value.data(), page.description.size());
                return true;
            }
            std::uint64_t at = 0;
            std::memcpy(&at, entry.value.data(), sizeof at);
            return read(at, page.description.data(), page.description.size());
        }
        case kStripOffsets:
        case kTileOffsets:
            if (entry.type != kLong8 || entry.count < 1 || entry.count > UINT32_MAX) return false;
            page.tiled = entry.tag == kTileOffsets;
            found.tiles = entry.count;
            page.offsets = {offset(0), offset(entry.count - 1)};
            return true;
        default:
            return true;
    }
}

std::optional<TiffDirectories::Found> TiffDirectories::next() {
    std::uint64_t count = 0;
    if (next_ == 0 || !read(next_, &count, sizeof count) || count > kMostEntries) return std::nullopt;
    std::vector<std::byte> bytes(count * kEntry + 8);
    if (!read(next_ + 8, bytes.data(), bytes.size())) return std::nullopt;
    Found found;
    found.page.bits = 1;  // what TIFF supposes where an entry is missing
    for (std::size_t i = 0; i < count; ++i) {
        const std::byte* const at = bytes.data() + i * kEntry;
        Entry entry;
        std::memcpy(&entry.tag, at, 2);
        std::memcpy(&entry.type, at + 2, 2);
        std::memcpy(&entry.count, at + 4, 8);
        std::memcpy(entry.value.data(), at + 12, kInline);
        if (!take(entry, found)) return std::nullopt;
    }
    std::memcpy(&next_, bytes.data() + count * kEntry, sizeof next_);
    if (found.page.offsets.empty()) return std::nullopt;
    return found;
}

}  // namespace relief
