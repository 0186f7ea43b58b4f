// What the first bytes of a picture file say, before any library is let loose on it: the format by its signature, the
// declared size where a library would allocate before telling it, and PNG checked through. Knows no OpenImageIO.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace relief {

using Bytes = std::vector<unsigned char>;

// OpenImageIO's name of the format ("png", "jpeg", ...), or empty if no signature is known. Some 32 bytes are enough.
std::string_view formatBySignature(std::span<const unsigned char> head);

struct DeclaredSize {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
};

// Size that the header declares, for the formats that OpenImageIO decodes (and allocates) already on opening:
// "jpeg2000", "gif", "png". Nothing for other formats or if the header is cut short. The first 64 kB are enough.
std::optional<DeclaredSize> declaredSize(std::string_view format, std::span<const unsigned char> head);

// A PNG file with every checksum verified, reduced to what its pixels need, and a band's text (PictureBand). libpng
// tells its errors to stderr, so what is damaged or cut short is refused here: nothing is returned. Cost: one pass over
// the bytes, about 1 GB/s.
std::optional<Bytes> cleanPng(std::span<const unsigned char> file);

// Metadata that the pixels do not need (colour profiles, EXIF, IPTC, XMP) taken out: OpenImageIO 2.4 follows offsets in
// damaged profiles out of memory. What does not look like the format is left as it is, for its library to refuse.
Bytes cleanJpeg(std::span<const unsigned char> file);
// In place, in the first directory (others are not read); the file keeps its length.
void hideTiffMetadata(std::span<unsigned char> file);

// Layers of a TIFF volume, of which OpenImageIO would show the first and say nothing; 1 for a picture.
std::uint64_t tiffDepth(std::span<const unsigned char> file);

}  // namespace relief
