// Checks on the bytes of a picture file before any image library reads it: its format by signature, its declared size
// where a library would allocate before reporting it, and the validity of PNG files. Does not use OpenImageIO.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace relief {

using Bytes = std::vector<unsigned char>;

// OpenImageIO's name of the format ("png", "jpeg", ...), empty if the signature is unknown. The first 32 bytes are
// enough.
std::string_view formatBySignature(std::span<const unsigned char> head);

struct DeclaredSize {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
};

// The size declared in the header, for the formats that OpenImageIO decodes (and allocates for) when opening:
// "jpeg2000", "gif", "png". std::nullopt for other formats or if the header is truncated. The first 64 kB are enough.
std::optional<DeclaredSize> declaredSize(std::string_view format, std::span<const unsigned char> head);

// Verifies every checksum of a PNG file and returns the file reduced to the chunks that its pixels need, a band's
// text (writeColor()), and the description of a map of this program. std::nullopt if it is damaged or truncated:
// libpng would report that on stderr. Cost: one pass over the bytes, about 1 GB/s.
std::optional<Bytes> cleanPng(std::span<const unsigned char> file);

// Returns the file without metadata that the pixels do not need (colour profiles, EXIF, IPTC, XMP): OpenImageIO 2.4
// follows offsets in damaged profiles out of memory. What is not valid JPEG is copied unchanged, for the library to
// refuse.
Bytes cleanJpeg(std::span<const unsigned char> file);
// Hides such metadata in place, in the first directory only (others are not read); the file keeps its length.
void hideTiffMetadata(std::span<unsigned char> file);

// Bytes [first, second) of the first directory, all that hideTiffMetadata() changes; an empty range if there is none.
std::pair<std::uint64_t, std::uint64_t> tiffDirectory(std::span<const unsigned char> file);

// Number of layers of a TIFF volume, of which OpenImageIO would silently read only the first; 1 for a picture.
std::uint64_t tiffDepth(std::span<const unsigned char> file);

}  // namespace relief
