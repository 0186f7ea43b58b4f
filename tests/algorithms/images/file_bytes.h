// Files assembled byte by byte, valid and invalid ones. The data of PNG files are stored without compression.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace relief::testing {

inline std::string bigEndian(std::uint32_t value) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(static_cast<unsigned char>(value >> shift));
    return bytes;
}

inline std::string littleEndian(std::uint64_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
    return out;
}

inline std::string pngChunk(const std::string& type, const std::string& data) {
    std::uint32_t crc = 0xffffffffU;
    for (const char c : type + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? 0xedb88320U ^ (crc >> 1) : crc >> 1;
    }
    return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian(~crc);
}

// Returns a zlib stream of one stored block; the data must be shorter than 64 kB.
inline std::string stored(const std::string& data) {
    std::uint32_t a = 1, b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = static_cast<std::uint32_t>(data.size());
    return "\x78\x01\x01" + littleEndian(size, 2) + littleEndian(~size & 0xffffU, 2) + data + bigEndian(b << 16 | a);
}

inline const std::string kPngSignature = "\x89PNG\r\n\x1a\n";

inline std::string pngHeader(std::uint32_t width, std::uint32_t height, int bits, int colorType) {
    using namespace std::string_literals;
    return pngChunk("IHDR", bigEndian(width) + bigEndian(height) + static_cast<char>(bits) +
                                static_cast<char>(colorType) + "\0\0\0"s);
}

// rows: the rows as PNG filters them, each preceded by its filter byte. extra: chunks between the header and the data.
inline std::string png(std::uint32_t width, std::uint32_t height, int bits, int colorType, const std::string& rows,
                       const std::string& extra = {}) {
    return kPngSignature + pngHeader(width, height, bits, colorType) + extra + pngChunk("IDAT", stored(rows)) +
           pngChunk("IEND", {});
}

// Returns an entry of a little-endian TIFF directory. type: 3 for 16 bits, 4 for 32.
inline std::string tiffEntry(std::uint32_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
    return littleEndian(tag, 2) + littleEndian(type, 2) + littleEndian(count, 4) + littleEndian(value, 4);
}

}  // namespace relief::testing
