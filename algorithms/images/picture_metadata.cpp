#include <algorithm>
#include <array>
#include <cstddef>

#include "images/picture_bytes.h"

namespace relief {

namespace {

// Numbers of a TIFF file in its byte order; 0 beyond its end.
class TiffNumbers {
  public:
    explicit TiffNumbers(std::span<unsigned char> bytes)
        : bytes_(bytes), little_(bytes.size() > 1 && bytes[0] == 'I') {}

    std::uint64_t get(std::uint64_t at, unsigned count) const {
        std::uint64_t value = 0;
        if (!inside(at, count)) return 0;
        for (unsigned i = 0; i < count; ++i) value = value << 8 | bytes_[index(at, i, count)];
        return value;
    }
    void set(std::uint64_t at, unsigned count, std::uint64_t value) {
        if (!inside(at, count)) return;
        for (unsigned i = count; i-- > 0; value >>= 8) bytes_[index(at, i, count)] = static_cast<unsigned char>(value);
    }
    bool inside(std::uint64_t at, std::uint64_t count) const {
        return at <= bytes_.size() && count <= bytes_.size() - at;
    }

  private:
    // The i-th most significant byte of `count`.
    std::size_t index(std::uint64_t at, unsigned i, unsigned count) const {
        return static_cast<std::size_t>(at + (little_ ? count - 1 - i : i));
    }

    std::span<unsigned char> bytes_;
    bool little_;
};

// XMP, IPTC, Photoshop, EXIF, colour profile, GPS.
constexpr std::array<std::uint64_t, 6> kTiffMetadata{700, 33723, 34377, 34665, 34675, 34853};

}  // namespace

Bytes cleanJpeg(std::span<const unsigned char> file) {
    const auto at = [&](std::size_t i) { return file.begin() + static_cast<std::ptrdiff_t>(i); };
    Bytes clean;
    clean.reserve(file.size());
    std::size_t done = 2;  // after the start of image
    clean.insert(clean.end(), file.begin(), at(std::min(done, file.size())));
    // Segments follow each other up to the start of scan: 0xff, marker, length of itself and the data.
    while (done + 4 <= file.size() && file[done] == 0xff && file[done + 1] != 0xda) {
        const unsigned marker = file[done + 1];
        const std::size_t length = 2 + (std::size_t{file[done + 2]} << 8 | file[done + 3]);
        if (length > file.size() - done) break;
        // Adobe's own (0xee) tells the colour transform, JFIF (0xe0) the density; a comment (0xfe) nothing.
        const bool metadata = (marker >= 0xe1 && marker <= 0xef && marker != 0xee) || marker == 0xfe;
        if (!metadata) clean.insert(clean.end(), at(done), at(done + length));
        done += length;
    }
    clean.insert(clean.end(), at(std::min(done, file.size())), file.end());
    return clean;
}

void hideTiffMetadata(std::span<unsigned char> file) {
    TiffNumbers numbers(file);
    const bool big = numbers.get(2, 2) == 43;
    const std::uint64_t directory = big ? numbers.get(8, 8) : numbers.get(4, 4);
    const unsigned countBytes = big ? 8 : 2;
    const std::uint64_t entryBytes = big ? 20 : 12;
    const std::uint64_t count = std::min<std::uint64_t>(numbers.get(directory, countBytes), 65535);
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t entry = directory + countBytes + i * entryBytes;
        if (!numbers.inside(entry, entryBytes)) return;
        if (std::find(kTiffMetadata.begin(), kTiffMetadata.end(), numbers.get(entry, 2)) == kTiffMetadata.end())
            continue;
        // One byte of a private tag that nobody knows.
        numbers.set(entry, 2, 65280 + i % 256);
        numbers.set(entry + 2, 2, 1);
        numbers.set(entry + 4, big ? 8 : 4, 1);
    }
}

}  // namespace relief
