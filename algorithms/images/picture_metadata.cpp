#include <algorithm>
#include <array>
#include <cstddef>

#include "images/picture_bytes.h"

namespace relief {

namespace {

// Access to a TIFF file's integers in its own byte order. Reads beyond the end give 0. Byte: const or not.
template <class Byte>
class TiffFile {
  public:
    explicit TiffFile(std::span<Byte> bytes) : bytes_(bytes), little_(bytes.size() > 1 && bytes[0] == 'I') {
        big_ = get(2, 2) == 43;
    }

    std::uint64_t get(std::uint64_t at, unsigned count) const {
        std::uint64_t value = 0;
        if (!inside(at, count)) return 0;
        for (unsigned i = 0; i < count; ++i) value = value << 8 | bytes_[index(at, i, count)];
        return value;
    }
    // Writes a number of a directory entry, which must lie inside the file.
    void set(std::uint64_t at, unsigned count, std::uint64_t value) {
        for (unsigned i = count; i-- > 0; value >>= 8) bytes_[index(at, i, count)] = static_cast<unsigned char>(value);
    }
    bool big() const { return big_; }

    // Calls visit(offset of the entry, its tag) for each entry of the first directory that lies inside the file.
    template <class Visit>
    void forEntries(const Visit& visit) const {
        const std::uint64_t directory = big_ ? get(8, 8) : get(4, 4);
        // libtiff reads no directory with more entries.
        const std::uint64_t count = std::min<std::uint64_t>(get(directory, big_ ? 8 : 2), UINT16_MAX);
        const std::uint64_t size = big_ ? 20 : 12;
        std::uint64_t entry = directory + (big_ ? 8 : 2);
        for (std::uint64_t i = 0; i < count && inside(entry, size); ++i, entry += size) visit(entry, get(entry, 2));
    }

  private:
    bool inside(std::uint64_t at, std::uint64_t count) const {
        return at <= bytes_.size() && count <= bytes_.size() - at;
    }
    // Offset of the i-th most significant byte of a number of `count` bytes.
    std::size_t index(std::uint64_t at, unsigned i, unsigned count) const {
        return static_cast<std::size_t>(at + (little_ ? count - 1 - i : i));
    }

    std::span<Byte> bytes_;
    bool little_;
    bool big_ = false;
};

// XMP, IPTC, Photoshop, EXIF, colour profile, GPS.
constexpr std::array<std::uint64_t, 6> kTiffMetadata{700, 33723, 34377, 34665, 34675, 34853};

}  // namespace

Bytes cleanJpeg(std::span<const unsigned char> file) {
    const auto at = [&](std::size_t i) { return file.begin() + static_cast<std::ptrdiff_t>(i); };
    Bytes clean;
    clean.reserve(file.size());
    std::size_t done = 2;  // skips the start-of-image marker
    clean.insert(clean.end(), file.begin(), at(std::min(done, file.size())));
    // Each segment up to start of scan is 0xff, the marker, the length of itself and the data, and the data.
    while (done + 4 <= file.size() && file[done] == 0xff && file[done + 1] != 0xda) {
        const unsigned marker = file[done + 1];
        const std::size_t length = 2 + (std::size_t{file[done + 2]} << 8 | file[done + 3]);
        if (length > file.size() - done) break;
        // Adobe's segment (0xee) specifies the colour transform and JFIF's (0xe0) the density, so both stay; comments
        // (0xfe) go.
        const bool metadata = (marker >= 0xe1 && marker <= 0xef && marker != 0xee) || marker == 0xfe;
        if (!metadata) clean.insert(clean.end(), at(done), at(done + length));
        done += length;
    }
    clean.insert(clean.end(), at(std::min(done, file.size())), file.end());
    return clean;
}

void hideTiffMetadata(std::span<unsigned char> file) {
    TiffFile<unsigned char> tiff(file);
    std::uint64_t hidden = 0;
    tiff.forEntries([&](std::uint64_t entry, std::uint64_t tag) {
        if (std::find(kTiffMetadata.begin(), kTiffMetadata.end(), tag) == kTiffMetadata.end()) return;
        // Replaces the tag by an unknown private one with a single byte of data.
        tiff.set(entry, 2, 65280 + hidden++ % 256);
        tiff.set(entry + 2, 2, 1);
        tiff.set(entry + 4, tiff.big() ? 8 : 4, 1);
    });
}

std::pair<std::uint64_t, std::uint64_t> tiffDirectory(std::span<const unsigned char> file) {
    std::uint64_t first = 0, last = 0;
    TiffFile<const unsigned char>(file).forEntries([&](std::uint64_t entry, std::uint64_t) {
        if (last == 0) first = entry;
        last = entry;
    });
    constexpr std::uint64_t kMostEntryBytes = 20;
    return {first, last == 0 ? 0 : std::min<std::uint64_t>(last + kMostEntryBytes, file.size())};
}

std::uint64_t tiffDepth(std::span<const unsigned char> file) {
    constexpr std::uint64_t kImageDepth = 32997;
    const TiffFile<const unsigned char> tiff(file);
    std::uint64_t depth = 1;
    tiff.forEntries([&](std::uint64_t entry, std::uint64_t tag) {
        if (tag != kImageDepth) return;
        const bool isShort = tiff.get(entry + 2, 2) == 3;
        depth = tiff.get(entry + (tiff.big() ? 12 : 8), isShort ? 2 : 4);
    });
    return std::max<std::uint64_t>(1, depth);
}

}  // namespace relief
